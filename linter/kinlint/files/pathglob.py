"""Glob patterns over paths, anchored at the directory of whoever wrote them."""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path, PurePath, PureWindowsPath

from kinlint.files import url_mirror
from kinlint.light_dataclasses import dataclass

MAGIC = re.compile(r"[*?\[{]")


@dataclass(frozen=True)
class Glob:
    """A pattern below `root`.

    One without a slash matches a file or directory of that name at any depth, one with a slash
    the path from `root`. `*` stays within a name, `**` spans directories, `{a,b}` is either. A
    leading `!` turns the pattern round. Composed and decomposed letters are the same, and on
    Windows large and small ones.
    """

    root: PurePath
    """Directory that the pattern is relative to."""
    pattern: str
    """Pattern as written."""

    def covers(self, path: PurePath) -> bool:
        """Tell whether *path*, which is absolute, or a directory between it and `root` matches."""
        below = [each for each in path.parents if each.is_relative_to(self.root)]
        return any(map(self._found, (path, *below))) is not self.pattern.startswith("!")

    def matches(self, path: PurePath) -> bool:
        """Tell whether *path* itself matches."""
        return self._found(path) is not self.pattern.startswith("!")

    def _found(self, path: PurePath) -> bool:
        return bool(self._regex.fullmatch(_composed(path.name if self._named else path.as_posix())))

    @cached_property
    def _named(self) -> bool:
        return "/" not in self._plain

    @cached_property
    def _plain(self) -> str:
        return _composed(self.pattern.removeprefix("!").removeprefix("./").rstrip("/"))

    @cached_property
    def _regex(self) -> re.Pattern[str]:
        root, below = self.root, self._plain
        flags = re.DOTALL | (re.IGNORECASE if isinstance(root, PureWindowsPath) else 0)
        if self._named or type(root)(below).is_absolute():
            return re.compile(translate(below), flags)
        while below.startswith("../"):
            root, below = root.parent, below[3:]
        start = re.escape(_composed(root.as_posix().rstrip("/")))
        return re.compile(f"{start}/{translate(below)}", flags)


def _composed(text: str) -> str:
    """Return *text* in normal form C, since macOS may give names in form D."""
    return text if text.isascii() else unicodedata.normalize("NFC", text)


def translate(pattern: str) -> str:
    """Return the regular expression of a glob *pattern* over a path with forward slashes."""
    return "".join(_pieces(pattern))


def _pieces(pattern: str) -> Iterator[str]:
    at, depth = 0, 0
    while at < len(pattern):
        char = pattern[at]
        if pattern.startswith("**/", at):
            yield "(?:.*/)?"
            at += 3
        elif pattern.startswith("**", at):
            yield ".*"
            at += 2
        elif char == "[" and (end := pattern.find("]", at + 2)) > 0:
            yield _class(pattern[at + 1 : end])
            at = end + 1
        elif char == "{" and pattern.find("}", at) > 0:
            yield "(?:"
            at, depth = at + 1, depth + 1
        elif depth and char in ",}":
            yield "|" if char == "," else ")"
            at, depth = at + 1, depth - (char == "}")
        else:
            yield {"*": "[^/]*", "?": "[^/]"}.get(char) or re.escape(char)
            at += 1


def _class(inside: str) -> str:
    """Return the regular expression of `[inside]`.

    What is no range, such as `z-a`, means itself.
    """
    escaped = inside.replace("\\", "\\\\").replace("[", "\\[")
    made = f"[{'^' + escaped[1:] if inside[0] in '!^' else escaped}]"
    try:
        re.compile(made)
    except re.error:
        return re.escape(f"[{inside}]")
    return made


def absolute(path: str | Path) -> Path:
    """Return *path* from the root of the file system, without `.` and `..`, links kept.

    The name of a file by URL means its mirror.
    """
    if url_mirror.in_use() and isinstance(path, str) and (found := url_mirror.path_of(path)):
        return found
    return Path(os.path.abspath(path))  # noqa: PTH100  Path.resolve would follow links
