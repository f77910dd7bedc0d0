"""Names in the texts of files that could not be read: what they would have described."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.engine.store import Store
from kinlint.findings.consequences import Unread
from kinlint.sparql.given_values import is_nameable
from kinlint.terms import Term, iri
from kinlint.vocabulary import RDFS

PREFIX = re.compile(r'"([A-Za-z][\w.-]*)"\s*:\s*"([a-z][a-z0-9+.-]*:[^"\s]*[#/:])"')
"""A prefix as a JSON-LD context defines it."""
TURTLE_PREFIX = re.compile(r"@?prefix\s+([A-Za-z][\w.-]*)?:\s*<([^<>\s]*)>", re.IGNORECASE)
NAME = re.compile(r'"([A-Za-z][\w.-]*):([^"\s/][^"\s]*)"')
TURTLE_NAME = re.compile(r"(?<![\w:\"])([A-Za-z][\w.-]*)?:([A-Za-z_][\w-]*)")
ABSOLUTE = re.compile(r'["<]((?:https?://|urn:)[^">\s]+)[">]')
WORD = re.compile(r"[A-Za-z][\w-]*")
LOCAL_NAMES = f"""
SELECT ?term ?above WHERE {{
    ?term <{RDFS}isDefinedBy> ?context ; (<{RDFS}subPropertyOf>|<{RDFS}subClassOf>)* ?above .
}}
"""


def unread_file(text: str, store: Store) -> Unread:
    """Return what *text*, which is no JSON or Turtle any more, names.

    The terms are those of the metamodels in *store* whose names are among its words, and what
    these are special cases of.
    """
    words = set(WORD.findall(text))
    terms = {
        row["above"]
        for row in store.rows(LOCAL_NAMES)
        if re.split(r"[#/]", row["term"][:-1])[-1] in words
    }
    return Unread(frozenset(filter(is_nameable, _names(text))), frozenset(terms))


def _names(text: str) -> Iterator[Term]:
    """Yield the IRIs in *text*, well-formed or not, those with a prefix that it defines in full."""
    turtle = TURTLE_PREFIX.search(text) is not None
    prefixes = dict((TURTLE_PREFIX if turtle else PREFIX).findall(text))
    for prefix, local in (TURTLE_NAME if turtle else NAME).findall(text):
        if prefix in prefixes:
            yield iri(f"{prefixes[prefix]}{local}")
    yield from map(iri, ABSOLUTE.findall(text))
