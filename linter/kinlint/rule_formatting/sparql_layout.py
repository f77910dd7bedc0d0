"""Lays SPARQL out: indented by its brackets, long lines broken, the author's line breaks kept."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.sparql.tokens import Token, split

INDENT = 4
PAIRS = {")": "(", "}": "{", "]": "["}
OPENING = frozenset(PAIRS.values())
OPERATORS = frozenset({";", ",", "|", "/", "||", "&&", "=", "+", "*"})
"""Tokens that neither end nor begin a pattern: the line after or with one goes on."""

CLAUSES = frozenset(
    {"SELECT", "CONSTRUCT", "ASK", "WHERE", "INSERT", "DELETE", "USING", "WITH", "PREFIX", "BASE"}
    | {"GROUP", "HAVING", "ORDER", "LIMIT", "OFFSET", "VALUES"}
)
"""Keywords that begin a line at the outermost level."""

PATTERNS = frozenset({"FILTER", "BIND", "OPTIONAL", "MINUS", "VALUES", "UNION"})
BREAKS = {".": 0, ";": 1, "||": 2, "&&": 3, ",": 4, "|": 5, "/": 80}
"""After which tokens a line that is too long is broken, the best first."""

LAST_RESORT = 90
"""The cost of breaking a line at any other space; a bracket deeper costs 10."""


class Piece(NamedTuple):
    """A token or comment of a line, and whether a space stands before it."""

    text: str
    """Text of the token or comment."""
    spaced: bool
    """True if a space precedes it."""


def laid_out(query: str, width: int) -> Iterator[str]:
    """Yield the lines of *query*, of at most *width* columns where a line can be broken.

    Only white space differs from *query*. Raises `NotSparql` where it has no tokens of SPARQL.
    """
    open_at: list[tuple[str, int]] = []
    goes_on = False
    waiting = list(_source_lines(query))[::-1]
    while waiting:
        pieces = waiting.pop()
        if not pieces:
            yield ""
            continue
        indent = _indent(pieces, open_at, goes_on=goes_on)
        if indent + len(_joined(pieces)) > width and (at := _break(pieces, width - indent)):
            waiting.append(pieces[at:])
            pieces = pieces[:at]
        yield " " * indent + _joined(pieces)
        for piece in pieces:
            if piece.text in OPENING:
                open_at.append((piece.text, indent))
            elif piece.text in PAIRS and open_at:
                open_at.pop()
        if not pieces[-1].text.startswith("#"):
            goes_on = pieces[-1].text in OPERATORS


def _source_lines(query: str) -> Iterator[list[Piece]]:
    """Yield the lines of *query* as pieces; an empty one for blank lines between others."""
    line: list[Piece] = []
    end = 0
    for token in (*split(query), Token("end", "", len(query))):
        for number, part in enumerate(query[end : token.start].split("\n")):
            if number and line:
                yield line
                line = []
            if comment := part.strip():
                line.append(Piece(comment, spaced=bool(line)))
        if end and token.text and re.search(r"\n\s*\n", query[end : token.start]) and not line:
            yield []
        if token.text:
            line.append(Piece(token.text, spaced=bool(line) and token.start > end))
        end = token.start + len(token.text)
    if line:
        yield line


def _indent(pieces: Sequence[Piece], open_at: Sequence[tuple[str, int]], *, goes_on: bool) -> int:
    """Return the indentation of a line inside of brackets, given with that of their lines."""
    closing = 0
    while closing < len(pieces) and pieces[closing].text in PAIRS:
        closing += 1
    if closing:
        return open_at[-closing][1] if closing <= len(open_at) else 0
    first = pieces[0].text
    if not open_at:
        return 0 if first.upper() in CLAUSES or first.startswith("#") else INDENT
    bracket, indent = open_at[-1]
    goes_on = bracket == "{" and (goes_on or first in OPERATORS)
    return indent + INDENT * (1 + goes_on)


def _break(pieces: Sequence[Piece], width: int) -> int:
    """Return where a line too long for *width* is broken best; 0 if nowhere."""
    best, found = None, 0
    depth, at = 0, 0
    for number, piece in enumerate(pieces[:-1]):
        at += len(piece.text) + piece.spaced
        depth += (piece.text in OPENING) - (piece.text in PAIRS)
        follower = pieces[number + 1]
        if at > width:
            break
        breakable = follower.spaced or piece.text in ("|", "/")
        if not breakable or follower.text in PAIRS or depth < 0:
            continue
        if piece.text.upper() in (*PATTERNS, "NOT", "EXISTS") or piece.text in OPENING:
            continue
        cost = 10 * depth + _cost(piece.text, follower.text)
        if best is None or cost <= best:
            best, found = cost, number + 1
    return found


def _cost(before: str, after: str) -> int:
    """Return how bad it is to break a line between two tokens at one level."""
    if before in BREAKS:
        return BREAKS[before]
    if before == "}" or after.upper() in PATTERNS:
        return 0
    if after.upper() == "AS":
        return 1
    return LAST_RESORT


def _joined(pieces: Sequence[Piece]) -> str:
    return "".join(" " * piece.spaced + piece.text for piece in pieces).strip()
