"""Display of characters on a terminal: replacements for unprintable ones, and widths in columns."""

from __future__ import annotations

import re
import unicodedata

TAB_WIDTH = 4
_JOINERS = "\u200c\u200d"
_SURROGATES = re.compile("[\ud800-\udfff]")


def printable(text: str, *, unicode: bool = True) -> str:
    """*text* on one line as a terminal may safely print it.

    A tab is four columns. Control characters, and the invisible ones that reorder or hide text,
    are written as escapes; without *unicode* so is everything beyond ASCII.
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(_shown(char, unicode=unicode) for char in text)


def width(text: str) -> int:
    """The columns that shown *text* takes: two for East Asian wide characters, none for marks."""
    if text.isascii():
        return len(text)
    return sum(_width(char) for char in text)


def fold_lines(text: str, *, unicode: bool = True) -> str:
    """*text* on one line: line ends and the blanks round them become one blank."""
    lines = (line.strip(" \t") for line in text.splitlines())
    return printable(" ".join(line for line in lines if line), unicode=unicode)


def replace_surrogates(text: str) -> str:
    """Return *text* with lone surrogates, which no encoding can write, replaced."""
    return text if text.isascii() else _SURROGATES.sub("\ufffd", text)


def _shown(char: str, *, unicode: bool) -> str:
    if char == "\t":
        return " " * TAB_WIDTH
    if char.isprintable() and (unicode or char.isascii()):
        return char
    category = unicodedata.category(char)
    if unicode and (char in _JOINERS or category in {"Zs", "Co"}):
        return char
    if category == "Cs":
        return "\ufffd" if unicode else "?"
    code = ord(char)
    return f"\\u{code:04x}" if code <= 0xFFFF else f"\\U{code:08x}"  # noqa: PLR2004


def _width(char: str) -> int:
    if char.isascii():
        return 1
    if unicodedata.category(char) in {"Mn", "Me", "Cf"}:
        return 0
    return 2 if unicodedata.east_asian_width(char) in "WF" else 1
