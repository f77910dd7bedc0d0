"""Finds Turtle files that are parts of a model: they describe names that it uses and does not.

Turtle is as often shapes or vocabularies, so searches pass it over.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.pathname import shown
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import RDF_TYPE, Term, iri_value, is_iri
from kinlint.text import PerText, SourceText
from kinlint.vocabulary import DOCUMENT_BASE, KINLINT, METAMODELS, SH, SRC

_VOCABULARIES = (DOCUMENT_BASE, METAMODELS, KINLINT, "http://qudt.org/", "http://www.w3.org/")
_WORD = re.compile(r"[^\s\"'<>#/:,;]+")
"""A word that may be a part of an IRI or of a prefixed name."""
_LAST = re.compile(r"(?<=[#/:])[^\s\"'<>#/:,;]+(?=[\s>,;]|$)")
"""The last word of an IRI or of a prefixed name, in Turtle."""

FEW = 3
"""Most nodes of a file in another namespace that may end as missing ones do by coincidence."""


def turtle_texts(paths: Iterable[Path]) -> Iterator[SourceText]:
    """Yield the texts of the Turtle files at *paths*, but for those that cannot be decoded."""
    for path in paths:
        try:
            yield decode(shown(path), contents(path, path))
        except (Unreadable, SourceError):
            continue


class TurtleParts:
    """Finder of parts, which decides anew where the words that matter have changed."""

    def __init__(self) -> None:
        self._document = PerText(lambda source: _document(source, ReadOptions()))
        self._ends = PerText(self._last_words)
        self._own: set[str] = set()
        self._own_words = PerText(self._numbered_words)
        self._verdict: tuple[object, frozenset[str]] = (None, frozenset())

    def find(
        self,
        sources: Sequence[SourceText],
        candidates: Iterable[SourceText],
        options: Callable[[], ReadOptions],
    ) -> list[SourceText]:
        """Return those of the Turtle *candidates* that describe what *sources* only name.

        What parts name themselves counts, too. One that has such a name and cannot be parsed is
        among them, so that its reader tells the fault; and one most of whose names end as missing
        ones do, so that its namespace is told. *options* are those to read *sources* with.
        """
        models = [each for each in sources if each.format and not each.format.is_tree]
        given = {each.name for each in sources}
        turtle = [each for each in candidates if each.name not in given and SH not in each.text]
        if not models or not turtle:
            return []
        own = {word for each in turtle for word in self._words(each)}
        if own != self._own:
            self._own = own
            self._own_words.clear()
        words = tuple(map(self._own_words, models))
        ends = {end for each in turtle for end in self._ends(each)}
        # Whoever refers to a node has the last word of its name, escaped or not.
        used = (word for own_words in words for word, _ in own_words)
        if ends.isdisjoint(used) and not any("\\u" in each.text for each in models):
            return []
        state = words, tuple(each.text for each in turtle), tuple(each.name for each in models)
        if state != self._verdict[0]:
            self._verdict = state, frozenset(self._parts(models, turtle, options()))
        return [each for each in turtle if each.name in self._verdict[1]]

    def _parts(
        self, models: Sequence[SourceText], turtle: Sequence[SourceText], options: ReadOptions
    ) -> Iterator[str]:
        """Yield the names of the parts among *turtle*."""
        documents = [found for each in models if (found := _document(each, options)) is not None]
        described = {node for each in documents for node in each.map.nodes}
        missing = {name for each in documents for name in _named(each)} - described
        waiting = {each.name: self._document(each) for each in turtle}
        broken = [each for each in turtle if waiting[each.name] is None]
        ends = {_end(name) for name in missing}
        for each in broken:
            del waiting[each.name]
            if not ends.isdisjoint(_WORD.findall(each.text)):
                yield each.name
        while parts := {
            name: document
            for name, document in waiting.items()
            if document is not None and not missing.isdisjoint(document.map.nodes)
        }:
            yield from parts
            described.update(node for each in parts.values() for node in each.map.nodes)
            missing.update(name for each in parts.values() for name in _named(each))
            missing -= described
            waiting = {name: each for name, each in waiting.items() if name not in parts}
        left = {_end(name) for name in missing}
        for name, document in waiting.items():
            own = {_end(node) for node in document.map.nodes} if document is not None else set()
            if 2 * len(own & left) > len(own) > FEW:
                yield name

    def _words(self, source: SourceText) -> Iterable[str]:
        """Return the words of the names that *source* describes, or all of a broken one."""
        document = self._document(source)
        return _WORD.findall(source.text if document is None else " ".join(document.map.nodes))

    def _last_words(self, source: SourceText) -> frozenset[str]:
        """Return the last words of what *source* describes, or of all names of a broken one."""
        document = self._document(source)
        if document is None:
            return frozenset(_LAST.findall(source.text))
        nodes = filter(is_iri, document.map.nodes)
        own = (each for each in nodes if not iri_value(each).startswith(_VOCABULARIES))
        return frozenset(map(_end, own))

    def _numbered_words(self, source: SourceText) -> frozenset[tuple[str, int]]:
        """Return the words of Turtle files that the model *source* has, with their numbers."""
        found = Counter(word for word in _WORD.findall(source.text) if word in self._own)
        return frozenset(found.items())


def _document(source: SourceText, options: ReadOptions) -> Document | None:
    """Return *source* as it is read; None if it cannot be."""
    try:
        return read(source, options)
    except SourceError:
        return None


def _named(document: Document) -> Iterator[Term]:
    """Yield what *document* refers to, but for terms of known vocabularies."""
    for _, predicate, value in document.statements:
        known = not is_iri(value) or iri_value(value).startswith(_VOCABULARIES)
        if not known and predicate != RDF_TYPE and not predicate.startswith(f"<{SRC}"):
            yield value


def _end(node: Term) -> str:
    """Return the last word of the IRI *node*."""
    words = _WORD.findall(node)
    return words[-1] if words else ""
