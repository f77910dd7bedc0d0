"""SPARQL text as tokens, with prefixed names written out."""

from __future__ import annotations

import re
from collections.abc import Mapping
from urllib.parse import urljoin

_LEXICON = re.compile(
    r"""
      (?P<space>\s+|\#[^\n\r]*)
    | (?P<iri><[^\x00-\x20<>"{}|^`\\]*>)
    | (?P<string>\"{3}(?:\"{0,2}(?:[^"\\]|\\.))*\"{3} | '{3}(?:'{0,2}(?:[^'\\]|\\.))*'{3}
               | \"(?:[^"\\\n\r]|\\.)*\" | '(?:[^'\\\n\r]|\\.)*')
    | (?P<tag>@[a-zA-Z]+(?:-[a-zA-Z0-9]+)*)
    | (?P<variable>[?$]\w+)
    | (?P<blank>_:\w(?:[\w.\-·]*[\w\-·])?)
    | (?P<name>(?:[^\W\d_](?:[\w.\-·]*[\w\-·])?)?
               :(?:(?:[\w:]|%[0-9A-Fa-f]{2}|\\.)
                   (?:(?:[\w.:\-·]|%[0-9A-Fa-f]{2}|\\.)*(?:[\w:\-·]|%[0-9A-Fa-f]{2}|\\.))?)?)
    | (?P<number>[+-]?(?:\d+\.\d*[eE][+-]?\d+|\.?\d+[eE][+-]?\d+|\d*\.\d+|\d+))
    | (?P<word>[a-zA-Z_][\w]*)
    | (?P<sign>\^\^|&&|\|\||!=|<=|>=|[{}()\[\].,;=<>!|/^*+?\-])
    """,
    re.VERBOSE | re.DOTALL,
)
_ESCAPED = re.compile(r"\\(.)")


class NotSparql(Exception):
    """The text breaks the grammar; the message says where."""


def tokens(text: str, prefixes: Mapping[str, str]) -> tuple[str, ...]:
    """The tokens of *text* after its prologue, joined by spaces the same query.

    Prefixed names and relative IRIs come as full IRIs, variables with `?`, keywords as written.
    Prefixes that the text declares come before *prefixes*.
    """
    found = list(_split(text))
    known, base = dict(prefixes), ""
    at = 0
    while at < len(found) and found[at][1].upper() in ("PREFIX", "BASE"):
        if found[at][1].upper() == "BASE":
            base = urljoin(base, found[at + 1][1][1:-1])
            at += 2
        else:
            known[found[at + 1][1][:-1]] = urljoin(base, found[at + 2][1][1:-1])
            at += 3
    return tuple(_full(kind, token, known, base) for kind, token in found[at:])


def _split(text: str) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    at = 0
    while at < len(text):
        match = _LEXICON.match(text, at)
        if match is None:
            line = text.count("\n", 0, at) + 1
            raise NotSparql(f"line {line}: {text[at : at + 20]!r} is not SPARQL")
        if (kind := str(match.lastgroup)) != "space":
            found.append((kind, match.group()))
        at = match.end()
    return found


def _full(kind: str, token: str, known: Mapping[str, str], base: str) -> str:
    if kind == "variable":
        return "?" + token[1:]
    if kind == "iri":
        return f"<{urljoin(base, token[1:-1])}>" if base else token
    if kind != "name":
        return token
    prefix, _, local = token.partition(":")
    if prefix not in known:
        raise NotSparql(f"the prefix '{prefix}:' is not declared")
    return f"<{known[prefix]}{_ESCAPED.sub(lambda m: m[1], local)}>"


def is_variable(token: str) -> bool:
    """Whether *token* is a variable."""
    return len(token) > 1 and token[0] == "?"
