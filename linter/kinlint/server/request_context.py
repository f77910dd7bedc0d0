"""What features work on: an open file with the examination of the model it belongs to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from lsprotocol import types

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.files.pathglob import absolute
from kinlint.lint import Examination
from kinlint.model import Finding
from kinlint.server.buffers import Buffer, uri_of
from kinlint.server.frozen_state import Snapshot
from kinlint.server.position_codec import Measure
from kinlint.server.session import Bench
from kinlint.text import Location, SourceText, Span


@dataclass
class Places:
    """The places of the texts of a model as the client has them.

    `paths` are the files of those texts whose names are not enough to find them.
    """

    snapshot: Snapshot
    encoding: str
    paths: dict[str, Path]
    _measures: dict[str, tuple[SourceText, Measure]] = field(default_factory=dict)

    def path(self, name: str) -> Path:
        """The file of the text called *name*."""
        return self.paths.get(name) or absolute(name)

    def buffer(self, name: str) -> Buffer | None:
        """What is open of the file of the text called *name*."""
        return self.snapshot.buffers.get(self.path(name))

    def uri(self, name: str) -> str:
        """What the client calls the file of the text called *name*."""
        buffer = self.buffer(name)
        return uri_of(self.path(name)) if buffer is None else buffer.uri

    def measure(self, source: SourceText) -> Measure:
        """The measure of *source*."""
        known = self._measures.get(source.name)
        if known is None or known[0] is not source:
            buffer = self.buffer(source.name)
            marked = buffer is not None and buffer.marked
            known = source, Measure(source, self.encoding, marked=marked)
            self._measures[source.name] = known
        return known[1]

    def range(self, place: Location) -> types.Range:
        """Where *place* is in its file."""
        return self.measure(place.source).range(place.span)

    def location(self, place: Location) -> types.Location:
        """Where *place* is."""
        return types.Location(self.uri(place.source.name), self.range(place))


@dataclass(frozen=True)
class View:
    """A file, and what was found in the model of which it is a part.

    Only where a view is handed out by `consult`, and only there, the store and the account of the
    examination may be asked. What takes long asks now and then whether it is `cancelled`, since
    something changed, and raises `Cancelled` then: it is begun again with the newest text.
    """

    uri: str
    path: Path
    source: SourceText
    version: int | None
    examination: Examination
    settings: Settings
    rulebook: Rulebook
    places: Places
    bench: Bench
    cancelled: Callable[[], bool]

    @property
    def sources(self) -> tuple[SourceText, ...]:
        """All texts of the model that are linted."""
        return (*self.bench.model.sources, *self.bench.model.beside)

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What was found in this file."""
        told = self.examination.report.findings
        return tuple(each for each in told if each.location.source.name == self.source.name)

    @cached_property
    def document(self) -> Document | None:
        """What the file says by itself; None if it is only read as a part of others, or not."""
        known = self.examination.documents
        return next((each for each in known if each.source.name == self.source.name), None)

    def offset(self, position: types.Position) -> int:
        """The offset in the text of this file."""
        return self.places.measure(self.source).offset(position)

    def span(self, place: types.Range) -> Span:
        """The span in the text of this file."""
        return self.places.measure(self.source).span(place)

    def range(self, span: Span) -> types.Range:
        """Where *span* of this file is."""
        return self.places.measure(self.source).range(span)

    def location(self, place: Location) -> types.Location:
        """Where *place*, in whatever file of the model, is."""
        return self.places.location(place)
