"""Sources of the data that operators read (paper, section II-D)."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import COORDINATE_OF, kin
from kinlint.facts.predicate_index import FIRST, NUMERIC, PredicateIndex
from kinlint.terms import Term, Triple, is_literal


def data_sources(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the first source of each datum that an operator reads, where there is one."""
    return DataSources(scan).facts()


class DataSources:
    """Nodes with numbers or written by operators: a datum, its relation or its coordinates."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan
        self._written = {each for _, data in scan.table(kin("writes")).items() for each in data}
        self._coordinates: dict[Term, list[Term]] = {}
        for node, relations in scan.table(COORDINATE_OF).items():
            for relation in relations:
                self._coordinates.setdefault(relation, []).append(node)
        self._below: dict[Term, Term | None] = {}

    def facts(self) -> Iterator[Triple]:
        """Yield the first source of each datum that an operator reads, where there is one."""
        read = {each for _, data in self.scan.table(kin("reads")).items() for each in data}
        for datum in sorted(read):
            if not is_literal(datum) and (source := self._of(datum)) is not None:
                yield datum, fact("supplied-by"), source

    def _of(self, datum: Term) -> Term | None:
        relations = self.scan.table(COORDINATE_OF).values(datum)
        found = map(self._at, (datum, *sorted(relations)))
        return next((source for source in found if source is not None), None)

    def _at(self, node: Term) -> Term | None:
        """Return the first source among *node* and its coordinates, sought once for each node."""
        if node not in self._below:
            near = (node, *sorted(self._coordinates.get(node, ())))
            self._below[node] = next((each for each in near if self._is_source(each)), None)
        return self._below[node]

    def _is_source(self, node: Term) -> bool:
        """Tell whether *node* is written by an operator, or has a number or a list as a value."""
        if node in self._written:
            return True
        lists = self.scan.table(FIRST)
        values = self.scan.all_values(node)
        return any(each.rpartition('"')[2] in NUMERIC or each in lists for each in values)
