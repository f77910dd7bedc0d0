"""Completion in layers of USD by schemas: types, applied schemas, attributes and their tokens."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterator

from kinlint.formats.usd.prim_schemas import PropertyType, base_types, prim_schemas, properties_of
from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.situation import Situation
from kinlint.text import Span

LONGEST = 100_000
"""Most characters that are looked back for the prim around a place."""
_HEAD = re.compile(r'\b(?:def|over|class)\s+(?:(?P<type>\w+)\s+)?"\w+"')
_LIST = re.compile(r'\bapiSchemas\s*=\s*\[?(?P<others>[^\]=()]*)"(?P<typed>[\w:]*)\Z')
_TOKEN = re.compile(r'\btoken\s+(?P<name>[\w:]+)\s*=\s*"(?P<typed>\w*)\Z')
_TYPE = re.compile(r"^\s*(?:def|over|class)\s+(?P<typed>\w*)\Z", re.MULTILINE)
_NAME = re.compile(
    r"^[ \t]*(?:(?:custom|uniform|varying)[ \t]+)*(?:(?P<type>[a-z]\w*(?:\[\])?)[ \t]+)?"
    r"(?P<typed>[a-z][\w:]*|)\Z",
    re.MULTILINE,
)
_SCHEMAS = re.compile(r"\bapiSchemas\s*=\s*\[?([^\]=()]*)")
_WORD = re.compile(r'"([\w:]+)"')
_REST = re.compile(r"[\w:]*")


def complete(situation: Situation) -> Completions:
    """Return what schemas have for the place of *situation*."""
    text, offset = situation.source.text, situation.offset
    start = max(0, offset - LONGEST)
    line = max(start, text.rfind("\n", 0, offset) + 1)
    if found := _LIST.search(text, start, offset):
        head = _last_head(text, start, found.start())
        candidates = _schemas(head["type"] or "" if head else "", found["others"])
    elif found := _TYPE.search(text, line, offset):
        candidates = _types()
    else:
        found = _TOKEN.search(text, line, offset) or _NAME.search(text, line, offset)
        known = properties_around(text, offset) if found else None
        if found is None or known is None:
            return NOTHING
        if found.re is _TOKEN:
            candidates = _choices(known.get(found["name"]))
        else:
            candidates = _names(known, found["type"] or "")
    rest = _REST.match(text, offset)
    end = rest.end() if rest else offset
    return Completions.from_candidates(candidates, Span(found.start("typed"), end))


def _last_head(text: str, start: int, end: int) -> re.Match[str] | None:
    """Return where the last prim before *end* begins."""
    found = deque(_HEAD.finditer(text, start, end), maxlen=1)
    return found[0] if found else None


def properties_around(text: str, offset: int) -> dict[str, PropertyType] | None:
    """Return the properties of the prim whose block is around *offset*; None if there is none."""
    start, depth = max(0, offset - LONGEST), 0
    for at in range(offset - 1, start - 1, -1):
        depth += {"}": 1, "{": -1}.get(text[at], 0)
        if depth < 0:
            head = _last_head(text, start, at)
            if head is None:
                return None
            applied = _SCHEMAS.search(text, head.end(), at)
            words = _WORD.findall(applied[1]) if applied else ()
            return properties_of(head["type"] or "", tuple(words))
    return None


def _schemas(type_: str, others: str) -> Iterator[Candidate]:
    """Yield the schemas that a prim of *type_* may have, and does not have by *others*."""
    bases, said = {*base_types(type_)}, {*_WORD.findall(others)}
    for name, schema in prim_schemas().items():
        ends = {each for each in schema.applies_to if not prim_schemas()[each].applied}
        if not schema.applied or schema.replaced_by or (bases and ends and not bases & ends):
            continue
        names = [f"{name}:{each}" for each in schema.instances] if schema.multiple else [name]
        for each in names:
            if each not in said:
                yield Candidate(each, Kind.CLASS, rank=0 if bases & ends else 1)


def _types() -> Iterator[Candidate]:
    for name, schema in prim_schemas().items():
        if not schema.applied and not schema.abstract:
            yield Candidate(name, Kind.CLASS)


def _choices(known: PropertyType | None) -> Iterator[Candidate]:
    for each in known.choices if known is not None else ():
        yield Candidate(each, Kind.WORD)


def _names(known: dict[str, PropertyType], type_: str) -> Iterator[Candidate]:
    """Yield the properties that are *known*: of *type_*, or with their types if none is written."""
    for name, each in known.items():
        if not type_:
            variability = "uniform " if each.uniform else ""
            yield Candidate(
                name, Kind.ATTRIBUTE, each.type, text=f"{variability}{each.type} {name}"
            )
        elif each.type == type_:
            yield Candidate(name, Kind.ATTRIBUTE, each.type)
