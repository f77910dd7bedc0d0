"""Text as XML 1.0 can hold it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from xml.sax.saxutils import escape, quoteattr

from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.terminal_style import Style

HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
_REFUSED = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ufffe\uffff]")
"""Characters that XML 1.0 refuses, and those of the controls that it advises against."""


def tag(name: str, attributes: Mapping[str, object], style: Style, *, empty: bool = True) -> str:
    """The tag *name* with *attributes*; of an *empty* element, or the one that opens it."""
    quoted = {key: quoteattr(_allowed(str(value))) for key, value in attributes.items()}
    said = "".join(f" {key}={value}" for key, value in quoted.items())
    return _encoded(f"<{name}{said}{'/' if empty else ''}>", style)


def content(text: str, style: Style) -> str:
    """Escape *text* as character data."""
    return _encoded(escape(_allowed(text)), style)


def _allowed(text: str) -> str:
    return _REFUSED.sub(lambda match: f"\\u{ord(match[0]):04x}", replace_surrogates(text))


def _encoded(text: str, style: Style) -> str:
    """Return *text* with character references where the stream may not take a character."""
    if style.unicode or text.isascii():
        return text
    return text.encode("ascii", "xmlcharrefreplace").decode("ascii")
