"""Reads robots in XML in tests."""

from __future__ import annotations

from kinlint.document import Document
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import Term, iri_value, is_blank, is_iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, REFERENCE, SRC

OPTIONS = ReadOptions()
ALWAYS = {"document", "offset", "node"}


def model(text: str | bytes, name: str = "arm.urdf") -> Document:
    """*text* read as the file *name*."""
    data = text if isinstance(text, bytes) else text.encode()
    return read(decode(name, data), OPTIONS)


def short(document: Document, term: Term) -> str:
    """*term* as these tests write it."""
    if not is_iri(term):
        return literal_value(term) if term.startswith('"') else term
    name = iri_value(term).removeprefix(iri_value(document.graph))
    spaces = ((ATTRIBUTE, "@"), (EXTENSION, "ext:"), (REFERENCE, "ref:"), (SRC, "src:"))
    for space, prefix in spaces:
        name = name.replace(space, prefix)
    return name.removeprefix(document.format.namespace or "")


def graph(document: Document) -> list[tuple[str, str, str]]:
    """What a file says of its elements."""
    return [
        (short(document, s), short(document, p), short(document, o))
        for s, p, o in document.statements
        if not is_blank(s) and not is_blank(o) and f"<{SRC}describedIn>" != p
        if s != document.graph or not p.startswith(f"<{SRC}")
        if "22-rdf-syntax-ns" not in p
    ]


def remarks(document: Document, kind: str | None = None) -> list[tuple[str, str, dict[str, str]]]:
    """Kind, text and details of what is remarked besides."""
    found: dict[Term, tuple[str, str, dict[str, str]]] = {}
    for s, p, o in document.statements:
        if not is_blank(s):
            continue
        name = short(document, p)
        if name.endswith("22-rdf-syntax-ns#type"):
            place = document.source[document.map.nodes[s].whole]
            found[s] = (short(document, o).removeprefix("src:"), place, {})
        elif s in found and name.removeprefix("src:") not in ALWAYS:
            found[s][2][name.removeprefix("src:")] = short(document, o)
    return [each for each in found.values() if kind in (None, each[0])]


def flaws(document: Document) -> list[tuple[str, str]]:
    """Where a file is not well-formed, and why."""
    return [(place, said["reason"]) for _, place, said in remarks(document, "MalformedText")]
