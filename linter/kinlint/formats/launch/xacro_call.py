"""Calls of xacro in launch files, and the commands by which shells call it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from kinlint.text import Span

UNKNOWN = "\0"
"""Character that stands for a value which only a running launch file knows."""
HERE, SHARE = "here://", "package://"
"""Beginnings of paths below the directory of the launch file, and below that of a package."""
_PROGRAM = re.compile(r"(?:^|[\s/(\"'\0])xacro(?:\.py)?[\"']?(?=[\s\0])")
_WORD = re.compile(r"[^\s\"']+")
_ARGUMENT = re.compile(r"([A-Za-z_][\w.-]*):=")
ENDINGS = (".xacro", ".urdf")


class XacroCall(NamedTuple):
    """Expansion of a xacro file, with the arguments that are passed."""

    file: str
    """Path of the file, from `HERE`, `SHARE` or the root."""
    span: Span
    """Place of the call."""
    arguments: tuple[tuple[str, Span], ...]
    """Names of the arguments, with their places."""


def command_call(text: str, places: list[int], whole: Span) -> XacroCall | None:
    """Return the call in *text*, a command line; None if it calls no xacro, or no known file.

    *places* has the offset of each character, -1 for those that are written otherwise.
    """
    program = _PROGRAM.search(text)
    if program is None:
        return None
    words = list(_WORD.finditer(text, program.end()))
    file = next((each for each in words if ":=" not in each[0]), None)
    if file is None or UNKNOWN in file[0] or not file[0].endswith(ENDINGS):
        return None
    return XacroCall(file[0], whole, tuple(_arguments(words, places, whole)))


def _arguments(
    words: list[re.Match[str]], places: list[int], whole: Span
) -> Iterator[tuple[str, Span]]:
    for word in words:
        if (match := _ARGUMENT.match(word[0])) is None:
            continue
        at = places[word.start() : word.start() + len(match[1])]
        known = at and at[0] >= 0 and at == list(range(at[0], at[0] + len(at)))
        yield match[1], Span(at[0], at[0] + len(at)) if known else whole
