"""Canonical names of texts, however those that include them call them."""

from __future__ import annotations

from pathlib import Path

from kinlint.files.pathglob import absolute


class Paths(dict[str, Path]):
    """The files that texts are called after, by the names of the texts."""

    def __missing__(self, name: str) -> Path:
        path = self[name] = absolute(name)
        return path
