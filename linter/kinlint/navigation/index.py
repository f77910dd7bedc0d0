"""Index of all that is named in a model, by place and by entity."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint.document import Document
from kinlint.navigation.document_excerpt import Excerpt, whole
from kinlint.navigation.element_names import named_elements
from kinlint.navigation.graph_terms import terms
from kinlint.navigation.json_terms import keys_and_names
from kinlint.navigation.occurrence import Entity, Occurrence, Role
from kinlint.navigation.text_names import Paths
from kinlint.navigation.xacro_names import xacro_names
from kinlint.terms import RDF_TYPE

if TYPE_CHECKING:
    from kinlint.navigation.element_excerpts import ElementExcerpts

NAME, LONG = re.compile(r'"@id"\s*+:\s*+(?:"[^"]*+"?)?\Z'), 500
"""Pattern of the text before a place at the name of a node, and the most characters it takes."""


class Index:
    """The places in *documents* where something is named."""

    def __init__(self, documents: Sequence[Document]) -> None:
        self.documents = documents
        self.paths = Paths()

    @cached_property
    def occurrences(self) -> Sequence[Occurrence]:
        """All of them, each once, document by document in the order of the texts."""
        found = (each for document in self.documents for each in self._named_in(document))
        return self._distinct(found)

    def _distinct(self, occurrences: Iterable[Occurrence]) -> Sequence[Occurrence]:
        found: dict[tuple[Path, int, int, Entity], Occurrence] = {}
        for each in occurrences:
            found.setdefault((*self._place(each), each.entity), each)
        return tuple(found.values())

    def _named_in(self, document: Document) -> Sequence[Occurrence]:
        """Return what *document* names, in the order of the text."""
        if document.format.is_tree:
            return sorted((*named_elements(document), *xacro_names(document)), key=self._place)
        return self._named(whole(document))

    def _named(self, excerpt: Excerpt) -> Sequence[Occurrence]:
        """Return what *excerpt* of a graph names, in the order of the text."""
        named = list(terms(excerpt))
        if excerpt.document.format.fence == "json":
            known = {each.location.span: each.entity for each in reversed(named)}
            named += keys_and_names(excerpt, known)
        return sorted(named, key=self._place)

    @cached_property
    def _elements(self) -> Sequence[ElementExcerpts | None]:
        """The elements of each document; None where these do not tell all of an entity."""
        names = Counter(self.paths[text.name] for each in self.documents for text in each.sources)
        found: list[ElementExcerpts | None] = []
        for each in self.documents:
            alone = each.format.fence == "json" and names[self.paths[each.source.name]] == 1
            found.append(element_excerpts(each) if alone else None)
        return found

    def excerpt_at(self, name: str, offset: int) -> Excerpt | None:
        """Return the element of a large file at *offset* of the text called *name*."""
        if any(each.format.is_tree for each in self.documents):
            return None
        for document, elements in zip(self.documents, self._elements, strict=True):
            if elements is not None and self.paths[document.source.name] == self.paths[name]:
                return elements.at(offset)
        return None

    def _near(self, name: str, offset: int) -> Sequence[Occurrence]:
        """Return the occurrences in the text called *name*, at least those at *offset*."""
        if "_by_text" not in vars(self) and (excerpt := self.excerpt_at(name, offset)) is not None:
            found = self._distinct(self._named(excerpt))
            silent = NAME.search(excerpt.document.source.text, max(0, offset - LONG), offset)
            if silent is None or any(_covers(each, offset) for each in found):
                return found
        return self._by_text.get(self.paths[name], ())

    @cached_property
    def _by_text(self) -> Mapping[Path, Sequence[Occurrence]]:
        found: dict[Path, list[Occurrence]] = {}
        for each in self.occurrences:
            found.setdefault(self.paths[each.location.source.name], []).append(each)
        return found

    @cached_property
    def _by_entity(self) -> Mapping[Entity, Sequence[Occurrence]]:
        found: dict[Entity, list[Occurrence]] = {}
        for each in self.occurrences:
            found.setdefault(each.entity, []).append(each)
        return found

    def at(self, name: str, offset: int) -> Sequence[Occurrence]:
        """Return the occurrences at *offset* of the text called *name*, by the shortest name.

        These may be several: what a macro writes is there once for each call. The place just behind
        a name counts as well.
        """
        there = [each for each in self._near(name, offset) if _covers(each, offset)]
        least = min((_length(each) for each in there), default=0)
        return [each for each in there if _length(each) == least]

    def descriptions(self, entities: Iterable[Entity]) -> list[Occurrence]:
        """Return the descriptions of *entities*, the best place first.

        Where a file states a type.
        """
        found = [each for each in self._described(entities) if each.role is Role.DESCRIPTION]
        if len(found) > 1:
            found.sort(key=self._is_untyped)
        return found

    def _described(self, entities: Iterable[Entity]) -> Iterable[Occurrence]:
        """Return the places of *entities*, at least their descriptions."""
        if "_by_entity" in vars(self) or not self.documents or None in self._elements:
            return self._of(entities)
        found: dict[tuple[Path, int, int], Occurrence] = {}
        for entity in dict.fromkeys(entities):
            for elements in filter(None, self._elements):
                for excerpt in elements.describing(entity):
                    for each in self._named(excerpt):
                        if each.entity == entity:
                            found.setdefault(self._place(each), each)
        return found.values()

    def mentions(self, entities: Iterable[Entity]) -> list[Occurrence]:
        """Return every mention of *entities*, in the order of documents and texts."""
        return [each for each in self._of(entities) if each.role is Role.REFERENCE]

    def _of(self, entities: Iterable[Entity]) -> Iterator[Occurrence]:
        """Yield the places of *entities*, one for each range of a text."""
        seen = set()
        for entity in dict.fromkeys(entities):
            for each in self._by_entity.get(entity, ()):
                if (place := self._place(each)) not in seen:
                    seen.add(place)
                    yield each

    def _place(self, each: Occurrence) -> tuple[Path, int, int]:
        return self.paths[each.location.source.name], *each.location.span

    def _is_untyped(self, each: Occurrence) -> bool:
        return (each.location.source.name, each.entity) not in self._typed

    @cached_property
    def _typed(self) -> frozenset[tuple[str, Entity]]:
        """The nodes that a text says the type of."""
        return frozenset(
            (document.source.name, subject)
            for document in self.documents
            for subject, predicate, _ in document.statements
            if predicate == RDF_TYPE
        )


def _covers(each: Occurrence, offset: int) -> bool:
    return each.location.span.start <= offset <= each.location.span.end


def _length(each: Occurrence) -> int:
    return each.location.span.end - each.location.span.start


def element_excerpts(document: Document) -> ElementExcerpts | None:
    """Return the elements of *document*; None if it is not read in parts."""
    from kinlint.navigation.element_excerpts import ElementExcerpts  # noqa: PLC0415  needs PyLD

    return ElementExcerpts.from_document(document)
