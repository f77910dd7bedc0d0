"""Order in which schedules trigger operators, and cycles of data (paper, section II-D)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from itertools import count

from kinlint.facts.fact_statements import MEMBER, derived, fact, fact_node, integer
from kinlint.facts.metamodel_terms import algorithm, kin
from kinlint.facts.predicate_index import REST, PredicateIndex, Table
from kinlint.facts.strongly_connected import strongly_connected_components
from kinlint.terms import Term, Triple


def steps(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the steps of each schedule, counted from zero."""
    numbers = count(1)
    for schedule, heads in sorted(scan.table(algorithm("trigger-chain")).items()):
        lists = {items for head in heads if (items := scan.items(head)) is not None}
        if len(lists) != 1:
            continue
        for index, operator in enumerate(lists.pop()):
            step = fact_node("step", next(numbers))
            yield schedule, fact("step"), step
            yield step, fact("index"), integer(index)
            yield step, fact("operator"), operator
            yield from derived(step, [schedule])


def reordered(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the cells of each schedule that get another operator to run after its feeds.

    Operators that do not wait for others stay in the order that they have. There is no such order
    where operators feed each other in a circle; it leaves a choice where an operator is triggered
    twice, or where several of a schedule write the same.
    """
    reads, writes = (scan.table(kin(name)) for name in ("reads", "writes"))
    numbers = count(1)
    for schedule, heads in sorted(scan.table(algorithm("trigger-chain")).items()):
        operators = scan.items(heads[0]) if len(heads) == 1 else None
        if operators is None or len(set(operators)) < len(operators):
            continue
        written = [datum for each in operators for datum in writes.values(each)]
        if len(set(written)) < len(written):
            continue
        cell = heads[0]
        for old, new in zip(operators, _in_order(operators, reads, writes), strict=False):
            if old != new:
                move = fact_node("move", next(numbers))
                yield schedule, fact("reordered"), move
                yield move, fact("cell"), cell
                yield move, fact("due"), new
            cell = scan.single(REST)[cell]


def _in_order(operators: Sequence[Term], reads: Table, writes: Table) -> list[Term]:
    """*operators* after those that feed them, else as they come; empty if some feed each other."""
    producer = {datum: at for at, each in enumerate(operators) for datum in writes.values(each)}
    after: dict[int, list[int]] = {}
    waiting = [0] * len(operators)
    for at, operator in enumerate(operators):
        for source in {producer[datum] for datum in reads.values(operator) if datum in producer} - {
            at
        }:
            after.setdefault(source, []).append(at)
            waiting[at] += 1
    ready = [at for at, many in enumerate(waiting) if not many]
    heapify(ready)
    found: list[Term] = []
    while ready:
        at = heappop(ready)
        found.append(operators[at])
        for other in after.get(at, ()):
            waiting[other] -= 1
            if not waiting[other]:
                heappush(ready, other)
    return found if len(found) == len(operators) else []


def data_cycles(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the operators that need, directly or through others, what they write themselves."""
    reads, writes = (dict(scan.table(kin(name)).items()) for name in ("reads", "writes"))
    if not reads or not writes:
        return
    arcs = _arcs(reads, writes)
    numbers = count(1)
    for piece in strongly_connected_components(arcs):
        operators = sorted(node for node in piece if node in reads and node in writes)
        if len(piece) == 1 or not operators:
            continue
        cycle = fact_node("data-cycle", next(numbers))
        yield cycle, fact("size"), integer(len(operators))
        for operator in operators:
            yield operator, fact("in-cycle"), cycle
            yield cycle, MEMBER, operator
        yield from derived(cycle, sorted(set(piece).difference(operators)))


def _arcs(
    reads: Mapping[Term, Sequence[Term]], writes: Mapping[Term, Sequence[Term]]
) -> Mapping[Term, list[Term]]:
    """Return where each node's data go.

    From operators to their outputs, from those to their readers.
    """
    arcs = {operator: sorted(written) for operator, written in sorted(writes.items())}
    for operator, needed in sorted(reads.items()):
        for data in needed:
            arcs.setdefault(data, []).append(operator)
    return arcs
