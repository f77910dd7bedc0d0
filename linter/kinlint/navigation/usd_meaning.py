"""Hover text in layers of USD: what schemas say of a property, and where a schema is applied."""

from __future__ import annotations

import re

from kinlint.formats.usd.prim_schemas import PropertyType, prim_schemas
from kinlint.navigation.completion.usd_schemas import properties_around

_STATEMENT = re.compile(
    r"^[ \t]*(?:(?:custom|uniform|varying|prepend|append|add|delete|reorder)[ \t]+)*"
    r"(?:rel|[a-z]\w*(?:\[\])?)[ \t]+(?P<name>[A-Za-z_][\w:]*)"
)
_SCHEMA = re.compile(r'"([A-Z]\w*)(?::\w+)?"')


def meaning(text: str, offset: int) -> str:
    """Return what schemas say of the property or the schema at *offset* of *text*, or nothing."""
    start = text.rfind("\n", 0, offset) + 1
    end = text.find("\n", offset)
    line = text[start : end if end >= 0 else len(text)]
    found = _STATEMENT.match(line)
    known = (properties_around(text, offset) or {}).get(found["name"]) if found else None
    if found is not None and known is not None:
        return _property(found["name"], known)
    for schema in _SCHEMA.finditer(line):
        if schema.start() <= offset - start <= schema.end() and schema[1] in prim_schemas():
            return _schema(schema[1])
    return ""


def _property(name: str, known: PropertyType) -> str:
    kind = "relationship" if known.type == "rel" else known.type
    unit = f", unit: {known.unit.replace('-', ' ')}" if known.unit else ""
    uniform = ", uniform" if known.uniform else ""
    choices = f": {', '.join(f'`{each}`' for each in known.choices)}" if known.choices else ""
    targets = f", to {' or '.join(known.targets)}" if known.targets else ""
    return f"`{name}` {kind} of {known.schema}{uniform}{unit}{targets}{choices}"


def _schema(name: str) -> str:
    known = prim_schemas()[name]
    ends = [each for each in known.applies_to if each in prim_schemas()]
    where = f" of {', '.join(ends)}" if ends else ""
    replaced = f"; use {known.replaced_by}" if known.replaced_by else ""
    return f"`{name}` schema{where}{replaced}"
