"""Entries of `per-file-ignores` and `per-file-target`: what holds in some files alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

from kinlint.configuration.config_text import quoted_key_span
from kinlint.files.pathglob import Glob
from kinlint.light_dataclasses import dataclass, replace
from kinlint.text import SourceText, Span

FileTargets: TypeAlias = tuple[tuple[Glob, tuple[str, ...]], ...]
"""Globs, each with the consumers of the files that it covers."""


@dataclass(frozen=True, slots=True)
class PerFile:
    """An entry of `per-file-ignores`: selectors for files, a place in files, or an entity."""

    key: str
    """Key of the entry, as written."""
    origin: str
    """Name of the file or option that contains it."""
    glob: Glob
    """Files that it is for."""
    selectors: tuple[str, ...]
    """Selectors of the rules to ignore."""
    pointer: str | None = None
    """JSON Pointer (RFC 6901) to the place in these files; None for all of a file."""
    iri: str | None = None
    """IRI of the entity that it is for; None for all."""
    place: tuple[SourceText, Span] | None = None
    """Text of the configuration and place of the key in it; None for an option."""


def per_file(key: str, selectors: tuple[str, ...], origin: str, root: Path) -> PerFile:
    """Parse *key*: `<iri>`, `glob#/json/pointer`, `glob` or `!glob`."""
    if key.startswith("<") and key.endswith(">"):
        return PerFile(key, origin, Glob(root, "/**"), selectors, iri=key[1:-1])
    pattern, mark, pointer = key.partition("#/")
    place = f"/{pointer}" if mark else None
    return PerFile(key, origin, Glob(root, pattern), selectors, pointer=place)


def per_file_ignores(
    said: Mapping[str, list[str]] | None, origin: str, root: Path, source: SourceText | None
) -> tuple[PerFile, ...] | None:
    """Return the entries that *said* has, with their places in the text *source* of *origin*."""
    if said is None:
        return None
    entries = tuple(per_file(key, tuple(sels), origin, root) for key, sels in said.items())
    if source is None:
        return entries
    return tuple(replace(one, place=(source, quoted_key_span(source, one.key))) for one in entries)


def per_file_targets(said: Mapping[str, Sequence[str]] | None, root: Path) -> FileTargets | None:
    """Return the consumers of the files that each pattern below *root* covers; None of nothing."""
    if said is None:
        return None
    return tuple((Glob(root, pattern), tuple(names)) for pattern, names in said.items())
