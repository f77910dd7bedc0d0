"""Literals as values of expanded JSON-LD, in each of the ways to write them."""

from __future__ import annotations

import json
import re
from collections.abc import Collection
from decimal import Decimal, InvalidOperation
from typing import Any, TypeAlias

from kinlint.formats.jsonld.editing.style import Spelled
from kinlint.formats.jsonld.rdf_literals import value_literal
from kinlint.terms import RDF, XSD, Term, literal_datatype, literal_value

Item: TypeAlias = dict[str, Any]
"""A value of a property in expanded JSON-LD."""

_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?")
_INTEGER = re.compile(r"-?(?:0|[1-9][0-9]{0,20})")
_REAL = {f"{XSD}double", f"{XSD}float", f"{XSD}decimal"}
_FLOATING = {f"{XSD}double", f"{XSD}float"}
_INTEGERS = {
    XSD + name
    for name in (
        "integer", "int", "long", "short", "byte", "nonNegativeInteger", "positiveInteger",
        "negativeInteger", "nonPositiveInteger", "unsignedInt", "unsignedLong", "unsignedShort",
        "unsignedByte",
    )
}  # fmt: skip


def literal_items(term: Term, spellings: Collection[str], old: Any = None) -> list[Item]:
    """Return the forms of the literal *term*: first that of the value *old*, then the plainest.

    A fraction that is a JSON number would be a double that is only called `xsd:decimal`.
    *spellings* are numbers as the text writes them, to be kept; others are written shortest.
    """
    text, datatype = literal_value(term), literal_datatype(term)
    if datatype == f"{RDF}langString":
        return [{"@value": text, "@language": term.rpartition("@")[2]}]
    if datatype == f"{RDF}JSON":
        return [{"@value": json.loads(text), "@type": "@json"}]
    if datatype == f"{XSD}string":
        return [{"@value": text}, {"@value": text, "@type": datatype}]
    plain = (spelled(text, spellings) if datatype in _FLOATING else None) or text
    strings = [{"@value": plain, "@type": datatype}]
    natives = _natives(text, datatype, spellings)
    return [*strings, *natives] if isinstance(old, str) else [*natives, *strings]


def _natives(text: str, datatype: str, spellings: Collection[str]) -> list[Item]:
    value: Any
    if datatype == f"{XSD}boolean" and text in ("true", "false"):
        value = text == "true"
    elif datatype in _INTEGERS and _INTEGER.fullmatch(text):
        value = int(text)
    elif datatype == f"{XSD}decimal":
        if not _INTEGER.fullmatch(text):
            return []
        value = int(text)
    elif datatype in _REAL and (spelling := spelled(text, spellings)) is not None:
        value = Spelled(spelling)
    else:
        return []
    return [{"@value": value}, {"@value": value, "@type": datatype}]


def spelled(text: str, spellings: Collection[str]) -> str | None:
    """Return the JSON spelling of a number whose lexical form is *text*; None if JSON has none."""
    try:
        value = float(text)
    except ValueError:
        return None
    kept = sorted(each for each in spellings if _NUMBER.fullmatch(each) and float(each) == value)
    if kept:
        return text if text in kept else kept[0]
    shortest = repr(value)
    return shortest if _NUMBER.fullmatch(shortest) else None


def is_form_of(item: Item, term: Term) -> bool:
    """Tell whether the expanded value *item* is the literal *term*.

    Numbers are compared by value.
    """
    found = value_literal(item)
    if found == term:
        return True
    if found is None or literal_datatype(found) != literal_datatype(term):
        return False
    if literal_datatype(term) == f"{RDF}JSON":
        return bool(json.loads(literal_value(found)) == json.loads(literal_value(term)))
    return _equal(literal_value(found), literal_value(term), literal_datatype(term))


def _equal(one: str, other: str, datatype: str) -> bool:
    if datatype not in _REAL and datatype not in _INTEGERS:
        return False
    try:
        return float(one) == float(other) and (
            datatype == f"{XSD}double" or Decimal(one) == Decimal(other)
        )
    except (ValueError, InvalidOperation):
        return False
