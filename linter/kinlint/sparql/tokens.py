"""SPARQL text as tokens, with prefixed names written out."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from kinlint.suggestion import did_you_mean
from kinlint.terms import Term
from kinlint.uri_references import resolve_uri

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
    """A text breaks the grammar of SPARQL.

    `at` is the number of the token that does not fit, counted after the prologue, or `start` its
    offset in the text.
    """

    def __init__(self, cause: str, at: int = 0, start: int | None = None) -> None:
        super().__init__(cause)
        self.at = at
        self.start = start

    def offset(self, text: str) -> int:
        """Return the offset of the token in *text*, the text that was read."""
        if self.start is not None:
            return self.start
        found = split(text)
        at = self.at + _prologue(found)[0]
        return found[at].start if at < len(found) else len(text.rstrip())


class Token(NamedTuple):
    """A token as it is spelled in a text."""

    kind: str
    """The name of its kind."""
    text: str
    """The token."""
    start: int
    """Its offset in the text."""


def tokens(text: str, prefixes: Mapping[str, str]) -> tuple[str, ...]:
    """Return the tokens of *text* after its prologue, joined by spaces the same query.

    Prefixed names and relative IRIs come as full IRIs, variables with `?`, keywords as written.
    Prefixes that the text declares come before *prefixes*. Raises `NotSparql`.
    """
    return written_out(split(text), prefixes)


def written_out(found: Sequence[Token], prefixes: Mapping[str, str]) -> tuple[str, ...]:
    """Return the tokens *found* after their prologue, with names in full, as `tokens` does."""
    body, known, base = _prologue(found)
    known = {**prefixes, **known}
    return tuple(_full(each, known, base, at) for at, each in enumerate(found[body:]))


def prologue(text: str) -> dict[str, str]:
    """Return the namespaces of the prefixes that *text* declares. Raises `NotSparql`."""
    return _prologue(split(text))[1]


def prefixed(text: str, prefixes: Mapping[str, str]) -> set[Term]:
    """Return the IRIs that *text* writes as a name with one of *prefixes*. Raises `NotSparql`."""
    names = (each.text.partition(":") for each in split(text) if each.kind == "name")
    return {
        f"<{prefixes[prefix]}{local}>" for prefix, _, local in names if local and prefix in prefixes
    }


def _prologue(found: Sequence[Token]) -> tuple[int, dict[str, str], str]:
    """Return where the prologue of *found* ends, the namespaces by prefix, and the base."""
    known: dict[str, str] = {}
    base, at = "", 0
    while at < len(found) and (word := found[at].text.upper()) in ("PREFIX", "BASE"):
        kinds = [each.kind for each in found[at + 1 : at + 3]]
        if word == "BASE" and kinds[:1] == ["iri"]:
            base = resolve_uri(base, found[at + 1].text[1:-1])
            at += 2
        elif word == "PREFIX" and kinds == ["name", "iri"] and found[at + 1].text[-1] == ":":
            known[found[at + 1].text[:-1]] = resolve_uri(base, found[at + 2].text[1:-1])
            at += 3
        else:
            wanted = "an IRI" if word == "BASE" else "a prefix and an IRI"
            raise NotSparql(f"{word} is not followed by {wanted}", start=found[at].start)
    return at, known, base


def split(text: str) -> list[Token]:
    """Return the tokens of *text* as they are written, the prologue too. Raises `NotSparql`."""
    found: list[Token] = []
    at = 0
    while at < len(text):
        match = _LEXICON.match(text, at)
        if match is None:
            rest = text[at:].split("\n", maxsplit=1)[0].strip()
            raise NotSparql(f"not SPARQL 1.1 near '{rest}'", start=at)
        if (kind := str(match.lastgroup)) != "space":
            found.append(Token(kind, match.group(), at))
        at = match.end()
    return found


def _full(found: Token, known: Mapping[str, str], base: str, at: int) -> str:
    kind, token, _ = found
    if kind == "variable":
        return "?" + token[1:]
    if kind == "iri":
        return f"<{resolve_uri(base, token[1:-1])}>" if base else token
    if kind != "name":
        return token
    prefix, _, local = token.partition(":")
    if prefix not in known:
        hint = did_you_mean(f"{prefix}:", [f"{each}:" for each in known])
        raise NotSparql(f"the prefix '{prefix}:' is not declared{hint}", at)
    return f"<{known[prefix]}{_ESCAPED.sub(lambda m: m[1], local)}>"


def is_variable(token: str) -> bool:
    """Tell whether *token* is a variable."""
    return len(token) > 1 and token[0] == "?"
