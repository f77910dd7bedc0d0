"""Collects what one part of a file leaves to be said in the source layer."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.expansion_record import Record
from kinlint.formats.jsonld.incremental.part import NOTHING, Asked, Notes
from kinlint.formats.jsonld.loss_report import Comparison, LossReport
from kinlint.formats.jsonld.losses import LossWatch
from kinlint.formats.jsonld.traced_values import Origin
from kinlint.formats.jsonld.triples import Triples


class Noticed(NamedTuple):
    """Observations of a part while it was expanded and stated.

    Of the contexts that `record` says are used, those that are `known` are named elsewhere.
    """

    record: Record
    known: Collection[int]
    watch: LossWatch
    triples: Triples
    blanks: Asked
    repeats: Collection[Object]
    origins: Mapping[int, Origin]

    def owners(self) -> Iterator[Origin]:
        """The objects of the nodes of which something is lost."""
        yield from (drop.origin.owner for drop in self.record.drops.values())
        strays = (stray.origin for stray in self.record.strays.values())
        repeated = (self.origins.get(id(each)) for each in self.repeats)
        yield from (origin.owner for origin in (*strays, *repeated) if origin is not None)

    def notes(self, compared: Comparison) -> tuple[Notes, int, int]:
        """Return the notes, and the number of blank nodes asked for before each of two steps."""
        record, watch, order = self.record, self.watch, self.blanks.order
        report = LossReport(record, watch, self.triples, compared)
        others = [*report.types(), *report.dropped()]
        dropped = len(order)
        others += report.strays()
        strayed = len(order)
        others += [*report.contexts(), *report.duplicates(self.repeats, self.origins)]
        notes = Notes(
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
