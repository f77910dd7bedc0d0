"""The triples a text is to state, and those that some edit makes already."""

from __future__ import annotations

from kinlint.edits import Delta, NotExpressible
from kinlint.formats.jsonld.editing.triple_places import TriplePlaces
from kinlint.formats.jsonld.triples import FIRST, NIL, REST
from kinlint.terms import Term, Triple

LINKS = frozenset({FIRST, REST})
"""The properties that hold lists together."""


class TargetGraph:
    """The graph after one delta.

    `removed` and `added` are what is to be done; `settled` and `said` are what some change does
    that neither cuts the old value nor is found by looking at it. `renamed` maps the new name of
    a node to the one in the text.
    """

    def __init__(self, places: TriplePlaces, delta: Delta) -> None:
        self.places = places
        self.removed = dict.fromkeys(delta.removed)
        self.added = dict.fromkeys(delta.added)
        self.settled: set[Triple] = set()
        self.stated: set[Triple] = set()
        self.renamed: dict[Term, Term] = {}
        self._new: dict[Term, list[Triple]] = {}
        self._old: dict[Term, list[Triple]] = {}
        for index, triples in ((self._new, delta.added), (self._old, delta.removed)):
            for triple in triples:
                index.setdefault(triple[0], []).append(triple)

    def new(self, node: Term) -> list[Triple]:
        """Return the triples to add about *node*."""
        return self._new.get(node, [])

    def old(self, node: Term) -> list[Triple]:
        """Return the triples to remove about *node*."""
        return self._old.get(node, [])

    def node(self, term: Term) -> Term:
        """Return the node of the text that is to be called *term*."""
        return self.renamed.get(term, term)

    def is_list(self, term: Term) -> bool:
        """Tell whether *term* is a list that is new, or empty."""
        return term == NIL or any(prop in LINKS for _, prop, _ in self.new(term))

    def sequence(self, head: Term) -> list[tuple[Term, Term]]:
        """Return the cells of a list and their values, after the delta.

        Raises Unsayable where the delta leaves it without an end.
        """
        found: list[tuple[Term, Term]] = []
        seen: set[Term] = set()
        while head != NIL:
            value, rest = self._link(head, FIRST), self._link(head, REST)
            if head in seen or value is None or rest is None:
                raise NotExpressible("the list would be broken")
            seen.add(head)
            found.append((head, value))
            head = rest
        return found

    def _link(self, cell: Term, prop: Term) -> Term | None:
        known = [t for t in self.places.by_subject.get(cell, ()) if t not in self.removed]
        values = [value for _, p, value in (*known, *self.new(cell)) if p == prop]
        return values[0] if len(values) == 1 else None
