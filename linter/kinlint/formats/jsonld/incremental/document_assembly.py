"""Puts a document together from what its parts say."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

from kinlint.addresses import document_iri
from kinlint.document import Document, SourceMap
from kinlint.formats.jsonld.expansion_record import Shadow
from kinlint.formats.jsonld.format import JSONLD
from kinlint.formats.jsonld.incremental.blank_labels import Labelling, Named
from kinlint.formats.jsonld.incremental.part import Notes, shifted
from kinlint.formats.jsonld.incremental.part_order import Arrangement
from kinlint.formats.jsonld.incremental.part_statements import Stating
from kinlint.formats.jsonld.incremental.shifted_places import (
    ASIDE,
    ShiftedNodeSpans,
    ShiftedTripleSpans,
    numbered,
)
from kinlint.formats.jsonld.loss_report import shadowed, sort_key, state_losses, state_uses
from kinlint.formats.jsonld.losses import Loss, LossWatch
from kinlint.formats.source_layer import SourceLayer
from kinlint.text import SourceText, Span


@dataclass(frozen=True, slots=True, eq=False)
class Assembly:
    """A document, and those of its parts that have blank nodes, `named`."""

    document: Document
    named: Named


def assembled(source: SourceText, given: Arrangement, stating: Stating, known: Named) -> Assembly:
    """The document that the *given* parts of *source* make up; parts that are *known* keep names.

    *stating* is what read them.
    """
    parts, shifts = given.parts, given.shifts
    labelling = Labelling(source.name, parts)
    layer = SourceLayer(document_iri(source.name), labelling.blanks)
    layer.state_file(JSONLD.name, source.name, Span(0, len(source.text)))
    file = tuple(layer.triples)
    layer.state_namespaces(_first((part.namespaces for part in parts), shifts))
    layer.state_terms(_first((part.terms for part in parts), shifts))
    uses = (use for notes in given.notes() for use in notes.uses)
    state_uses(layer, uses, stating.release)
    named = labelling.finish(known)
    arranged = Arrangement([named[each][1] if each.asked else each for each in parts], shifts)
    state_losses(layer, _losses(list(arranged.notes())))
    stated = numbered([part.spans for part in arranged.parts])
    described = (triple for part in arranged.parts for triple in part.described)
    for triple in chain(file, described, layer.triples):
        stated.setdefault(triple, ASIDE)
    nodes = ShiftedNodeSpans(arranged, layer)
    places = SourceMap(ShiftedTripleSpans(stated, arranged, layer, nodes), nodes)
    prefixes = stating.prefixes
    document = Document(source, layer.document, tuple(stated), places, prefixes, format=JSONLD)
    return Assembly(document, named)


def _first(found: Iterable[Mapping[str, Span]], shifts: Sequence[int]) -> dict[str, Span]:
    """Merge what is *found* in the parts, keeping the first place of each name."""
    first: dict[str, Span] = {}
    for places, by in zip(found, shifts, strict=True):
        if not places.keys() <= first.keys():
            for name, span in places.items():
                if name not in first:
                    first[name] = shifted(span, by)
    return first


def _losses(notes: Sequence[Notes]) -> list[Loss]:
    """All losses in the order of the text; what is only lost in the whole file is found here."""
    watch = LossWatch()
    shadows: dict[Shadow, Span] = {}
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
