"""The context of a request: an open file and the analysis of the model it belongs to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from pathlib import Path

from lsprotocol import types

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.files.pathglob import absolute
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass, field
from kinlint.pipeline.analyzer import Examination
from kinlint.server.buffers import Buffer, uri_of
from kinlint.server.frozen_state import FrozenState
from kinlint.server.position_codec import PositionCodec
from kinlint.server.session import Session
from kinlint.text import Location, SourceText, Span


@dataclass
class Places:
    """The places of the texts of a model as the client has them."""

    snapshot: FrozenState
    """The open texts, folders and settings."""
    encoding: str
    """The encoding of positions that was agreed on."""
    paths: dict[str, Path]
    """The files of texts whose names are not enough to find them."""
    _measures: dict[str, tuple[SourceText, PositionCodec]] = field(default_factory=dict)

    def path(self, name: str) -> Path:
        """The file of the text called *name*."""
        return self.paths.get(name) or absolute(name)

    def buffer(self, name: str) -> Buffer | None:
        """Return the open buffer of the text called *name*, or None."""
        return self.snapshot.buffers.get(self.path(name))

    def uri(self, name: str) -> str:
        """Return the URI by which the client knows the text called *name*."""
        buffer = self.buffer(name)
        return uri_of(self.path(name)) if buffer is None else buffer.uri

    def codec(self, source: SourceText) -> PositionCodec:
        """The measure of *source*."""
        known = self._measures.get(source.name)
        if known is None or known[0] is not source:
            buffer = self.buffer(source.name)
            marked = buffer is not None and buffer.marked
            known = source, PositionCodec(source, self.encoding, marked=marked)
            self._measures[source.name] = known
        return known[1]

    def range(self, place: Location) -> types.Range:
        """Convert *place* to a range in its file."""
        return self.codec(place.source).range(place.span)

    def location(self, place: Location) -> types.Location:
        """Convert *place* to a location."""
        return types.Location(self.uri(place.source.name), self.range(place))


@dataclass(frozen=True)
class RequestContext:
    """A file, and what was found in the model of which it is a part.

    Only where a view is handed out by `consult`, and only there, the store and the builder of
    the examination may be asked.
    """

    uri: str
    """The URI by which the client knows the file."""
    path: Path
    """Its path."""
    source: SourceText
    """Its text."""
    version: int | None
    """The version that the client gave the text; None for a file that is not open."""
    examination: Examination
    """The examination of the model."""
    settings: Settings
    """The settings of the model."""
    rulebook: Rulebook
    """The rules."""
    places: Places
    """The places as the client has them."""
    session: Session
    """The state that the server keeps."""
    cancelled: Callable[[], bool]
    """Test whether something changed: long work asks now and then and raises `Cancelled`, to be
    begun again with the newest text.
    """
    readable: Sequence[Document] = ()
    """The documents of the model, each as it was when it could be read last."""

    @property
    def sources(self) -> tuple[SourceText, ...]:
        """All texts of the model that are linted."""
        return (*self.session.model.sources, *self.session.model.beside)

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """Return the findings in this file."""
        told = self.examination.report.findings
        return tuple(each for each in told if each.location.source.name == self.source.name)

    @cached_property
    def document(self) -> Document | None:
        """Return the document of this file; None if it is only included by others."""
        known = self.examination.documents
        return next((each for each in known if each.source.name == self.source.name), None)

    def offset(self, position: types.Position) -> int:
        """The offset in the text of this file."""
        return self.places.codec(self.source).offset(position)

    def span(self, place: types.Range) -> Span:
        """The span in the text of this file."""
        return self.places.codec(self.source).span(place)

    def range(self, span: Span) -> types.Range:
        """Convert *span* of this file to a range."""
        return self.places.codec(self.source).range(span)

    def location(self, place: Location) -> types.Location:
        """Convert *place*, in any file of the model, to a location."""
        return self.places.location(place)
