"""Reads a file whose text is almost the one that was read before."""

from __future__ import annotations

from kinlint.document import Document
from kinlint.formats.json_text.json_outline import NotOutlined, outline
from kinlint.formats.json_text.json_parser import ArrayElement, parse
from kinlint.formats.json_text.json_values import Object, ParsedJson
from kinlint.formats.jsonld.active_context import FAULTS
from kinlint.formats.jsonld.incremental.alignment import align, difference
from kinlint.formats.jsonld.incremental.document_assembly import Assembly, assemble
from kinlint.formats.jsonld.incremental.part import Arrangement, Part
from kinlint.formats.jsonld.incremental.part_expander import Indivisible
from kinlint.formats.jsonld.incremental.part_statements import PartStatements
from kinlint.formats.jsonld.missing_context import CONTEXT
from kinlint.formats.jsonld.reader import undisturbed
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import dataclass, replace
from kinlint.text import SourceText, Span

__all__ = ["Indivisible", "Reading", "read_divided", "reread"]


@dataclass(frozen=True, slots=True, eq=False)
class Division:
    """Text in parts: the elements of its outermost graph, and the hull around them."""

    stating: PartStatements
    """Reads the parts."""
    elements: Arrangement
    """The elements in their order."""
    hull: Part
    """The hull as it was read first."""
    end: int
    """End of the graph."""

    def assembled(
        self, source: SourceText, before: Assembly | None = None, *, lasting: bool = False
    ) -> Assembly:
        """Return the document of *source*, which is divided like that.

        Some parts are as they were *before*; if *lasting*, their blank nodes keep their labels.
        """
        end, gap = self.end, self.stating.place

        def move(span: Span) -> Span:
            return Span(*(at if at <= gap.start else at + end - gap.end for at in span))

        hull = self.hull if end == gap.end else self.hull.moved(move)
        given = Arrangement([*self.elements.parts, hull], [*self.elements.shifts, 0])
        return assemble(source, given, self.stating, before, lasting=lasting)


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """A document, and what it takes to read it again."""

    options: ReadOptions
    """Options of reading."""
    division: Division
    """Parts of the text."""
    assembly: Assembly
    """Document made of them."""

    @property
    def document(self) -> Document:
        """The document that `registry.read` would give."""
        return self.assembly.document


def read_divided(source: SourceText, options: ReadOptions) -> Reading:
    """Read *source* part by part.

    Raises Indivisible if it cannot be read like that, perhaps not at all; SourceError if it is no
    JSON.
    """
    with undisturbed():
        parsed = _parsed(source)
        if not isinstance(parsed.value, Object):
            raise Indivisible
        if isinstance(parsed.value.get("@context"), (int, float)):
            raise Indivisible
        stating = PartStatements(source, options)
        try:
            hull = stating.hull(parsed)
        except FAULTS as fault:
            raise Indivisible from fault
        unmoved = Arrangement(stating.parts, [0] * len(stating.parts))
        division = Division(stating, unmoved, hull, stating.place.end)
        return Reading(options, division, division.assembled(source))


def _parsed(source: SourceText) -> ParsedJson:
    """Return *source*, its elements without the places in them unless all have to be known."""
    try:
        outlined = outline(source)
    except NotOutlined:
        return parse(source)
    found = isinstance(outlined.value, Object) and CONTEXT in outlined.value
    return outlined if found else parse(source)


def reread(
    before: Reading, source: SourceText, options: ReadOptions, *, lasting: bool = False
) -> Reading:
    """Read *source*, whose text is almost that of *before*.

    If *lasting*, blank nodes that were there keep their labels. Raises Indivisible if that does not
    help, SourceError if *source* is no JSON.
    """
    last, old = before.document.source, before.division
    if old.stating.exhausted or source.name != last.name or options != before.options:
        raise Indivisible
    if source == last:
        return before
    if source.text == last.text:
        document = replace(before.document, source=source)
        return replace(before, assembly=replace(before.assembly, document=document))
    change = difference(last.text, source.text)
    start = old.stating.place.start
    if change.start <= start or change.old_end >= old.end:
        raise Indivisible
    with undisturbed():
        found = align(old.elements, last.text, source, change, Span(start, old.end))
        try:
            parts = [_part(old, each, found.rest) for each in found.elements]
        except FAULTS as fault:
            raise Indivisible from fault
        shifts = [to - part.whole.start for to, part in zip(found.starts, parts, strict=True)]
        between = Arrangement(parts, shifts)
        arranged = old.elements.replaced(found.first, found.rest, between, change.shift)
        division = replace(old, elements=arranged, end=old.end + change.shift)
        made = division.assembled(source, before.assembly, lasting=lasting)
        return Reading(options, division, made)


def _part(old: Division, element: ArrayElement | int, rest: int) -> Part:
    """Return the part of an element that was parsed now, or that is one of *old*.

    None is there twice: one that is among the *rest* as well gets a twin.
    """
    if not isinstance(element, int):
        return old.stating.part(element.value, element.repeats)
    known = old.elements.parts[element]
    return replace(known) if element >= rest else known
