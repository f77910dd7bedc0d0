"""Findings as diagnostics of the Language Server Protocol."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from lsprotocol import types

from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.sarif.rule_descriptors import web_address
from kinlint.rule import Severity
from kinlint.server.request_context import Places
from kinlint.server.session import Session
from kinlint.text import Location, SourceText, Span

SOURCE = "kinlint"
MOST_RELATED = 20
"""A finding may speak of thousands of places; nobody looks at more in an editor."""
SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.INFO: types.DiagnosticSeverity.Information,
}


@dataclass(frozen=True)
class FileDiagnostics:
    """The diagnostics of a file."""

    items: tuple[types.Diagnostic, ...] = ()
    """The diagnostics."""
    source: SourceText | None = None
    """The text that their ranges refer to."""
    version: int | None = None
    """The version of the open buffer; None if the file is not open."""

    @cached_property
    def result_id(self) -> str:
        """Return a digest that is equal exactly for equal diagnostics."""
        return hashlib.sha256(repr(self.items).encode("utf-8", "surrogatepass")).hexdigest()[:16]


def diagnostics_by_file(
    session: Session, places: Places, *, related: bool
) -> Mapping[Path, FileDiagnostics]:
    """The diagnostics of each file of the model of *session*, or that it reads along.

    With *related* places, if the client can show them.
    """
    texts: dict[Path, SourceText] = {}
    items: dict[Path, list[types.Diagnostic]] = {}
    for source in session.model.sources:
        texts[places.path(source.name)] = source
    errors: Sequence[SourceError] = session.model.errors
    if (examination := session.examination) is not None:
        for document in examination.documents:
            for source in document.sources:
                texts.setdefault(places.path(source.name), source)
        errors = examination.report.errors
        for finding in examination.report.findings:
            path = places.path(finding.location.source.name)
            items.setdefault(path, []).append(diagnostic(finding, places, related=related))
    for error in errors:
        path = places.path(error.name)
        items.setdefault(path, []).append(error_diagnostic(error, texts.get(path), places))
    beside = {places.path(source.name) for source in session.model.beside}
    return {
        path: FileDiagnostics(tuple(items.get(path, ())), texts.get(path), _version(places, path))
        for path in dict.fromkeys((*session.model.paths.values(), *texts, *items))
        if path not in beside
    }


def _version(places: Places, path: Path) -> int | None:
    buffer = places.snapshot.buffers.get(path)
    return None if buffer is None else buffer.version


def diagnostic(finding: Finding, places: Places, *, related: bool) -> types.Diagnostic:
    """Convert *finding* to a diagnostic."""
    return types.Diagnostic(
        range=places.range(finding.location),
        message=finding.message,
        severity=SEVERITIES[finding.severity],
        code=finding.rule.code,
        code_description=types.CodeDescription(href=web_address(finding.rule.iri)),
        source=SOURCE,
        related_information=list(_related(finding, places)) if related else None,
        data={"iri": finding.iri, "fingerprint": finding.fingerprint},
    )


def error_diagnostic(
    error: SourceError, source: SourceText | None, places: Places
) -> types.Diagnostic:
    """The reason that a file cannot be read, where it is known, else at its beginning."""
    source = source or SourceText(error.name, "")
    line = min(max(error.line or 1, 1), len(source.line_starts))
    start = min(source.line_starts[line - 1] + max((error.column or 1) - 1, 0), len(source.text))
    end = min(start + 1, len(source.text))
    return types.Diagnostic(
        range=places.range(Location(source, Span(start, end))),
        message=error.cause,
        severity=types.DiagnosticSeverity.Error,
        source=SOURCE,
    )


def _related(finding: Finding, places: Places) -> Iterator[types.DiagnosticRelatedInformation]:
    """The places that *finding* speaks of, then those of what it rests on, each once.

    What a finding rests on is left out where its reason says it in a sentence.
    """
    texts = [(each.location, each.message or finding.message) for each in finding.related]
    texts += [(each.location, f"{each.rule.code}: {each.message}") for each in finding.consequences]
    texts += [
        (each.location, f"because: {each.statement}")
        for each in (() if finding.reason else finding.because)
        if each.location is not None
    ]
    seen = {(finding.location.source.name, finding.location.span)}
    for place, text in texts:
        key = place.source.name, place.span
        if key not in seen and len(seen) <= MOST_RELATED:
            seen.add(key)
            yield types.DiagnosticRelatedInformation(places.location(place), text)
