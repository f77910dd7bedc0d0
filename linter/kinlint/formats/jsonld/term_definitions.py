"""Statements about causes: terms that contexts in a file define, entities that lost values name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any

from kinlint.formats.jsonld.expansion_record import DroppedKey, ExpansionRecord
from kinlint.formats.jsonld.losses import Detail, Loss, text_details
from kinlint.formats.jsonld.resemblance import KEYWORDS
from kinlint.formats.jsonld.triples import Triples
from kinlint.terms import iri

MENTIONED = 100
"""The number of entities below a lost key that are noted."""
ABSOLUTE = re.compile(r"[A-Za-z][A-Za-z0-9+-.]*:[^\s]*$")


def definitions(record: ExpansionRecord, triples: Triples) -> Iterator[Loss]:
    """Yield the terms that contexts in the file define, and the keys that they map to null."""
    for term, written, mapping, former in record.definitions.values():
        details = [*text_details(term=term)]
        details += text_details(written=written) if written is not None else ()
        now, before = (each or {} for each in (mapping, former))
        if ABSOLUTE.match(str(now.get("@id"))):
            details.append(Detail("iri", iri(str(now["@id"]))))
        if now.get("_prefix"):
            details += text_details(namespace=str(now["@id"]))
        if before.get("@id") and {**now, "_prefix": 0} != {**before, "_prefix": 0}:
            details.append(Detail("formerIri", iri(str(before["@id"]))))
        yield Loss("TermDefinition", term.value_span, None, tuple(details))
    for key, origin in record.cleared.values():
        yield Loss("ClearedKey", key.span, triples.named(origin), text_details(key=key))


def mentioned(drop: DroppedKey) -> Iterator[Detail]:
    """Yield the entities that the lost value of a key names, as far as prefixes say which."""
    terms = drop.resolution.terms
    # A graph under another key is the whole file.
    most = None if f"@{drop.key}" in KEYWORDS else MENTIONED
    for text in islice(strings(drop.origin.element.get(drop.key)), most):
        prefix, colon, rest = text.partition(":")
        meaning = terms.get(prefix) if colon else None
        if meaning and not rest.startswith("//") and ABSOLUTE.match(text):
            yield Detail("mentions", iri(f"{meaning['@id']}{rest}"))


def strings(value: Any) -> Iterator[str]:
    """Yield the strings in the JSON *value*, those of keys apart."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from strings(each)
    elif isinstance(value, list):
        for each in value:
            yield from strings(each)
