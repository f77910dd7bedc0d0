"""Index of all that is named in a model, by place and by entity."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from kinlint.document import Document
from kinlint.navigation.element_names import named_elements
from kinlint.navigation.graph_terms import terms
from kinlint.navigation.json_terms import keys_and_names
from kinlint.navigation.occurrence import Entity, Occurrence, Role
from kinlint.navigation.text_names import Paths
from kinlint.navigation.xacro_names import xacro_names
from kinlint.terms import RDF_TYPE


class Index:
    """The places in *documents* where something is named."""

    def __init__(self, documents: Sequence[Document]) -> None:
        self.documents = documents
        self.paths = Paths()

    @cached_property
    def occurrences(self) -> Sequence[Occurrence]:
        """All of them, each once, document by document in the order of the texts."""
        found: dict[tuple[Path, int, int, Entity], Occurrence] = {}
        for document in self.documents:
            for each in sorted(self._named_in(document), key=self._place):
                found.setdefault((*self._place(each), each.entity), each)
        return tuple(found.values())

    def _named_in(self, document: Document) -> Iterator[Occurrence]:
        if document.format.is_tree:
            yield from named_elements(document)
            yield from xacro_names(document)
            return
        named = list(terms(document))
        yield from named
        if document.format.fence == "json":
            known = {each.location.span: each.entity for each in reversed(named)}
            yield from keys_and_names(document, known)

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
        there = [
            each
            for each in self._by_text.get(self.paths[name], ())
            if each.location.span.start <= offset <= each.location.span.end
        ]
        least = min((_length(each) for each in there), default=0)
        return [each for each in there if _length(each) == least]

    def descriptions(self, entities: Iterable[Entity]) -> list[Occurrence]:
        """Return the descriptions of *entities*, the best place first.

        Where a file states a type.
        """
        found = [each for each in self._of(entities) if each.role is Role.DESCRIPTION]
        if len(found) > 1:
            found.sort(key=self._is_untyped)
        return found

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


def _length(each: Occurrence) -> int:
    return each.location.span.end - each.location.span.start
