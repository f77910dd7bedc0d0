"""Paths of files relative to the top of their repository, as servers look them up."""

from __future__ import annotations

import os
from pathlib import Path

from kinlint.report import STDIN_NAMES
from kinlint.reporters.sarif.version_control import repository_top


class Paths:
    """The files of one report, whose relative names start at *root*.

    Paths start at the top of the working tree that *root* is in, or at *root* if it is in none, and
    have forward slashes. A file elsewhere is called by its absolute path.
    """

    def __init__(self, root: str) -> None:
        self._root = root
        self._top = repository_top(root) or root
        self._known: dict[str, str] = {}

    def relative(self, name: str) -> str:
        """The path of the file called *name*; standard input without a name keeps what it has."""
        if name not in self._known:
            self._known[name] = name if name in STDIN_NAMES else self._from_top(name)
        return self._known[name]

    def _from_top(self, name: str) -> str:
        path = Path(os.path.normpath(os.path.join(self._root, name)))  # noqa: PTH118
        return (path.relative_to(self._top) if path.is_relative_to(self._top) else path).as_posix()
