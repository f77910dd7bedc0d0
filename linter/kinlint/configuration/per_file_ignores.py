"""Entries of `per-file-ignores`: the files, places or entities in which rules are ignored."""

from __future__ import annotations

from pathlib import Path

from kinlint.files.pathglob import Glob
from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText, Span


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
