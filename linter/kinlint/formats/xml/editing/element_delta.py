"""Changes of the elements of a document that a delta asks for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from kinlint.edits import Delta, NotExpressible
from kinlint.formats.xml.editing.stated_elements import StatedElement, slot_of, tag_of
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_blank, is_literal

Slots = dict[str, dict[int, Term]]
"""Values by attribute, and number of component or 0 for all; the text has no name."""


@dataclass
class ValueChange:
    """Values that an element loses, and those that it gains."""

    removed: Slots = field(default_factory=dict)
    """Values to remove, by slot."""
    added: Slots = field(default_factory=dict)
    """Values to add, by slot."""


@dataclass
class ElementChanges:
    """Changes of elements: deletion, other tags, new children, other values."""

    known: Mapping[Term, StatedElement]
    """Elements of the text."""
    deleted: list[Term] = field(default_factory=list)
    """Elements to delete."""
    renamed: dict[Term, str] = field(default_factory=dict)
    """New tags of elements."""
    moved: set[Term] = field(default_factory=set)
    """Elements to write below another parent."""
    children: dict[Term, list[tuple[str, Term]]] = field(default_factory=dict)
    """New nodes, or moved ones, with their tags."""
    values: dict[Term, ValueChange] = field(default_factory=dict)
    """Changes of values, by element."""

    @classmethod
    def from_delta(cls, delta: Delta, known: Mapping[Term, StatedElement]) -> ElementChanges:
        """Return the changes of *delta*; raises Unsayable for what is no matter of elements."""
        changes = cls(known)
        changes._structure(delta)
        gone = set(changes.deleted)
        for triple in delta.removed:
            if not changes.within(triple[0], gone) and tag_of(triple[1]) is None:
                changes._removal(triple)
        for triple in delta.added:
            if changes.within(triple[0], gone):
                raise NotExpressible("what is deleted cannot be changed")
            if tag_of(triple[1]) is None:
                changes._addition(triple)
        return changes

    def _structure(self, delta: Delta) -> None:
        before = dict(_placed(delta.removed))
        after = dict(_placed(delta.added))
        if len(after) < sum(1 for _ in _placed(delta.added)):
            raise NotExpressible("an element cannot stand in two places")
        for node, (parent, tag) in before.items():
            element = self.known.get(node)
            if element is None or element.parent != parent or element.tag != tag:
                raise NotExpressible("the element is not there")
        both = before.keys() & after.keys()
        self.moved = {each for each in both if before[each][0] != after[each][0]}
        gone = before.keys() - after.keys()
        self.deleted = [
            each
            for each, (parent, _) in before.items()
            if each in gone and not self.within(parent, gone)
        ]
        for node, (parent, tag) in after.items():
            if not is_blank(node) and node not in before:
                raise NotExpressible("an element cannot stand in two places")
            if self.within(parent, gone) or not (is_blank(parent) or parent in self.known):
                raise NotExpressible("no element is there to hold it")
            self._check_reached(node, after)
            if node in before and before[node][1] != tag:
                self.renamed[node] = tag
            if node not in before or node in self.moved:
                self.children.setdefault(parent, []).append((tag, node))

    def _check_reached(self, node: Term, after: Mapping[Term, tuple[Term, str]]) -> None:
        """Raise Unsayable for an element that would stand within itself."""
        at, passed = node, set[Term]()
        while at not in passed:
            passed.add(at)
            if at in after:
                at = after[at][0]
            elif at in self.known:
                at = self.known[at].parent
            else:
                return
        raise NotExpressible("an element cannot stand within itself")

    def within(self, node: Term, others: Collection[Term]) -> bool:
        """Tell whether *node* is one of *others*, or below one and does not leave it."""
        at: Term | None = node
        while at is not None and at not in others:
            stays = at in self.known and at not in self.moved
            at = self.known[at].parent if stays else None
        return at is not None

    def _removal(self, triple: Triple) -> None:
        node, predicate, value = triple
        element = self.known.get(node)
        slot = slot_of(predicate, value)
        if element is None or slot is None:
            raise NotExpressible("no element says it")
        if element.slots.get(slot[0], {}).get(slot[1]) != value:
            raise NotExpressible("the text does not say it")
        change = self.values.setdefault(node, ValueChange())
        change.removed.setdefault(slot[0], {})[slot[1]] = value

    def _addition(self, triple: Triple) -> None:
        node, predicate, value = triple
        slot = slot_of(predicate, value)
        if slot is None or not (is_blank(node) or node in self.known):
            raise NotExpressible("no element can say it")
        if not is_literal(value):
            raise NotExpressible("an attribute or a text cannot be a node")
        own = self.values.setdefault(node, ValueChange()).added.setdefault(slot[0], {})
        if own.setdefault(slot[1], value) != value:
            raise NotExpressible(f"two values for one {slot[0] or 'text'}")


def _placed(triples: tuple[Triple, ...]) -> Iterator[tuple[Term, tuple[Term, str]]]:
    """Yield the elements that *triples* put somewhere, with their parents and tags."""
    for subject, predicate, value in triples:
        if (tag := tag_of(predicate)) is not None:
            if is_literal(value):
                raise NotExpressible("an element cannot be a value")
            yield value, (subject, tag)
