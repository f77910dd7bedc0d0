"""Findings as diagnostics of the Reviewdog Diagnostic Format (proto/rdf/reviewdog.proto).

Columns count bytes of UTF-8 from one, and ends exclude. A suggestion is of whole lines: reviewdog
can offer several that begin or end within a line neither together nor with one click.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Mapping
from functools import cached_property
from itertools import accumulate
from typing import Any

from kinlint.edits import Edit, applied
from kinlint.errors import SourceError
from kinlint.finding import Finding, Fix
from kinlint.reporters.excerpt import bounds
from kinlint.reporters.hunk import edits_by_source
from kinlint.rule import Applicability, Severity
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import KINLINT

SOURCE: Mapping[str, str] = {"name": "kinlint", "url": KINLINT}
LINES = 20
CHARACTERS = 10_000
"""A suggestion of more than so many lines or characters is no help in a comment."""
_SEVERITIES = {Severity.ERROR: "ERROR", Severity.WARNING: "WARNING", Severity.INFO: "INFO"}


class Diagnostics:
    """Makes diagnostics; remembers what it computed for each source.

    *unsafe* tells that unsafe fixes are suggested like safe ones.
    """

    def __init__(self, *, unsafe: bool | None = None) -> None:
        self._least = Applicability.UNSAFE if unsafe else Applicability.SAFE
        self._columns: dict[str, _Columns] = {}

    def finding(self, finding: Finding) -> dict[str, Any]:
        """The `diagnostic` of *finding*."""
        made: dict[str, Any] = {
            "message": finding.message,
            "location": self._location(finding.location),
            "severity": _SEVERITIES[finding.severity],
            "code": {"value": finding.rule.code, "url": finding.rule.iri},
        }
        fix = finding.fix(self._least)
        if fix and (suggested := suggestion(fix, finding.location.source.name)):
            made["suggestions"] = [suggested]
        if finding.related:
            made["related_locations"] = [
                {"message": one.message, "location": self._location(one.location)}
                for one in finding.related
            ]
        return made

    def error(self, error: SourceError) -> dict[str, Any]:
        """The `diagnostic` of a file that cannot be read."""
        location: dict[str, Any] = {"path": error.name}
        if error.line is not None:
            start = {"line": error.line}
            location["range"] = {
                "start": start | ({"column": error.column} if error.column else {})
            }
        return {"message": error.cause, "location": location, "severity": "ERROR"}

    def _location(self, location: Location) -> dict[str, Any]:
        source = location.source
        if source.name not in self._columns:
            self._columns[source.name] = _Columns(source)
        columns = self._columns[source.name]
        ends = (columns.position(offset) for offset in location.span)
        return {"path": source.name, "range": dict(zip(("start", "end"), ends, strict=True))}


class _Columns:
    """Positions in one source in bytes."""

    def __init__(self, source: SourceText) -> None:
        self._source = source

    def position(self, offset: int) -> dict[str, int]:
        line = self._source.position(offset).line
        start = self._source.line_starts[line - 1]
        return {"line": line, "column": self._bytes(offset) - self._bytes(start) + 1}

    def _bytes(self, offset: int) -> int:
        """The bytes before *offset*."""
        places, extra = self._wide
        return offset + extra[bisect_left(places, offset)]

    @cached_property
    def _wide(self) -> tuple[list[int], list[int]]:
        """Return the offsets of multi-byte characters, and their extra bytes, cumulated."""
        text = self._source.text
        places = [match.start() for match in re.finditer(r"[^\x00-\x7f]", text)]
        more = (len(text[at].encode("utf-8", "surrogatepass")) - 1 for at in places)
        return places, list(accumulate(more, initial=0))


def suggestion(fix: Fix, name: str) -> dict[str, Any] | None:
    """Return *fix* as whole lines of the file called *name*; None if one comment cannot hold it.

    That is so if it changes other files, too, or much of this one.
    """
    changes = list(edits_by_source(fix))
    if len(changes) != 1 or changes[0][0].name != name:
        return None
    ((source, edits),) = changes
    first, last = (source.position(at).line for at in (edits[0].span.start, edits[-1].span.end))
    text = _lines(source, first, last, edits)
    if text == "":
        # Nothing in the place of lines could mean one that is empty, or none: take one more.
        first, last = (first, last + 1) if last < len(source.line_starts) else (first - 1, last)
        text = _lines(source, first, last, edits) if first else None
    if text is None:
        return None
    return {"range": {"start": {"line": first}, "end": {"line": last}}, "text": text}


def _lines(source: SourceText, first: int, last: int, edits: list[Edit]) -> str | None:
    """Lines *first* to *last* after *edits*, without the last line end; None if that is much."""
    start, end = bounds(source, first)[0], bounds(source, last)[1]
    if last - first >= LINES or end - start > CHARACTERS:
        return None
    moved = [Edit(Span(span.start - start, span.end - start), new) for span, new in edits]
    return applied(source.text[start:end], moved)
