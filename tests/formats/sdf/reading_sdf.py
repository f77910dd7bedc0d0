"""Reads SDF in tests."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from support import linting

from kinlint.document import Document
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import SRC


def document(text: str, name: str = "robot.sdf") -> Document:
    """*text* read as SDF."""
    return linting.document(text, name, "sdf")


def model(body: str, version: str = "1.9", attributes: str = "") -> Document:
    """A model called arm of *body*."""
    return document(f'<sdf version="{version}"><model name="arm"{attributes}>{body}</model></sdf>')


def file(path: Path) -> Document:
    """The file at *path*."""
    return linting.document(path.read_bytes(), str(path), "sdf")


def said(read_: Document, element: str, name: str) -> list[Term]:
    """What the source layer says by *name* of the element at the path *element*."""
    node = iri(f"{read_.graph[1:-1]}#{element}")
    return [o for s, p, o in read_.statements if s == node and p == iri(SRC + name)]


def paths(read_: Document, terms: list[Term]) -> list[str]:
    """The paths of elements."""
    return [term[1:-1].removeprefix(f"{read_.graph[1:-1]}#") for term in terms]


def numbers(read_: Document, element: str, prefix: str, *names: str) -> list[float]:
    """Numbers that were worked out."""
    found = [said(read_, element, f"{prefix}{name}") for name in names]
    return [float(literal_value(each)) for (each,) in found]


def losses(read_: Document, kind: str) -> list[dict[str, Any]]:
    """The statements of *kind*, each as a mapping, with the text that it is about."""
    nodes = [s for s, p, o in read_.statements if o == iri(SRC + kind) and p.endswith("#type>")]
    found = []
    for node in nodes:
        details = {
            p[len(SRC) + 1 : -1]: literal_value(o) if o.startswith('"') else o
            for s, p, o in read_.statements
            if s == node and p.startswith(f"<{SRC}")
        }
        place = read_.location(read_.map.nodes[node].best)
        found.append({**details, "text": place.source[place.span], "file": place.source.name})
    return found


def gaps(read_: Document) -> list[dict[str, Any]]:
    """What is said of each name that stands for nothing, with the text of the name."""
    found = []
    for element, property_, gap in read_.statements:
        if property_ == iri(f"{SRC}dangling"):
            said_ = {p[len(SRC) + 1 : -1]: o for s, p, o in read_.statements if s == gap}
            place = read_.location(read_.map.triples[element, said_["property"], said_["written"]])
            texts = {key: literal_value(o) for key, o in said_.items() if o.startswith('"')}
            source = place.source
            found.append({**said_, **texts, "text": source[place.span], "file": source.name})
    return found
