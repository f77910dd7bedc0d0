"""Finds the tags of a text without reading it."""

from __future__ import annotations

import re
from collections.abc import Iterator

TAG = re.compile(r"<(/?)([^\s<>/=\"'!?&]++)((?:[^<>\"']++|\"[^\"]*+\"|'[^']*+')*+)>")
LOST = re.compile(
    r"""\s*(?P<cut>\??xml\s[^<>]*\?>
    |(?P<tag>[A-Za-z_][\w.-]*)(?:\s+[\w:.-]+\s*=\s*(?:"[^"<>]*"|'[^'<>]*'))+\s*/?>)""",
    re.VERBOSE,
)
"""Beginning of a text whose first character, the < of a declaration or a `tag`, is lost."""
DEFINITION = "<!DOCTYPE"
SKIPPED = {"<!--": "-->", "<![CDATA[": "]]>", "<?": "?>", "<!": ">"}
"""Beginnings of markup that is no tag, with its end; the first that fits."""


def first_tag(text: str, wanted: str = "", at: int = 0) -> int:
    """Return the offset of the first tag from *at*, or before it of *wanted*; else -1."""
    while (at := text.find("<", at)) >= 0:
        if wanted and text.startswith(wanted, at):
            return at
        ends = (end for begin, end in SKIPPED.items() if text.startswith(begin, at))
        if (end := next(ends, None)) is None:
            return -1 if wanted else at
        at = text.find(end, at)
        if at < 0:
            break
    return -1


def tags(text: str, at: int, most: int) -> Iterator[re.Match[str]]:
    """Yield at most *most* tags of *text* from *at* on, as far as they make sense."""
    for _ in range(most):
        at = first_tag(text, at=at)
        match = TAG.match(text, at) if at >= 0 else None
        if match is None:
            return
        yield match
        at = match.end()
