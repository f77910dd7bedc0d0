"""Parts of a file: elements of the outermost graph with their statements, and their order."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Generic, TypeAlias, TypeVar

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.jsonld.expansion_record import ShadowedTerm
from kinlint.formats.jsonld.losses import Loss, Nested
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import Term, Triple
from kinlint.text import Span

Move: TypeAlias = Callable[[Span], Span]
Names: TypeAlias = Mapping[Term, Term]


class DeferredBlankNodes(BlankNodes):
    """Blank nodes whose final labels are not known yet; `order` tells how they were asked for."""

    def __init__(self) -> None:
        super().__init__("")
        self.order: list[tuple[Term, str | None]] = []
        self._named: dict[str, Term] = {}

    def rewind(self, count: int) -> None:
        """Forget the nodes after the first *count*, none of which has a name in the text."""
        super().rewind(count)
        del self.order[count:]

    def since(self, count: int) -> BlankNodes:
        """Return labels that are those given after the first *count*, once more."""
        again = BlankNodes("")
        again.rewind(count)
        return again

    def fresh(self) -> Term:
        """Return a blank node without a name in the text."""
        node = super().fresh()
        self.order.append((node, None))
        return node

    def named(self, label: str) -> Term:
        """Return the blank node that the text calls *label*."""
        if label not in self._named:
            self._named[label] = super().fresh()
            self.order.append((self._named[label], label))
        return self._named[label]


@dataclass(frozen=True, slots=True)
class PartNotes:
    """Statements of the source layer about a part, pending until the whole file is read."""

    losses: tuple[Loss, ...] = ()
    """Losses in the part."""
    values: tuple[tuple[str, Loss], ...] = ()
    """Losses by the value written there; void if it is among the identifiers of the file."""
    identifiers: frozenset[str] = frozenset()
    """Relative identifiers of nodes."""
    within: tuple[tuple[Term, tuple[Nested, ...]], ...] = ()
    """Nodes described in others, by the outermost node."""
    others: tuple[Loss, ...] = ()
    """Losses that come after these."""
    uses: tuple[tuple[Span, str], ...] = ()
    """Places and names of used contexts."""
    shadows: tuple[tuple[ShadowedTerm, Span], ...] = ()
    """Uses of terms that a later context redefines."""

    def moved(self, move: Move) -> PartNotes:
        """Return a copy with moved places."""
        return PartNotes(
            tuple(replace(loss, span=move(loss.span)) for loss in self.losses),
            tuple((name, replace(loss, span=move(loss.span))) for name, loss in self.values),
            self.identifiers,
            tuple(
                (outermost, tuple(_moved(each, move) for each in inner))
                for outermost, inner in self.within
            ),
            tuple(replace(loss, span=move(loss.span)) for loss in self.others),
            tuple((move(span), name) for span, name in self.uses),
            tuple((shadow, move(span)) for shadow, span in self.shadows),
        )

    def renamed(self, names: Names) -> PartNotes:
        """Return the same with the blank nodes called by their final *names*."""
        return PartNotes(
            tuple(_renamed(loss, names) for loss in self.losses),
            tuple((name, _renamed(loss, names)) for name, loss in self.values),
            self.identifiers,
            tuple(
                (names.get(outermost, outermost), tuple(_called(each, names) for each in inner))
                for outermost, inner in self.within
            ),
            tuple(_renamed(loss, names) for loss in self.others),
            self.uses,
            self.shadows,
        )

    def places(self) -> list[Span]:
        """Return all places in the notes."""
        return [
            *(loss.span for loss in (*self.losses, *self.others)),
            *(loss.span for _, loss in self.values),
            *(span for _, inner in self.within for span, *_ in inner),
            *(each.slot.stands for _, inner in self.within for each in inner),
            *(span for span, _ in self.uses),
            *(span for _, span in self.shadows),
        ]


NOTHING = PartNotes()

K = TypeVar("K")
N = TypeVar("N")
P = TypeVar("P")


class LazyPlaces(Mapping[K, P], Generic[K, N, P]):
    """Places of things that are called by *names* where *place* looks them up, one at a time."""

    __slots__ = ("_names", "_place")

    def __init__(self, names: Mapping[K, N], place: Callable[[N], P]) -> None:
        self._names = names
        self._place = place

    def __getitem__(self, key: K) -> P:
        return self._place(self._names[key])

    def __contains__(self, key: object) -> bool:
        return key in self._names

    def __iter__(self) -> Iterator[K]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """Statements and nodes of one element, with their places when it was read."""

    whole: Span
    """Place of the element."""
    spans: Mapping[Triple, Span]
    """Its statements, each with its place."""
    nodes: Mapping[Term, NodeSpans]
    """Its nodes, each with its places."""
    described: tuple[Triple, ...]
    """Statements that its nodes are described in the file."""
    terms: Mapping[Term, Span]
    """Properties and classes, each with the place of its first use."""
    namespaces: Mapping[str, Span]
    """Namespaces, each with the place of its first use."""
    asked: tuple[tuple[Term, str | None], ...] = ()
    """Its blank nodes in the order of their creation, with their labels in the text."""
    steps: tuple[int, int, int] = (0, 0, 0)
    """Blank nodes created by statements, then by keys without meaning, then by values without
    effect; repeated keys created the others."""
    notes: PartNotes = field(default=NOTHING)
    """Notes on what is lost of it."""

    def renamed(self, names: Names) -> Part:
        """Return the same with the blank nodes called by their final *names*."""
        get = names.get
        triples = {
            (get(each[0], each[0]), each[1], get(each[2], each[2])): each for each in self.spans
        }
        nodes = {get(node, node): node for node in self.nodes}
        return replace(
            self,
            spans=LazyPlaces(triples, self.spans.__getitem__),
            nodes=LazyPlaces(nodes, self.nodes.__getitem__),
            described=tuple((get(s, s), p, o) for s, p, o in self.described),
            notes=self.notes.renamed(names),
        )

    def places(self) -> list[Span]:
        """Return all places in the part."""
        spans = [*self.spans.values(), *self.notes.places()]
        for whole, identifier in self.nodes.values():
            spans += (whole, identifier) if identifier else (whole,)
        return spans

    def moved(self, move: Move) -> Part:
        """Return a copy with moved places."""
        return replace(
            self,
            whole=move(self.whole),
            spans={triple: move(span) for triple, span in self.spans.items()},
            nodes={
                node: NodeSpans(move(whole), identifier and move(identifier))
                for node, (whole, identifier) in self.nodes.items()
            },
            terms={term: move(span) for term, span in self.terms.items()},
            namespaces={name: move(span) for name, span in self.namespaces.items()},
            notes=self.notes.moved(move),
        )


def shifted(span: Span, by: int) -> Span:
    """Return *span* moved by a number of characters."""
    return Span(span[0] + by, span[1] + by) if by else span


def _moved(nested: Nested, move: Move) -> Nested:
    slot = nested.slot._replace(stands=move(nested.slot.stands))
    return nested._replace(span=move(nested.span), slot=slot)


def _called(nested: Nested, names: Names) -> Nested:
    return nested._replace(node=names.get(nested.node, nested.node))


def _renamed(loss: Loss, names: Names) -> Loss:
    node = names.get(loss.node, loss.node) if loss.node is not None else None
    details = tuple(each._replace(value=names.get(each.value, each.value)) for each in loss.details)
    return replace(loss, node=node, details=details)


@dataclass(frozen=True, slots=True, eq=False)
class Arrangement:
    """Parts of a text in their order."""

    parts: Sequence[Part]
    """The parts."""
    shifts: Sequence[int]
    """Distance that each has moved since it was read, in characters."""

    def end_of(self, number: int) -> int:
        """Return the end of a part."""
        return self.parts[number].whole.end + self.shifts[number]

    def first_to(self, end: int) -> int:
        """Return the first part that ends at *end* or later; as many as there are if none does."""
        return bisect_left(range(len(self.parts)), end, key=self.end_of)

    def replaced(self, first: int, rest: int, between: Arrangement, by: int) -> Arrangement:
        """Return the *first* parts, others *between*, and the *rest*, which moves *by*."""
        moved = (each + by for each in self.shifts[rest:])
        return Arrangement(
            [*self.parts[:first], *between.parts, *self.parts[rest:]],
            [*self.shifts[:first], *between.shifts, *moved],
        )

    def notes(self) -> Iterator[PartNotes]:
        """Yield the notes of the parts, moved to their present places."""
        for part, by in zip(self.parts, self.shifts, strict=True):
            if part.notes is not NOTHING:
                yield part.notes.moved(partial(shifted, by=by)) if by else part.notes
