"""Names of the parts of robots, by what they are names of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from urllib.parse import unquote

from kinlint.addresses import document_of, split, unordered
from kinlint.document import Document
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri, iri_value, literal_value
from kinlint.vocabulary import ATTRIBUTE


@dataclass(frozen=True)
class NamedPart:
    """An element that has a name."""

    namespace: str
    """Namespace of its format."""
    path: tuple[str, ...]
    """Tags and names on the way to it, unquoted; empty for a root."""
    tag: str
    """Its tag."""
    name: str
    """Its name."""
    document: Term
    """Document that it is in."""


class KnownNames:
    """The named elements of *documents*."""

    def __init__(self, documents: Sequence[Document]) -> None:
        self._documents = [each for each in documents if each.format.is_tree]

    @cached_property
    def parts(self) -> Sequence[NamedPart]:
        """All of them, in the order of the texts."""
        return tuple(part for document in self._documents for part in _parts(document))

    @cached_property
    def _by_kind(self) -> Mapping[tuple[str, str], Sequence[NamedPart]]:
        found: dict[tuple[str, str], list[NamedPart]] = {}
        for part in self.parts:
            if len(part.path) <= len(("tag", "name")):
                found.setdefault((part.namespace, part.tag), []).append(part)
        return found

    def outermost(self, namespace: str, tag: str) -> Sequence[NamedPart]:
        """Return the elements with *tag* that are right below a root, or are roots."""
        return self._by_kind.get((namespace, tag), ())


def _parts(document: Document) -> Iterator[NamedPart]:
    table = schema(document.format.lifted_as)
    naming = iri(ATTRIBUTE + table.names)
    roots = sorted(table.roots)
    for subject, predicate, value in document.statements:
        if predicate != naming:
            continue
        path = split(iri_value(subject))[1].removeprefix("/")
        steps = tuple(unquote(each) for each in path.split("/")) if path else ()
        tag = unordered(steps[-2] if len(steps) > 1 else steps[-1]) if steps else roots[0]
        name = literal_value(value)
        yield NamedPart(table.namespace, steps, tag, name, document_of(subject))
