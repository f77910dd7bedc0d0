"""Terms and nodes as every parser of Turtle accepts them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from urllib.parse import quote

from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.terminal_style import Style
from kinlint.terms import Term, is_blank, is_iri

_LABEL = re.compile(r"_:[A-Za-z0-9_](?:[A-Za-z0-9_.-]*[A-Za-z0-9_-])?")
_WIDE = re.compile(r"[^\x00-\x7f]")
_UNFIT = re.compile(r"[\x00-\x20<>\"{}|^`\\]")


def term(given: Term) -> str:
    """Return the term *given* with what IRIs and labels may not contain escaped."""
    if is_iri(given):
        return f"<{_UNFIT.sub(lambda match: quote(match[0]), given[1:-1])}>"
    if is_blank(given) and not _LABEL.fullmatch(given):
        return "_:x" + given[2:].encode("utf-8", "surrogatepass").hex()
    return given


def node(lines: Sequence[str], indent: int) -> str:
    """Return a blank node with the properties *lines*, indented by *indent* columns."""
    between = " ;\n" + " " * indent
    return f"[ {between.join(lines)} ]"


def encodable(piece: str, style: Style) -> str:
    """Return *piece* of a document in characters that *style* can show."""
    plain = style.unicode or piece.isascii()
    return piece if plain else _WIDE.sub(_escaped, replace_surrogates(piece))


def _escaped(match: re.Match[str]) -> str:
    """Return a character as Turtle writes it in ASCII, in literals and IRIs alike."""
    code = ord(match[0])
    return f"\\u{code:04X}" if code <= 0xFFFF else f"\\U{code:08X}"  # noqa: PLR2004
