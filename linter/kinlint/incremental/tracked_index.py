"""An index by predicate that outlives changes, and knows who read what of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinlint.document import Document, NodeSpans, OrderedNodes
from kinlint.engine.store import Store
from kinlint.facts.predicate_index import Place, PredicateIndex, Table
from kinlint.incremental.change import Changes
from kinlint.incremental.index_update import update_index
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term


@dataclass
class Reads:
    """Nodes, properties and classes that a part of the computation of facts has read."""

    properties: set[Term] = field(default_factory=set)
    """Properties whose tables were read."""
    classes: set[Term] = field(default_factory=set)
    """Classes whose instances were read."""
    nodes: set[Term] = field(default_factory=set)
    """The nodes of which it read all statements."""
    places: bool = False
    """True if it sorted nodes by where they are described."""
    files: bool = False
    """True if it read the documents themselves."""


class TrackedIndex(PredicateIndex):
    """An index that lasts from one analysis to the next.

    `looks` has what each part of the work looked at, `below` which other parts it uses.
    """

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self.looks: dict[str, Reads] = {}
        self.below: dict[str, tuple[str, ...]] = {}
        self._described: tuple[Document, ...] = ()

    def part(self, name: str, *below: str) -> PredicateIndex:
        """Return an index that notes what a part of the computation reads; it uses *below*."""
        self.below[name] = below
        looks = self.looks.setdefault(name, Reads())
        return Part(self, looks)

    def forget(self, changes: Changes) -> set[str]:
        """Read again what *changes* are about; return the parts that had read that."""
        update_index(changes, self._tables, self._numbers, self._instances)
        for name in ("_first", "_rest", "_home", "documents"):
            self.__dict__.pop(name, None)
        subjects = {str(quad.subject) for quad in (*changes.removed, *changes.added)}
        before, self._described = self._described, tuple(self.store.documents.values())
        placed = any(each.places for each in self.looks.values())
        moved = placed and _moved(before, self._described)
        touched = {
            name
            for name, each in self.looks.items()
            if not each.properties.isdisjoint(changes.properties)
            or not each.classes.isdisjoint(changes.classes)
            or not each.nodes.isdisjoint(subjects)
            or (each.places and moved)
            or (each.files and changes.rewritten)
        }
        grew = True
        while grew:
            more = {name for name, uses in self.below.items() if not touched.isdisjoint(uses)}
            grew = not more <= touched
            touched |= more
        for name in touched:
            self.looks.pop(name, None)
        return touched


class Part(PredicateIndex):
    """A scan of one part of the work, which shares all that it reads with the others."""

    def __init__(self, kept: TrackedIndex, looks: Reads) -> None:
        super().__init__(kept.store)
        self._kept = kept
        self._looks = looks
        self._tables = kept._tables  # noqa: SLF001  of its own class
        self._numbers = kept._numbers  # noqa: SLF001
        self._instances = kept._instances  # noqa: SLF001

    def table(self, predicate: Term) -> Table:
        """All values of *predicate*, by subject."""
        self._looks.properties.add(predicate)
        return super().table(predicate)

    def numbers(self, predicate: Term) -> Mapping[Term, float]:
        """The number that is the value of *predicate*, for the subjects that have exactly one."""
        self._looks.properties.add(predicate)
        return super().numbers(predicate)

    def instances(self, kind: Term) -> frozenset[Term]:
        """The nodes that are of class *kind*, stated or inferred."""
        self._looks.classes.add(kind)
        return super().instances(kind)

    def inferred(self, kind: Term) -> frozenset[Term]:
        """The nodes that are of class *kind* only because something else follows."""
        self._looks.classes.add(kind)
        return super().inferred(kind)

    def statements(self, node: Term) -> Mapping[Term, list[Term]]:
        """Return all that is said of an IRI, by property."""
        self._looks.nodes.add(node)
        return super().statements(node)

    def all_values(self, node: Term) -> frozenset[Term]:
        """The values of all that is said of *node*."""
        self._looks.nodes.add(node)
        return super().all_values(node)

    def place(self, node: Term) -> Place:
        """Sorts nodes by where they are described first; nodes described nowhere come last."""
        self._looks.places = True
        return self._kept.place(node)

    @property
    def documents(self) -> tuple[Document, ...]:
        """The documents of the store, in its order."""
        self._looks.files = True
        return self._kept.documents


def _moved(before: Sequence[Document], after: Sequence[Document]) -> bool:
    """Tell whether the nodes of documents come in another order than *before*."""
    return len(before) != len(after) or not all(map(_in_same_order, before, after))


def _in_same_order(before: Document, after: Document) -> bool:
    """Tell whether two documents describe the same nodes in the same order."""
    if before is after:
        return True
    old, new = before.map.nodes, after.map.nodes
    if isinstance(old, OrderedNodes):
        return before.graph == after.graph and old.in_same_order(new)
    return before.graph == after.graph and _in_order(old) == _in_order(new)


def _in_order(nodes: Mapping[Term, NodeSpans]) -> list[Term]:
    """Return *nodes* by where they are described."""
    return sorted(nodes, key=lambda node: (nodes[node].whole.start, node))
