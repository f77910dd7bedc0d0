"""The part of a CONSTRUCT query that makes what a run needs."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from kinlint.document import FROM
from kinlint.terms import RDF_TYPE, Term, iri

_WORD = re.compile(r'"[^"]*"\S*|[();,]|[^\s();,]+')
_VARIABLE = re.compile(r"\?\w+")
_OPENING = re.compile(r"\b(BIND) *\(|\b(OPTIONAL) *\{")
_CLOSING = {"(": ")", "{": "}"}
_BRACED = re.compile(r"\{[^{}]*\}")
_NESTED = re.compile(r"\([^()]*\)")


class Made(NamedTuple):
    """One triple of a template, an object that is a list included.

    `term` is the property, or the class that the subject is said to be of; None for a class that
    is worked out.
    """

    subject: str
    predicate: str
    object: str
    term: Term | None


def parsed(template: str, prefixes: Mapping[str, str]) -> Iterator[Made]:
    """The triples of *template*: subjects with `;` and `,`, full stops apart, and no brackets."""
    subject = predicate = ""
    words = iter(_WORD.findall(template))
    for word in words:
        if word in {".", ";"}:
            subject, predicate = (subject if word == ";" else ""), ""
        elif not subject:
            subject = word
        elif not predicate:
            predicate = word
        elif word != ",":
            value = f"( {' '.join(iter(words.__next__, ')'))} )" if word == "(" else word
            named = value if predicate == "a" else predicate
            term = None if named.startswith("?") else _resolved(named, prefixes)
            yield Made(subject, predicate, value, term)


def _resolved(name: str, prefixes: Mapping[str, str]) -> Term:
    if name == "a":
        return RDF_TYPE
    prefix, _, local = name.partition(":")
    return iri(prefixes[prefix] + local)


def needed(made: Collection[Made], wanted: Collection[Term]) -> list[Made]:
    """What of *made* has a property or class of the *wanted*.

    With it comes what explanations say of these nodes: one class, and what they are made of.
    """
    kept = {
        each
        for each in made
        if each.term is None or each.term in wanted or (each.predicate == "a" and "a" in wanted)
    }
    stated = {each.subject for each in kept}
    named = stated.union(*(each.object.split() for each in kept))
    kinds: dict[str, Made] = {}
    for each in made:
        if each.predicate == "a" and each.term is not None and each.subject in stated:
            known = kinds.get(each.subject)
            if known is None or (known.term is not None and each.term < known.term):
                kinds[each.subject] = each
    kept.update(
        kinds.values(), (each for each in made if each.term == FROM and each.subject in named)
    )
    return [each for each in made if each in kept]


def trimmed(where: str, used: Collection[str]) -> str:
    """*where*, the rest of a query, without what binds nothing but variables nobody looks at.

    *used* are the variables that the template has. What is optional adds no solutions that
    differ in those, and neither does what is worked out.
    """
    while True:
        for found in _OPENING.finditer(where):
            end = _end(where, found.end() - 1)
            rest = where[: found.start()] + where[end:]
            idle = _binds_nothing if found[1] else _extends_nothing
            if idle(where[found.end() : end], rest, used):
                where = rest
                break
        else:
            return where


def _end(text: str, at: int) -> int:
    """Where the bracket that opens *at* is closed again."""
    opening, depth = text[at], 0
    for found in re.finditer(rf"[{opening}{_CLOSING[opening]}]", text[at:]):
        depth += 1 if found[0] == opening else -1
        if not depth:
            return at + found.end()
    return len(text)


def _binds_nothing(bound: str, rest: str, used: Collection[str]) -> bool:
    name = _VARIABLE.findall(bound)[-1]
    return name not in used and name not in _VARIABLE.findall(rest)


def _extends_nothing(optional: str, rest: str, used: Collection[str]) -> bool:
    """Whether each variable is bound without what is *optional*, or looked at nowhere else."""
    sure = set(_VARIABLE.findall(_flat(rest[rest.find("{") + 1 : rest.rfind("}")])))
    elsewhere = {*_VARIABLE.findall(rest), *used}
    return all(name in sure or name not in elsewhere for name in _VARIABLE.findall(optional))


def _flat(text: str) -> str:
    """*text* less all that stands in brackets."""
    for pattern in (_BRACED, _NESTED):
        before = None
        while before != text:
            before, text = text, pattern.sub(" ", text)
    return text
