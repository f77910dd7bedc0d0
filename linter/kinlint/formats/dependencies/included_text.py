"""Reads the text of a file that another file includes, once in a run."""

from __future__ import annotations

from pathlib import Path

from kinlint.files.bounded_read import contents
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText

KEPT = "included text"
"""The first part of the keys under which `ReadOptions.memory` keeps texts."""


def included_text(
    path: Path, reach: ProjectReach, name: str, options: ReadOptions, limit: int
) -> SourceText:
    """Return the text of the file at *path*, of at most *limit* bytes, called *name* in messages.

    It is what `options.overlay` takes the file to hold, or the same object for all who include it.
    *reach* tells which file includes it. Raises `Unreadable` or `SourceError` where it cannot be
    read, or is out of reach.
    """
    reach.require(path)
    text: SourceText | None = options.overlaid_text(path) or options.memory.get((KEPT, path))
    if text is None:
        text = options.memory[KEPT, path] = decode(name, contents(path, reach.near, limit))
    return text


def keep(path: Path, source: SourceText, options: ReadOptions) -> None:
    """Let *source* be the text of the file at *path* for those who include it later in the run."""
    options.memory.setdefault((KEPT, path), source)
