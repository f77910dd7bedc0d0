"""Value objects as RDF literals (JSON-LD 1.1 API, 8.2.2)."""

from __future__ import annotations

import re
from decimal import Decimal
from functools import lru_cache
from typing import Any

from kinlint.formats.doubles import exceeds_doubles
from kinlint.formats.jsonld.pyld import canonicalize
from kinlint.terms import RDF, XSD, Term, literal

I18N = "https://www.w3.org/ns/i18n#"

_TEXT = f"{XSD}string"
_DOUBLE = f"{XSD}double"
_WITH_EXPONENT = 10**21
_LANGUAGE = re.compile(r"[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*")
_MALFORMED = re.compile(r'[\x00-\x20<>"{}|^`\\]|#[^#]*#')


def value_literal(item: dict[str, Any], *, directed: bool = False) -> Term | None:
    """Return the literal of an expanded value object.

    None if it has an impossible language or datatype, or is a number too large for a double.
    *directed* writes a base direction into the datatype (`rdfDirection` "i18n-datatype").
    """
    value = item["@value"]
    datatype = item.get("@type")
    if datatype == "@json":
        return literal(canonicalize(value).decode(), f"{RDF}JSON")
    if datatype is not None and (malformed(datatype) or too_large(item)):
        return None
    if isinstance(value, (int, float)):
        return _number(value, datatype)
    return _text(value, datatype, item, directed=directed)


def _text(value: str, datatype: str | None, item: dict[str, Any], *, directed: bool) -> Term | None:
    if directed and "@direction" in item:
        tag = f"{I18N}{item.get('@language', '')}_{item['@direction']}"
        return None if malformed(tag) else literal(value, tag)
    if "@language" in item:
        language = item["@language"]
        return literal(value, language=language) if _LANGUAGE.fullmatch(language) else None
    return literal(value, datatype or _TEXT)


def too_large(item: dict[str, Any]) -> bool:
    """Tell whether a value object is a double whose text is beyond the range of doubles."""
    value = item["@value"]
    if item.get("@type") != _DOUBLE or not isinstance(value, str):
        return False
    return exceeds_doubles(value)


def malformed(iri: str) -> bool:
    """Tell whether *iri* holds characters that no IRI can hold, or two fragments."""
    return _MALFORMED.search(iri) is not None


def _number(value: float, datatype: str | None) -> Term:
    if isinstance(value, bool):
        return literal("true" if value else "false", datatype or f"{XSD}boolean")
    whole = isinstance(value, int) or value.is_integer()
    if datatype != _DOUBLE and whole and abs(value) < _WITH_EXPONENT:
        return literal(str(int(value)), datatype or f"{XSD}integer")
    return literal(canonical_double(float(value)), datatype or _DOUBLE)


def canonical_double(value: float) -> str:
    """Return the canonical lexical form of *value* as an `xsd:double`, with all digits it needs."""
    return _canonical(float.__repr__(value))


@lru_cache(maxsize=4096)
def _canonical(shortest: str) -> str:
    # By its spelling, as zero and minus zero are one key of a cache.
    sign, digits, exponent = Decimal(shortest).as_tuple()
    spelled = "".join(map(str, digits)).lstrip("0") or "0"
    scale = len(spelled) - 1 + int(exponent) if spelled != "0" else 0
    fraction = spelled[1:].rstrip("0") or "0"
    return f"{'-' if sign else ''}{spelled[0]}.{fraction}E{scale}"
