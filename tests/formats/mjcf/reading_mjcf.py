"""Reads MJCF for tests, and answers what is stated of its nodes."""

from __future__ import annotations

from pathlib import Path

from kinlint.document import Document
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.terms import RDF_TYPE, Term, iri, is_literal, literal_value
from kinlint.vocabulary import ATTRIBUTE, INHERITED, REFERENCE, SRC

SPACES = {"src": SRC, "inh": INHERITED, "at": ATTRIBUTE, "ref": REFERENCE}


def model(text: str, **attributes: str) -> Document:
    """What the content *text* of a model states."""
    said = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return whole(f"<mujoco{said}>{text}</mujoco>")


def whole(text: str, name: str = "robot.xml") -> Document:
    """What a file with *text* states."""
    return read(decode(name, text.encode()), ReadOptions())


def file(path: Path) -> Document:
    """What the file at *path* states."""
    return read(decode(str(path), path.read_bytes()), ReadOptions())


def node(document: Document, path: str) -> Term:
    """The node of the element at *path*."""
    return f"{document.graph[:-1]}#/{path}>"


def values(document: Document, subject: Term, name: str) -> list[str]:
    """The values of the property *name*, such as src:name, of *subject*."""
    prefix, _, local = name.partition(":")
    wanted = iri(SPACES[prefix] + local)
    found = [o for s, p, o in document.statements if (s, p) == (subject, wanted)]
    return [literal_value(o) if is_literal(o) else o for o in found]


def numbers(document: Document, subject: Term, stem: str, components: str = "x y z") -> list[float]:
    """The components of what is stated by properties with *stem*."""
    parts = [f"{stem}-{each}" if stem[-1] != ":" else stem + each for each in components.split()]
    return [float(each) for part in parts for each in values(document, subject, part)]


def written(document: Document, subject: Term, name: str) -> str:
    """The text where the one value of the property *name* of *subject* is written."""
    prefix, _, local = name.partition(":")
    wanted = iri(SPACES[prefix] + local)
    (triple,) = [each for each in document.statements if each[:2] == (subject, wanted)]
    location = document.location(document.map.triples[triple])
    return location.source[location.span]


def nodes(document: Document, kind: str) -> list[Term]:
    """The nodes of the source layer that are of *kind*."""
    wanted = iri(SRC + kind)
    return [s for s, p, o in document.statements if (p, o) == (RDF_TYPE, wanted)]
