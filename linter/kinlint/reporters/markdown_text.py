"""Text that Markdown takes for nothing but text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from urllib.parse import quote

from kinlint.reporters.display_width import fold_lines, replace_surrogates

_MARKS = re.compile(r"[\\`*_\[\]#|~$>]|:(?=[^\s\d])")
_ENTITIES = str.maketrans({"&": "&amp;", "<": "&lt;", "@": "&#64;"})
"""`@` would call somebody, `<` begin a tag."""


def escaped(text: str) -> str:
    """*text* on one line, to be shown as it is in a paragraph, a list or a cell of a table."""
    return _MARKS.sub(r"\\\g<0>", replace_surrogates(fold_lines(text))).translate(_ENTITIES)


def link(text: str, url: str) -> str:
    """A link that says *text*; no link where there is no *url*."""
    return f"[{escaped(text)}]({url})" if url else escaped(text)


def address(path: str, line: int | None = None) -> str:
    """The path of a file as a relative URL, to *line* of it where servers show that."""
    url = quote(replace_surrogates(path))
    return f"{url}#L{line}" if line else url


def table(headings: tuple[str, ...], rows: Sequence[tuple[str, ...]], right: int) -> str:
    """A table of cells that are Markdown; column number *right* is aligned there."""
    rules = ["--:" if index == right else "---" for index in range(len(headings))]
    lines = [headings, tuple(rules), *rows]
    return "".join(f"| {' | '.join(row)} |\n" for row in lines)
