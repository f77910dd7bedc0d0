"""Writes new nodes of the lifted model as the elements that lifting would have read them from.

A lifting query defines a view of its files, and this is its inverse for what is inserted: a value
is written where the pattern of the query reads it, in elements that are made as far as they are
missing. Conditions of the query are left out; whether the text means what was inserted shows when
it is read again. (Dayal and Bernstein, "On the correct translation of update operations on
relational views", ACM TODS 7(3), 1982.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from kinlint.addresses import document_of, is_element
from kinlint.document import FROM, Document
from kinlint.edits import NotExpressible
from kinlint.engine.derivation import (
    Choice,
    Derivation,
    Derivations,
    First,
    Negation,
    Read,
)
from kinlint.engine.lifting import Lifting
from kinlint.engine.provenance import COMPONENT, Provenance
from kinlint.fixes.lowering import signed
from kinlint.formats.records import ELEMENTS
from kinlint.light_dataclasses import dataclass, field
from kinlint.sparql.tokens import is_variable
from kinlint.terms import Term, Triple, iri, is_blank, is_iri, is_literal, literal, literal_value
from kinlint.vocabulary import ATTRIBUTE, SRC

_ELEMENTS = tuple(f"<{each}" for each in ELEMENTS)
ORDER, TEXT = iri(f"{SRC}order"), iri(f"{SRC}text")


def is_new(term: Term) -> bool:
    """Tell whether *term* is a node that a repair makes."""
    return is_blank(term) and term.startswith("_:new")


def insertion(provenance: Provenance, added: Sequence[Triple]) -> Iterator[tuple[Document, Triple]]:
    """Yield what states *added*, triples of new nodes of a lifted model, in documents.

    Raises `NotExpressible` if no lifting query reads such values anywhere.
    """
    for group in _connected(added):
        yield from _Insertion(provenance, group).written()


def _preferred(derivation: Derivation) -> Iterator[tuple[Read, int]]:
    """Yield what a query would rather read for a value, with 1, or -1 where that is its negative.

    Nothing for values that are worked out.
    """
    match derivation:
        case Read():
            yield derivation, 1
        case First(parts):
            yield from _preferred(parts[0][1])
        case Choice(_, then, otherwise):
            yield from _preferred(then)
            yield from _preferred(otherwise)
        case Negation(part):
            yield from ((read, -sign) for read, sign in _preferred(part))


def _connected(added: Sequence[Triple]) -> Iterator[list[Triple]]:
    """Yield those of *added* that new nodes connect, each time in their order."""
    order = {triple: number for number, triple in enumerate(added)}
    touching: dict[Term, list[Triple]] = {}
    for triple in added:
        for term in filter(is_new, triple[::2]):
            touching.setdefault(term, []).append(triple)
    seen = set[Term]()
    for start in touching:
        group, stack = set[Triple](), [start]
        while stack:
            node = stack.pop()
            if node not in seen:
                seen.add(node)
                group.update(touching[node])
                stack += [each for t in touching[node] for each in filter(is_new, t[::2])]
        if group:
            yield sorted(group, key=order.__getitem__)


@dataclass
class _Insertion:
    """New nodes that are connected, and what is already there that they are connected with."""

    provenance: Provenance
    """The provenance of lifted statements."""
    added: Sequence[Triple]
    """The statements about the new nodes."""
    _made: dict[tuple[Term, Term], Term] = field(default_factory=dict)
    """New elements, by the element around each and its property."""

    def written(self) -> list[tuple[Document, Triple]]:
        """Return what states the new nodes, in the order of their values."""
        found: dict[tuple[Term, Term], list[Term]] = {}
        created: list[Triple] = []
        for triple in self.added:
            if is_literal(triple[2]):
                element, property_, sign = self._place(triple, created)
                found.setdefault((element, property_), []).append(signed(triple[2], sign))
        if not found:
            raise NotExpressible("the format cannot express the new statement")
        for (element, property_), values in found.items():
            said = (way for way, _ in self.provenance.store.predicate_objects(element))
            if any(COMPONENT.sub("", way[:-1]) == property_[:-1] for way in said):
                raise NotExpressible("the text has a value there already")
            value = literal(" ".join(map(literal_value, values)))
            created.append((element, property_, values[0] if len(values) == 1 else value))
        return [(self._document, each) for each in created]

    @cached_property
    def _anchors(self) -> dict[Term, Term]:
        """The elements that the new nodes are connected with, by the property of each."""
        store = self.provenance.store
        named = dict.fromkeys(t for triple in self.added for t in triple[::2] if is_iri(t))
        elements = [e for node in named for e in (node, *store.values(node, FROM))]
        return {
            way: element
            for element in elements
            if is_element(element)
            for _, way in store.leading_to(element)
            if way.startswith(_ELEMENTS)
        }

    @property
    def _document(self) -> Document:
        return self.provenance.store.documents[document_of(next(iter(self._anchors.values())))]

    def _place(self, triple: Triple, created: list[Triple]) -> tuple[Term, Term, int]:
        """Return the element and the property that have the value of *triple*, and its sign.

        Elements that are missing are added to *created*.
        """
        found = []
        for stated, derived in self.provenance.derivations(triple[1]):
            fit = self._fit(derived.lifting, triple[0], stated.made.subject)
            for read, sign in _preferred(stated.members[0]) if fit > 0 else ():
                if (way := self._way(derived, read.element)) is not None:
                    found.append((-fit, way, read.properties[0], sign))
        if not found:
            raise NotExpressible("the format cannot express the new statement")
        _, (anchor, steps), property_, sign = min(found, key=lambda each: each[0])
        element = anchor
        for step in steps:
            element = self._child(element, step, created)
        path, attribute = self.provenance.read_from(anchor, property_)
        if path:
            raise NotExpressible("the value follows from several elements")
        return element, iri(ATTRIBUTE + attribute) if attribute else TEXT, sign

    def _fit(self, lifting: Lifting, node: Term, name: str) -> int:
        """Return how many triples around *node* a query makes that calls it *name*.

        -1 if it makes such triples of other nodes only.
        """
        seen: dict[Term, str] = {}
        stack, count = [(node, name)], 0
        while stack:
            node, name = stack.pop()
            if seen.setdefault(node, name) != name:
                return -1
            for s, p, o in self.added:
                if is_literal(o) or node not in (s, o):
                    continue
                other, here, there = (o, 0, 2) if s == node else (s, 2, 0)
                makes = [each for each in lifting.made if each.predicate == p]
                same = [
                    each[there]
                    for each in makes
                    if each[here] == name and (is_variable(each[there]) or each[there] == other)
                ]
                if makes and not same:
                    return -1
                count += len(same[:1])
                stack += [(other, same[0])] if same and is_new(other) and other not in seen else []
        return count

    def _way(self, derived: Derivations, variable: str) -> tuple[Term, Sequence[Term]] | None:
        """Return the anchor around what *variable* stands for, and the properties between them."""
        steps: list[Term] = []
        while (above := derived.holder(variable)) is not None:
            if above[1] in self._anchors:
                return self._anchors[above[1]], steps
            variable = above[0]
            steps.insert(0, above[1])
        return None

    def _child(self, element: Term, step: Term, created: list[Triple]) -> Term:
        """Return the element that *step* leads to from *element*; a new one if there is none."""
        store = self.provenance.store
        if (element, step) not in self._made:
            there = [] if is_new(element) else list(store.values(element, step))
            first = [each for each in there if not list(store.values(each, ORDER))]
            start = next(t for triple in self.added for t in triple[::2] if is_new(t))
            self._made[element, step] = next(iter(first), f"{start}e{len(self._made)}")
            if not first:
                created.append((element, step, self._made[element, step]))
        return self._made[element, step]
