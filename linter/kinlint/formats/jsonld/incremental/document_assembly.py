"""Assembly of a document from its parts; places of statements are computed on demand."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain, repeat
from typing import TypeVar

from kinlint.addresses import document_iri
from kinlint.document import Document, NodeSpans, OrderedNodes, SourceMap
from kinlint.formats.blank_nodes import BlankNodes, RecalledBlankNodes
from kinlint.formats.jsonld.expansion_record import ShadowedTerm
from kinlint.formats.jsonld.format import JSONLD
from kinlint.formats.jsonld.incremental.part import Arrangement, Part, PartNotes, shifted
from kinlint.formats.jsonld.incremental.part_statements import PartStatements
from kinlint.formats.jsonld.loss_report import shadowed, sort_key, state_losses, state_uses
from kinlint.formats.jsonld.losses import Loss, LossObserver
from kinlint.formats.source_layer import SourceLayer
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, is_blank
from kinlint.text import SourceText, Span

Named = Mapping[Part, tuple[tuple[Term, ...], Part]]
"""Parts with the labels of their blank nodes, and as they are with these labels."""


class Labelling:
    """Labels of blank nodes, in the order in which a reader of the whole file would create them.

    That is by the statements of one part after the other, then, after `finish`, by what is lost.
    Parts of the assembly *lasting* keep the labels that they have there.
    """

    def __init__(self, name: str, parts: Sequence[Part], lasting: Assembly | None) -> None:
        self.blanks = BlankNodes(name) if lasting is None else lasting.blanks.continued()
        self._parts = [part for part in parts if part.asked]
        self._names: list[dict[Term, Term]] = []
        for part in self._parts:
            labels = lasting.named[part][0] if lasting and part in lasting.named else ()
            asked = (node for node, _ in part.asked)
            self._names.append(dict(zip(asked, labels, strict=False)))
        self._ask(0)

    def finish(self, known: Named) -> Named:
        """Return the parts with all of their labels; those that are *known* are not made again."""
        for step in (1, 2, 3):
            self._ask(step)
        named: dict[Part, tuple[tuple[Term, ...], Part]] = {}
        for part, names in zip(self._parts, self._names, strict=True):
            labels = tuple(names.values())
            before = known.get(part)
            unchanged = before is not None and before[0] == labels
            named[part] = before if before and unchanged else (labels, part.renamed(names))
        return named

    def _ask(self, step: int) -> None:
        blanks = self.blanks
        for part, names in zip(self._parts, self._names, strict=True):
            ends = (0, *part.steps, len(part.asked))
            for node, label in part.asked[ends[step] : ends[step + 1]]:
                if node in names:
                    continue
                names[node] = blanks.fresh() if label is None else blanks.named(label)


T = TypeVar("T")

ASIDE = -1
"""Stands for the number of a part where no part says a thing, but the source layer."""


def group_numbers(groups: Sequence[Collection[T]]) -> dict[T, int]:
    """Map each item in *groups*, in the order of first occurrence, to the number of its group."""
    found: dict[T, int] = {}
    size = 0
    for number, group in enumerate(groups):
        found.update(zip(group, repeat(number)))
        size += len(group)
    if size > len(found):
        for number in range(len(groups) - 1, -1, -1):
            found.update(zip(groups[number], repeat(number)))
    return found


class ShiftedNodeSpans(OrderedNodes):
    """The places of the nodes of parts that are *arranged*.

    Where several parts have a node, the first counts; *layer* goes before all of them.
    """

    def __init__(self, arranged: Arrangement, layer: SourceLayer) -> None:
        self.arranged = arranged
        """The parts, in their order."""
        self.aside = layer.nodes
        """The nodes of the source layer."""

    @cached_property
    def _numbers(self) -> dict[Term, int]:
        numbers = group_numbers([part.nodes for part in self.arranged.parts])
        for node in self.aside:
            numbers.setdefault(node, ASIDE)
        return numbers

    def __getitem__(self, node: Term) -> NodeSpans:
        own = self.aside.get(node)
        return self.described(node) if own is None else own

    def described(self, node: Term) -> NodeSpans:
        """Return the spans of the first description of *node*; KeyError if it is no node."""
        number = self._numbers[node]
        whole, identifier = spans = self.arranged.parts[number].nodes[node]
        by = self.arranged.shifts[number]
        if not by:
            return spans
        return NodeSpans(shifted(whole, by), identifier and shifted(identifier, by))

    def __contains__(self, node: object) -> bool:
        return node in self._numbers

    def __iter__(self) -> Iterator[Term]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)

    def part_of(self, node: Term) -> int:
        """Return the number of the part that describes *node* first; `ASIDE` for the layer."""
        return ASIDE if node in self.aside else self._numbers.get(node, ASIDE)

    def in_same_order(self, others: Mapping[Term, NodeSpans]) -> bool:
        """Tell whether *others* have the same nodes in the same order; looks at changed parts."""
        if not isinstance(others, ShiftedNodeSpans):
            return False
        parts = self.arranged.parts, others.arranged.parts
        named = [[node for node in each.aside if not is_blank(node)] for each in (self, others)]
        return (
            len(parts[0]) == len(parts[1])
            and named[0] == named[1]
            and all(
                one is other or _in_order(one) == _in_order(other)
                for one, other in zip(*parts, strict=True)
            )
        )


def _in_order(part: Part) -> list[Term]:
    """Return the nodes of *part* by where they are described."""
    return sorted(part.nodes, key=lambda node: (part.nodes[node].whole.start, node))


class ShiftedTripleSpans(Mapping[Triple, Span]):
    """The places of all that is *stated*, each with the number of the part that says it.

    The parts are *arranged*. What none says is in *layer*, or is that *nodes* are described.
    """

    def __init__(
        self,
        stated: Mapping[Triple, int],
        arranged: Arrangement,
        layer: SourceLayer,
        nodes: ShiftedNodeSpans,
    ) -> None:
        self._stated = stated
        self._parts = arranged.parts
        self._shifts = arranged.shifts
        self._own = layer.triples
        self._nodes = nodes

    def __getitem__(self, triple: Triple) -> Span:
        number = self._stated[triple]
        if number != ASIDE:
            return shifted(self._parts[number].spans[triple], self._shifts[number])
        own = self._own.get(triple)
        return self._nodes.described(triple[0]).best if own is None else own

    def part_of(self, triple: Triple) -> int:
        """Return the number of the part that says *triple* first, or `ASIDE`."""
        return self._stated[triple]

    def __contains__(self, triple: object) -> bool:
        return triple in self._stated

    def __iter__(self) -> Iterator[Triple]:
        return iter(self._stated)

    def __len__(self) -> int:
        return len(self._stated)


@dataclass(frozen=True, slots=True, eq=False)
class Assembly:
    """A document, and those of its parts that have blank nodes, `named`."""

    document: Document
    """The document."""
    named: Named
    """Parts with blank nodes."""
    blanks: BlankNodes
    """The labels of its blank nodes."""
    aside: Sequence[Term]
    """The blank nodes of the source layer, in the order of their creation."""


def assemble(
    source: SourceText,
    given: Arrangement,
    stating: PartStatements,
    before: Assembly | None,
    *,
    lasting: bool,
) -> Assembly:
    """Assemble the document of the *given* parts of *source*, some of them as they were *before*.

    *stating* is what read them. If *lasting*, what was there before keeps its labels; otherwise all
    labels are those that a reader of the whole file would give.
    """
    parts, shifts = given.parts, given.shifts
    kept = before if lasting else None
    labelling = Labelling(source.name, parts, kept)
    blanks = RecalledBlankNodes(kept.aside, labelling.blanks) if kept else labelling.blanks
    layer = SourceLayer(document_iri(source.name), blanks)
    layer.state_file(JSONLD.name, source.name, Span(0, len(source.text)))
    file = tuple(layer.triples)
    layer.state_namespaces(_first((part.namespaces for part in parts), shifts))
    layer.state_terms(_first((part.terms for part in parts), shifts))
    uses = (use for notes in given.notes() for use in notes.uses)
    state_uses(layer, uses, stating.release)
    named = labelling.finish({} if before is None else before.named)
    arranged = Arrangement([named[each][1] if each.asked else each for each in parts], shifts)
    state_losses(layer, _losses(list(arranged.notes())))
    stated = group_numbers([part.spans for part in arranged.parts])
    described = (triple for part in arranged.parts for triple in part.described)
    for triple in chain(file, described, layer.triples):
        stated.setdefault(triple, ASIDE)
    nodes = ShiftedNodeSpans(arranged, layer)
    places = SourceMap(ShiftedTripleSpans(stated, arranged, layer, nodes), nodes)
    prefixes = stating.prefixes
    document = Document(source, layer.document, tuple(stated), places, prefixes, format=JSONLD)
    return Assembly(document, named, labelling.blanks, [*filter(is_blank, layer.nodes)])


def _first(found: Iterable[Mapping[str, Span]], shifts: Sequence[int]) -> dict[str, Span]:
    """Merge what is *found* in the parts, keeping the first place of each name."""
    first: dict[str, Span] = {}
    for places, by in zip(found, shifts, strict=True):
        if not places.keys() <= first.keys():
            for name in places:
                if name not in first:
                    first[name] = shifted(places[name], by)
    return first


def _losses(notes: Sequence[PartNotes]) -> list[Loss]:
    """Return all losses in the order of the text, including those of the file as a whole."""
    watch = LossObserver()
    shadows: dict[ShadowedTerm, Span] = {}
    for each in notes:
        watch.losses += each.losses
        watch.values += each.values
        watch.identifiers |= each.identifiers
        for outermost, inner in each.within:
            watch.within.setdefault(outermost, []).extend(inner)
        for shadow, span in each.shadows:
            shadows[shadow] = min(span, shadows.get(shadow, span))
    found = [*watch.losses, *watch.references(), *watch.nests()]
    found += [loss for each in notes for loss in each.others]
    return sorted([*found, *shadowed(shadows.items())], key=sort_key)
