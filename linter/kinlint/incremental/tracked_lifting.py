"""Lifts again by those queries that look at what changed of the documents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import count
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.compiler.query_dependencies import Dependencies, dependencies_of
from kinlint.engine.construct_template import variables_of
from kinlint.engine.lifting import Lifting, asked, is_lifted_as
from kinlint.engine.store import ASSERTED_GRAPH, Store, token
from kinlint.incremental.affected_nodes import AffectedNodes, TooMany
from kinlint.incremental.change import Changes, to_quads
from kinlint.incremental.restriction import GIVEN, Restriction, find_restriction, restricted
from kinlint.light_dataclasses import dataclass
from kinlint.sparql.ast import render
from kinlint.sparql.given_values import is_nameable
from kinlint.sparql.tokens import is_variable
from kinlint.terms import RDF, Term, Triple, iri, iri_value
from kinlint.vocabulary import LIFTED_GRAPH

Row: TypeAlias = tuple[Term | None, ...]
Made: TypeAlias = dict[Row, list[tuple[Triple, ...]]]
"""The triples that a query made of each solution, once for each time that it came."""
FIRST, REST, NIL = (iri(f"{RDF}{name}") for name in ("first", "rest", "nil"))
ASSERTED = ox.NamedNode(iri_value(ASSERTED_GRAPH))


@dataclass(frozen=True, eq=False)
class Unit:
    """A lifting query as a SELECT, and what to make of its solutions."""

    select: str
    """The query as a SELECT."""
    restricted: str
    """The same with `GIVEN` in place of the values of the variable of `narrow`."""
    names: tuple[str, ...]
    """Variables of a solution; the last is the one that `narrow` restricts."""
    template: Sequence[tuple[str, str, tuple[str, ...] | str]]
    """Subject, predicate and object, or the items of a list, of each triple to make."""
    dependencies: Dependencies
    """Properties and classes that the query names."""
    narrow: Restriction | None
    """The variable by which the query can be restricted, if there is one."""
    format: str
    """Format of the documents that it is for."""
    subject: int | None
    """Place in a solution of something that is made; None if that is the same for all."""

    @classmethod
    def from_lifting(cls, lifting: Lifting, kept: frozenset[Term] | None) -> Unit:
        """Return what makes all that *lifting* makes, or what of it is *kept*."""
        made, where = lifting.part(kept)
        used = frozenset(variables_of(made))
        names = tuple(sorted(name[1:] for name in used))
        narrow, dependencies = _looked_at(lifting, None if kept is None else used)
        if not names:
            narrow = None
        if narrow is not None:
            root = narrow.root[1:]
            names = (*(name for name in names if name != root), root)
        shown = " ".join(f"?{name}" for name in names) or "*"
        head = f"SELECT {shown} WHERE"
        within = where if narrow is None else restricted(where, narrow.root)
        template = [(each.subject, each.predicate, each.items or each.object) for each in made]
        texts = f"{head} {render(where)}", f"{head} {render(within)}"
        subject = made[0].subject[1:] if made else ""
        place = names.index(subject) if subject in names else None
        return cls(*texts, names, template, dependencies, narrow, lifting.format, place)

    def may_make(self, triple: Triple) -> bool:
        """Tell whether one of the triples that it makes may be *triple*."""
        return any(
            all(is_variable(word) or word == term for word, term in zip(made, triple, strict=True))
            for *ends, value in self.template
            if isinstance(value, str) and (made := (*ends, value))
        )


_unit = lru_cache(maxsize=512)(Unit.from_lifting)


@lru_cache(maxsize=512)
def _looked_at(
    lifting: Lifting, used: frozenset[str] | None
) -> tuple[Restriction | None, Dependencies]:
    """Return what *lifting* can be restricted by, and what it looks at, for variables *used*."""
    where = lifting.where if used is None else lifting.where_for(used)
    return find_restriction(where), dependencies_of(where)


class TrackedLifting:
    """Asserted statements about elements to lifted ones: a composable model.

    All that was to be lifted of *store* is there. What a query made of which solution is found out
    when something changes that it looks at: from the statements as they were before.
    """

    def __init__(
        self,
        store: Store,
        wanted: Collection[Term] | None = None,
        kept: frozenset[Term] | None = None,
    ) -> None:
        self.store = store
        self._wanted = wanted
        self._kept = kept
        self._made: dict[Unit, Made] = {}
        self._counts: Counter[Triple] = Counter()
        self._numbers = count(1)

    @cached_property
    def units(self) -> Sequence[Unit]:
        """The queries that make something wanted."""
        formats = {document.format for document in self.store.documents.values()}
        return [_unit(each, self._kept) for each in asked(formats, self._wanted)]

    def run(self, changes: Changes, ask: Callable[[], None]) -> None:
        """Lift by those queries that look at what *changes* are about."""
        affected = AffectedNodes(changes)
        for unit in self.units:
            if unit.dependencies.looks_at(changes.properties, changes.classes):
                ask()
                roots = _concerned(unit, affected)
                if roots is None or roots:
                    self._recall(unit, changes)
                    self._relift(unit, roots, changes)

    def _recall(self, unit: Unit, changes: Changes) -> None:
        """Find out what *unit* has made, from what was asserted before *changes*."""
        if unit in self._made:
            return
        with changes.undone(ASSERTED_GRAPH):
            rows = Counter(self._rows(unit, None))
        made, used = self._made.setdefault(unit, {}), set[Term]()
        for row, times in rows.items():
            made[row] = [tuple(self._known(unit, row, used)) for _ in range(times)]
            for triples in made[row]:
                self._counts.update(triples)

    def _relift(self, unit: Unit, roots: Collection[Term] | None, changes: Changes) -> None:
        """Lift anew by *unit* what it makes of *roots*, or all."""
        rows = Counter(self._rows(unit, roots))
        gone, come = list[Triple](), list[Triple]()
        made = self._made[unit]
        known = made if roots is None else [row for row in made if row[-1] in roots]
        for row in [row for row in known if row not in rows]:
            for triples in made.pop(row):
                gone += triples
        for row, times in rows.items():
            filled = made.setdefault(row, [])
            while len(filled) > times:
                gone += filled.pop()
            while len(filled) < times:
                filled.append(tuple(self._filled(unit, row)))
                come += filled[-1]
        before = {each for each in (*gone, *come) if self._counts[each]}
        self._counts.subtract(gone)
        self._counts.update(come)
        for other in [each for each in self.units if each not in self._made]:
            if any(not self._counts[each] and other.may_make(each) for each in gone):
                self._recall(other, changes)
        after = {each for each in (*gone, *come) if self._counts[each]}
        for each in gone:
            if not self._counts[each]:
                del self._counts[each]
        kept = to_quads(after, LIFTED_GRAPH)
        removed = set(to_quads(before - after, LIFTED_GRAPH)).difference(kept)
        changes.apply(removed, kept)

    def _rows(self, unit: Unit, roots: Collection[Term] | None) -> Iterator[Row]:
        select = unit.select
        if roots is not None and unit.narrow is not None:
            select = unit.restricted.replace(GIVEN, " ".join(sorted(roots)))
        solutions = self.store.oxigraph.query(select, default_graph=ASSERTED)
        assert isinstance(solutions, ox.QuerySolutions)
        places = [[each.value for each in solutions.variables].index(name) for name in unit.names]
        for solution in solutions:
            terms = (solution[place] for place in places)
            row = tuple(None if term is None else token(term) for term in terms)
            home = None if unit.subject is None else row[unit.subject]
            if home is None or is_lifted_as(home, unit.format, self.store.documents):
                yield row

    def _known(self, unit: Unit, row: Row, used: set[Term]) -> Iterator[Triple]:
        """Yield what *unit* has made of *row*; of lists, those cells that are not *used* yet."""
        known = dict(zip(unit.names, row, strict=True))
        for subject, predicate, value in unit.template:
            start, property_ = _bound_term(subject, known), _bound_term(predicate, known)
            if isinstance(value, str):
                yield from _triple(start, property_, _bound_term(value, known))
            elif start and property_ and start[0] != '"':
                items = tuple(_bound_term(item, known) for item in value)
                heads = (head for head in self.store.values(start, property_) if head not in used)
                found = (cells for head in heads if (cells := self._cells(head, items)))
                cells = next(found, ())
                used.update(each[0] for each in cells)
                if cells:
                    yield start, property_, cells[0][0]
                    yield from cells

    def _cells(self, head: Term, items: Sequence[Term | None]) -> tuple[Triple, ...]:
        """Return the statements of the cells of the list *head* if it has *items*, else none."""
        found = list[Triple]()
        for item in items:
            if head[0] != "_":
                return ()
            there, rests = list(self.store.values(head, FIRST)), list(self.store.values(head, REST))
            if there != ([] if item is None else [item]) or len(rests) != 1:
                return ()
            found += [(head, FIRST, each) for each in there]
            found.append((head, REST, rests[0]))
            head = rests[0]
        return tuple(found) if head == NIL else ()

    def _filled(self, unit: Unit, row: Row) -> Iterator[Triple]:
        """Yield what the template of *unit* says for *row*, less what is unbound or no triple."""
        known = dict(zip(unit.names, row, strict=True))
        for subject, predicate, value in unit.template:
            if isinstance(value, str):
                yield from _triple(
                    _bound_term(subject, known),
                    _bound_term(predicate, known),
                    _bound_term(value, known),
                )
                continue
            cells = [*(f"_:lifted{next(self._numbers)}" for _ in value), NIL]
            yield from _triple(_bound_term(subject, known), _bound_term(predicate, known), cells[0])
            for cell, item, rest in zip(cells, value, cells[1:], strict=False):
                yield from _triple(cell, FIRST, _bound_term(item, known))
                yield cell, REST, rest


def _concerned(unit: Unit, affected: AffectedNodes) -> frozenset[Term] | None:
    """The values of the variable that *unit* is narrowed by which its changes concern.

    None for all: too many, or some that no query can name.
    """
    if unit.narrow is None:
        return None
    try:
        nodes = affected.nodes(unit.narrow.pattern_paths)
    except TooMany:
        return None
    found = frozenset(map(str, nodes))
    return found if all(map(is_nameable, found)) else None


def _triple(subject: Term | None, predicate: Term | None, value: Term | None) -> Iterator[Triple]:
    if subject and predicate and value and subject[0] != '"' and predicate[0] == "<":
        yield subject, predicate, value


def _bound_term(word: str, known: dict[str, Term | None]) -> Term | None:
    return known[word[1:]] if word[0] == "?" else word
