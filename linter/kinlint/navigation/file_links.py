"""Links from a text to files and pages: includes, contexts, meshes and textures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinlint.addresses import document_iri
from kinlint.document import Document
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.formats.options import ReadOptions
from kinlint.formats.xml.references import file_names
from kinlint.light_dataclasses import dataclass
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import iri, literal_value
from kinlint.text import Location, SourceText
from kinlint.vocabulary import SDF, SRC

INCLUDES, USES, CONTEXT = (iri(f"{SRC}{name}") for name in ("includes", "usesContext", "context"))
INSIDE, URI, TEXT = iri(f"{SDF}sdf"), iri(f"{SDF}uri"), iri(f"{SRC}text")
ADDRESS = "://"


@dataclass(frozen=True, slots=True)
class Link:
    """A place where a file or a page is named."""

    location: Location
    """The place."""
    target: Path | str
    """The file, or the address of the page."""
    source: SourceText | None = None
    """The text of the file, if it is one of the model."""


def links(
    documents: Sequence[Document], options: ReadOptions, contexts: Mapping[str, Path]
) -> Iterator[Link]:
    """Yield every link in *documents*, read with *options*; *contexts* are files, by IRI."""
    for document in documents:
        said = StatementIndex(document)
        yield from _included(document, said)
        yield from _contexts(document, said, contexts)
        near = absolute(document.source.name).parent
        yield from _files(document, said, near, options.packages_of(document.source.name))


def _included(document: Document, said: StatementIndex) -> Iterator[Link]:
    """Yield the files that are part of the document, in xacro and in SDF."""
    texts = {document_iri(each.name): each for each in document.sources}
    for value in said.values(document.graph, INCLUDES):
        place, text = said.place(document.graph, INCLUDES, value), texts.get(value)
        if place is not None and text is not None:
            yield Link(place, absolute(text.name), text)
    for include in said.having(INSIDE):
        root = next(said.values(include, INSIDE))
        if include == document.graph or (spans := document.map.nodes.get(root)) is None:
            continue
        text = document.location(spans.best).source
        for uri in said.values(include, URI):
            for written in said.values(uri, TEXT):
                if (place := said.place(uri, TEXT, written)) is not None:
                    yield Link(place, absolute(text.name), text)


def _contexts(
    document: Document, said: StatementIndex, contexts: Mapping[str, Path]
) -> Iterator[Link]:
    for use in said.values(document.graph, USES):
        place = said.place(document.graph, USES, use)
        if place is None:
            continue
        for context in said.values(use, CONTEXT):
            name = literal_value(context)
            if name in contexts:
                yield Link(place, contexts[name])
            elif ADDRESS in name:
                yield Link(place, name)


def _files(
    document: Document, said: StatementIndex, near: Path, packages: Packages
) -> Iterator[Link]:
    """Yield the meshes and textures that are there."""
    for element, predicate, value in file_names(document):
        place, written = said.place(element, predicate, value), literal_value(value)
        path = packages.resolve(written, near)
        if path is None and ADDRESS not in written and "$" not in written:
            path = absolute(near / written)
        if place is not None and path is not None and path.is_file():
            yield Link(place, path)
