"""Finds Turtle files that are parts of a model: they describe names that it uses and does not.

Turtle is as often shapes or vocabularies, so searches pass it over. This is decided from the texts,
without expanding the models.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.pathname import shown
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import decode, read
from kinlint.terms import iri_value, is_iri
from kinlint.text import SourceText
from kinlint.vocabulary import KINLINT, METAMODELS, SH

_PREFIX = re.compile(r'"([\w.-]+)"\s*:\s*"([a-z][a-z0-9+.-]*:[^"\s]*[#/:])"')
_IDENTIFIER = re.compile(r'"(?:@id|id)"\s*:\s*"([^"]+)"')
_WORD = re.compile(r'"([\w.-]+:[^"\s/][^"\s]*)"')


def turtle_parts(sources: Sequence[SourceText], passed_over: Iterable[Path]) -> list[SourceText]:
    """Return those of the Turtle files *passed_over* that describe what *sources* only name."""
    models = [each for each in sources if each.format == BY_NAME["jsonld"]]
    missing = _missing(models) if models else frozenset()
    if not missing:
        return []
    return [text for path in passed_over for text in _part(path, missing)]


def _missing(models: Sequence[SourceText]) -> frozenset[str]:
    """Return the IRIs of the own namespaces of *models* that these name and do not describe."""
    named: set[str] = set()
    described: set[str] = set()
    for model in models:
        prefixes = dict(_PREFIX.findall(model.text))
        named.update(_expanded(_WORD.findall(model.text), prefixes))
        described.update(_expanded(_IDENTIFIER.findall(model.text), prefixes))
    return frozenset(
        each for each in named - described if not each.startswith((METAMODELS, KINLINT))
    )


def _expanded(words: Iterable[str], prefixes: Mapping[str, str]) -> Iterator[str]:
    for word in words:
        prefix, _, name = word.partition(":")
        if prefix in prefixes:
            yield prefixes[prefix] + name


def _part(path: Path, missing: frozenset[str]) -> Iterator[SourceText]:
    """Yield the text of the Turtle file at *path* if it describes something *missing*."""
    try:
        source = decode(shown(path), contents(path, path))
        if SH in source.text:
            return
        document = read(source, ReadOptions())
    except (Unreadable, SourceError):
        return
    if any(is_iri(node) and iri_value(node) in missing for node in document.map.nodes):
        yield source
