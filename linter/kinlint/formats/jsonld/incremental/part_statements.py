"""Statements and source layer of each part of a file, independent of the others."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Iterator, Mapping
from typing import Any, NamedTuple

from kinlint.addresses import document_iri
from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.json_text.json_values import Array, Object, ParsedJson
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.compiled.element_compiler import ElementCompiler
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expansion_record import ExpansionRecord
from kinlint.formats.jsonld.incremental.part import (
    NOTHING,
    DeferredBlankNodes,
    LazyPlaces,
    Part,
    PartNotes,
)
from kinlint.formats.jsonld.incremental.part_expander import DividedProcessor, Indivisible
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.loss_report import LossReport
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.missing_context import lacks_context
from kinlint.formats.jsonld.release_comparison import LOOKED_UP, ReleaseComparison
from kinlint.formats.jsonld.traced_values import Expanded, Origin
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import DESCRIBED, first_nodes, first_statements, namespaces, terms
from kinlint.text import SourceText, Span


class PartObservations(NamedTuple):
    """Observations of a part while it was expanded and stated.

    Of the contexts that `record` says are used, those that are `known` are named elsewhere.
    """

    record: ExpansionRecord
    """The record of its expansion."""
    known: Collection[int]
    """Contexts that are named outside of the part, by their position."""
    watch: LossObserver
    """Observes what is lost."""
    triples: Triples
    """The statements."""
    blanks: DeferredBlankNodes
    """The blank nodes that were asked for."""
    repeats: Collection[Object]
    """Objects in which a key stands more than once."""
    origins: Mapping[int, Origin]
    """The objects that nodes were expanded from, by `id`."""

    def owners(self) -> Iterator[Origin]:
        """Yield the objects of the nodes of which something is lost."""
        yield from (drop.origin.owner for drop in self.record.drops.values())
        strays = (stray.origin for stray in self.record.strays.values())
        repeated = (self.origins.get(id(each)) for each in self.repeats)
        yield from (origin.owner for origin in (*strays, *repeated) if origin is not None)

    def notes(self, compared: ReleaseComparison) -> tuple[PartNotes, int, int]:
        """Return the notes, and the number of blank nodes asked for before each of two steps."""
        record, watch, order = self.record, self.watch, self.blanks.order
        report = LossReport(record, watch, self.triples, compared)
        others = [*report.types(), *report.dropped()]
        dropped = len(order)
        others += report.strays()
        strayed = len(order)
        others += [*report.contexts(), *report.duplicates(self.repeats, self.origins)]
        notes = PartNotes(
            tuple(watch.losses),
            tuple((str(written), loss) for written, loss in watch.values),
            frozenset(map(str, watch.identifiers)),
            tuple((outermost, tuple(inner)) for outermost, inner in watch.within.items()),
            tuple(others),
            tuple(
                (token.span, str(token))
                for start, token in record.uses.items()
                if start not in self.known
            ),
            tuple((shadow, token.span) for shadow, token in record.shadow_uses.items()),
        )
        return (NOTHING if notes == NOTHING else notes), dropped, strayed


MANY, CONTEXTS = 5_000, 500
"""Number of parts read again, and of contexts cached, at which everything is read anew."""


class PartStatements:
    """Reads one file part by part, and more parts at the place of its outermost graph later on.

    `parts` are the elements of that graph, read under `release` of our contexts.
    """

    def __init__(self, source: SourceText, options: ReadOptions) -> None:
        self.parts: list[Part] = []
        self.release = options.contexts.release
        self._graph = document_iri(source.name)
        memory = ContextCache.from_options(options, options.contexts.release)
        self._local = LocalContexts(source, options)
        self._processor = DividedProcessor(memory, options.base, self._local, self._take)
        self._compared = ReleaseComparison(options, self._local)
        self._hull = self._processor.record
        self._known = ExpansionRecord()
        self._whole = Span(0, 0)
        self._count = 0
        self._repeats: list[tuple[int, int, Object]] = []

    @property
    def exhausted(self) -> bool:
        """Tell whether so much was read that the caches should be dropped."""
        return self._processor.contexts > CONTEXTS or self._count > len(self.parts) + MANY

    @property
    def prefixes(self) -> Mapping[str, str]:
        """The abbreviations of the file."""
        return self._hull.prefixes

    @property
    def place(self) -> Span:
        """Return the span of the elements of the outermost graph, with their brackets."""
        return self._processor.place

    def hull(self, parsed: ParsedJson) -> Part:
        """Read what the file states besides its parts, stating the parts on the way.

        Raises Indivisible if that is not all of it, and what expansion raises.
        """
        if not isinstance(parsed.value, Object) or parsed.value.overwritten is not None:
            raise Indivisible
        if lacks_context(parsed):
            raise Indivisible
        self._whole = parsed.span
        order = ((each.start, number, each) for number, each in enumerate(parsed.repeats))
        self._repeats = sorted(order, key=lambda each: each[:2])
        expanded = self._processor.expand_document(parsed)
        hull, known, gap = self._hull, self._known, self.place
        if self._processor.around is None or known.shadows != hull.shadows:
            raise Indivisible
        if bool(known.uses) != bool(hull.uses) or self._local.asked:
            raise Indivisible
        repeats = [each for each in parsed.repeats if not _within(each.span, gap)]
        part = self._part(parsed.span, expanded, repeats, ())
        if part.steps[0] != len(part.asked):
            raise Indivisible
        if any(gap.start < at < gap.end for span in part.places() for at in span):
            raise Indivisible
        return part

    def part(self, element: Object, repeats: Collection[Object]) -> Part:
        """Read *element* of the outermost graph; *repeats* are its objects with repeated keys.

        Raises Indivisible if it is entangled with others, and what expansion raises.
        """
        known, record = self._known, self._begun()
        nodes = self._processor.expand(element)
        part = self._part(element.span, nodes, repeats, known.uses)
        if record.shadows != known.shadows or record.problems or record.prefixes:
            raise Indivisible
        if self._local.asked or (part.notes.uses and not known.uses):
            raise Indivisible
        if not all(_within(span, element.span) for span in part.places()):
            raise Indivisible
        return part

    def _begun(self) -> ExpansionRecord:
        """Begin another part, and return the record of what is noted in it."""
        self._count += 1
        processor, known = self._processor, self._known
        record = ExpansionRecord(shadows=dict(known.shadows), uses=dict(known.uses))
        processor.record, processor.repeated = record, {}
        return record

    def _unplaced(
        self, element: Unplaced, compiler: ElementCompiler, outer: Context, key: str
    ) -> Part:
        """Read *element* under *key* of the object with the context *outer*, by PyLD if need be."""
        self._begun()
        blanks, watch = DeferredBlankNodes(), LossObserver()
        group = compiler.state(element, outer, key, blanks, watch)
        if group is None:
            placed, repeats = element.placed()
            return self.part(placed, repeats)
        count = blanks.count
        triples = {triple: triple for triple in group.triples}
        nodes = {node: node for node in group.described}
        losing = watch.losses or watch.within or self._processor.record.unprefixed
        noticed = PartObservations(
            self._processor.record, self._known.uses, watch, Triples(blanks), blanks, (), {}
        )
        return Part(
            element.span,
            LazyPlaces(triples, lambda triple: group.spans[triple]),
            LazyPlaces(nodes, lambda node: group.nodes[node]),
            tuple((node, DESCRIBED, self._graph) for node in nodes),
            LazyPlaces(first_statements(triples), lambda triple: group.spans[triple]),
            LazyPlaces(first_nodes(nodes), lambda node: group.nodes[node].best),
            tuple(blanks.order),
            (count, count, count),
            noticed.notes(self._compared)[0] if losing else NOTHING,
        )

    def _take(self, elements: Array, outer: Context, key: str) -> None:
        processor, hull = self._processor, self._hull
        repeated = processor.repeated
        self._known = ExpansionRecord(shadows=dict(hull.shadows), uses=dict(hull.uses))
        compiler = ElementCompiler(processor)
        for index, element in enumerate(elements):
            if isinstance(element, Unplaced):
                self.parts.append(self._unplaced(element, compiler, outer, key))
            elif isinstance(element, Object):
                self.parts.append(self.part(element, self._repeated(element)))
            else:
                raise Indivisible
            # A large text is in memory but once.
            elements[index] = None
        processor.record, processor.repeated = hull, repeated

    def _repeated(self, element: Object) -> list[Object]:
        """Return the objects in *element* with repeated keys, in the order of their discovery."""
        first = bisect_left(self._repeats, element.start, key=lambda each: each[0])
        after = bisect_left(self._repeats, element.end, key=lambda each: each[0])
        inside = sorted(self._repeats[first:after], key=lambda each: each[1])
        return [each for _, _, each in inside]

    def _part(
        self, whole: Span, nodes: list[Any], repeats: Collection[Object], known: Collection[int]
    ) -> Part:
        """Make a part of expanded *nodes*; the contexts at *known* are named elsewhere."""
        if not all(isinstance(node, Expanded) for node in nodes):
            raise Indivisible
        processor, blanks, watch = self._processor, DeferredBlankNodes(), LossObserver()
        triples = Triples(blanks, watch)
        triples.add(nodes, whole)
        stated = len(blanks.order)
        record, origins = processor.record, processor.repeated
        noticed = PartObservations(record, known, watch, triples, blanks, repeats, origins)
        if whole != self._whole and any(each is processor.around for each in noticed.owners()):
            raise Indivisible
        notes, dropped, strayed = noticed.notes(self._compared)
        if self._compared.looked_up >= LOOKED_UP:
            raise Indivisible
        return Part(
            whole,
            triples.spans,
            triples.nodes,
            tuple((node, DESCRIBED, self._graph) for node in triples.nodes),
            terms(triples.spans),
            namespaces(triples.nodes),
            tuple(blanks.order),
            (stated, dropped, strayed),
            notes,
        )


def _within(inner: Span, outer: Span) -> bool:
    return outer.start <= inner.start and inner.end <= outer.end
