"""The file of a baseline: JSON in a fixed order, so that two of them differ where findings do."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import Any, NoReturn

from kinlint.baseline.entry_identity import Entry
from kinlint.errors import SourceError, UsageError
from kinlint.files.atomic_write import replacement
from kinlint.files.pathname import missing, shown
from kinlint.formats.decoding import decode
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.json_text.json_values import Array, Object, Text
from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText, Span

DEFAULT = "kinlint-baseline.json"
VERSION = 1
FIELDS = ("path", "rule", "entity", "message", "fingerprint")


@dataclass(frozen=True)
class Baseline:
    """The entries of a baseline file."""

    path: Path
    """The path of the file."""
    source: SourceText
    """Its text."""
    entries: tuple[Entry, ...] = ()
    """The findings that it lists."""
    composed: tuple[str, ...] = ()
    """Paths of the files that composed a model when they were found, if more than one."""


def read_baseline(path: Path, origin: str) -> Baseline:
    """The baseline at *path*, which *origin* asks for.

    Raises UsageError with the place and the cause where there is none.
    """
    name = shown(path)
    try:
        if path.is_dir():
            raise UsageError(f"{origin}: {name}: is a directory")
        source = decode(name, path.read_bytes())
    except FileNotFoundError:
        raise UsageError(f"{origin}: {name}: {missing(path)}") from None
    except OSError as error:
        raise UsageError(f"{origin}: {name}: {error.strerror or error}") from None
    except SourceError as error:
        raise UsageError(f"{origin}: {error}") from None
    try:
        said = parse(source).value
        entries = tuple(_entries(source, said))
        return Baseline(path, source, entries, tuple(_composed(source, said)))
    except SourceError as error:
        raise UsageError(f"{origin}: {error}") from None


def _entries(source: SourceText, said: Any) -> Iterator[Entry]:
    if source.misread:
        _fail(source, source.misread[0][0], "not UTF-8")
    whole = Span(0, 0)
    if not isinstance(said, Object) or "findings" not in said:
        _fail(source, whole, "not a baseline: expected an object with version and findings")
    if said.get("version") != VERSION or said["version"] is True:
        _fail(source, said.span, f"expected version {VERSION} of the format of baselines")
    if not isinstance(said["findings"], Array):
        _fail(source, said.span, "findings: expected an array")
    for number, one in enumerate(said["findings"]):
        if not isinstance(one, Object):
            _fail(source, said["findings"].element_span(number), "expected a finding, an object")
        yield _entry(source, one)


def _composed(source: SourceText, said: Any) -> Iterator[str]:
    files = said.get("composed", [])
    for each in files if isinstance(files, list) else (files,):
        if not isinstance(each, Text):
            _fail(source, said.span, "composed: expected an array of strings")
        yield str(each)


def _entry(source: SourceText, said: Object) -> Entry:
    texts = []
    for name in FIELDS:
        value = said.get(name)
        if not isinstance(value, Text):
            key = said.key(name)
            wrong = f"{name}: expected a string" if key else f"a finding without '{name}'"
            _fail(source, key.span if key else said.span, wrong)
        texts.append(str(value))
    entity = said["entity"]
    path, rule, about, message, fingerprint = texts
    return Entry(path, rule, about, message, fingerprint, span=Span(entity.start, entity.end))


def _fail(source: SourceText, span: Span, cause: str) -> NoReturn:
    place = source.position(span.start)
    raise SourceError(source.name, cause, place.line, place.column)


def write_baseline(path: Path, entries: Iterable[Entry], composed: Collection[str]) -> None:
    """Write *entries* to the file at *path*, as a whole or not at all.

    *composed* are the files of a model, without all of which some may not be found.

    Raises UsageError where that cannot be.
    """
    ordered = sorted(entries, key=lambda one: one.key)
    listed = [{name: getattr(one, name) for name in FIELDS} for one in ordered]
    said: dict[str, object] = {"version": VERSION, "findings": listed}
    if len(composed) > 1 and listed:
        said = {"version": VERSION, "composed": sorted(composed), "findings": listed}
    data = f"{json.dumps(said, indent=2, ensure_ascii=False)}\n".encode("utf-8", "replace")
    try:
        if path.is_file() and path.read_bytes() == data:
            return
        with replacement(path) as stream:
            stream.write(data)
    except OSError as error:
        raise UsageError(f"cannot write {shown(path)}: {error.strerror or error}") from None
