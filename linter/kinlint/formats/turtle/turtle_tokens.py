"""The tokens of Turtle 1.1 (section 6.5), as far as they must be told apart."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from kinlint.text import Span

_UCHAR = r"\\u[0-9A-Fa-f]{4}|\\U[0-9A-Fa-f]{8}"
_ESCAPED = r"%[0-9A-Fa-f]{2}|\\[_~.\-!$&'()*+,;=/?#@%]"
_PREFIX = r"[^\W\d_](?:[\w.\-\u00b7]*[\w\-\u00b7])?"
_LOCAL = rf"(?:[\w:]|{_ESCAPED})(?:(?:[\w:.\-\u00b7]|{_ESCAPED})*(?:[\w:\-\u00b7]|{_ESCAPED}))?"

_TOKEN = re.compile(
    rf"""
    (?P<space>  (?: [ \t\r\n] | \#[^\r\n]* )+ )
  | (?P<iri>    < (?: [^\x00-\x20<>"{{}}|^`\\] | {_UCHAR} )* > )
  | (?P<string> \"{{3}} (?: \"{{0,2}} (?: [^"\\] | \\. ) )* \"{{3}}
              | '{{3}} (?: '{{0,2}} (?: [^'\\] | \\. ) )* '{{3}}
              | " (?: [^"\\\r\n] | \\. )* "
              | ' (?: [^'\\\r\n] | \\. )* ' )
  | (?P<at>     @[a-zA-Z]+ (?: -[a-zA-Z0-9]+ )* )
  | (?P<blank>  _: \w (?: [\w.\-\u00b7]* [\w\-\u00b7] )? )
  | (?P<name>   (?:{_PREFIX})? : (?:{_LOCAL})? )
  | (?P<number> [+-]? (?: [0-9]+ (?: \.[0-9]* )? [eE][+-]?[0-9]+
                        | \.[0-9]+ (?: [eE][+-]?[0-9]+ )?
                        | [0-9]* \.[0-9]+ | [0-9]+ ) )
  | (?P<word>   [A-Za-z]+ )
  | (?P<mark>   \^\^ | [.;,\[\]()] )
    """,
    re.VERBOSE | re.DOTALL,
)


class Token(NamedTuple):
    """A token, its kind (a group of the expression above) and its place."""

    kind: str
    """Name of the group of the expression above that matches it."""
    text: str
    """Text of the token."""
    start: int
    """Offset of the first character."""
    end: int
    """Offset behind the last character."""

    @property
    def span(self) -> Span:
        """Return the span of the token."""
        return Span(self.start, self.end)


class Unread(Exception):
    """Text that these tokens or the grammar built on them do not cover."""


def tokens(text: str) -> Iterator[Token]:
    """Yield the tokens of *text* without spaces and comments, and an empty one of kind "end".

    Raises Unread where there is none.
    """
    at, size = 0, len(text)
    while at < size:
        match = _TOKEN.match(text, at)
        if match is None or match.end() == at:
            raise Unread(at)
        if match.lastgroup and match.lastgroup != "space":
            yield Token(match.lastgroup, match.group(), at, match.end())
        at = match.end()
    yield Token("end", "", size, size)
