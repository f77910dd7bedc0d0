"""The order in which schedules trigger operators, and data that flow in a circle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import count

from kinlint.facts.names import algorithm, kin
from kinlint.facts.scan import Scan
from kinlint.facts.statement import MEMBER, derived, fact, fact_node, integer
from kinlint.facts.strong import strong_components
from kinlint.terms import Term, Triple


def steps(scan: Scan) -> Iterator[Triple]:
    """The steps of each schedule, counted from zero."""
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


def circles(scan: Scan) -> Iterator[Triple]:
    """The operators that need, directly or through others, what they write themselves."""
    reads, writes = (dict(scan.table(kin(name)).items()) for name in ("reads", "writes"))
    if not reads or not writes:
        return
    arcs = _arcs(reads, writes)
    numbers = count(1)
    for piece in strong_components(arcs):
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
    """Where each node's data go: from operators to what they write, from that to its readers."""
    arcs = {operator: sorted(written) for operator, written in sorted(writes.items())}
    for operator, needed in sorted(reads.items()):
        for data in needed:
            arcs.setdefault(data, []).append(operator)
    return arcs
