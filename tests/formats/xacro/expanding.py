"""Xacro projects in a directory, read and linted as kinlint does."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from kinlint.document import Document
from kinlint.files.packages import Packages
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import SRC

XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def project(directory: Path, **files: str) -> Path:
    """Write *files*, by name without suffix, as xacro files; the path of the first."""
    for name, text in files.items():
        path = directory / f"{name}.xacro"
        path.write_text(text, encoding="utf-8")
    return directory / f"{next(iter(files))}.xacro"


def robot(*inside: str, name: str = "arm") -> str:
    """The text of a xacro file, each of *inside* on a line of its own from line 2 on."""
    return "\n".join((f'<robot name="{name}" {XMLNS}>', *inside, "</robot>", ""))


def document(path: Path, **arguments: str) -> Document:
    """What the file at *path* states, packages looked for as by default."""
    options = ReadOptions(
        packages_of=lambda _: Packages(environment={}), xacro_arguments_of=lambda _: arguments
    )
    return read(decode(str(path), path.read_bytes()), options)


def places(found: Document, predicate: str, value: str) -> list[str]:
    """Where *value* is given as `predicate`: file, line, column, and the text there."""
    return [
        shown(found, triple)
        for triple in found.statements
        if triple[1].endswith(f"#{predicate}>") and literal_value(triple[2]) == value
    ]


def shown(found: Document, triple: tuple[Term, Term, Term]) -> str:
    """The place of *triple*."""
    location = found.location(found.map.triples[triple])
    line, column = location.start
    return f"{Path(location.source.name).name}:{line}:{column} {location.source[location.span]}"


def said(found: Document, kind: str, prop: str) -> list[tuple[str, str]]:
    """What the source layer says of *kind*: the value of *prop*, and where."""
    nodes = {s for s, _, o in found.statements if o == iri(f"{SRC}{kind}")}
    return [
        (literal_value(triple[2]), shown(found, triple))
        for triple in found.statements
        if triple[0] in nodes and triple[1] == iri(f"{SRC}{prop}")
    ]


def failure(found: Document) -> tuple[str, str]:
    """Why a file did not expand, and where."""
    (only,) = said(found, "ExpansionFailure", "reason")
    return only


def names(found: Document) -> Mapping[str, int]:
    """How often each name is given to an element."""
    counts: dict[str, int] = {}
    for _, predicate, value in found.statements:
        if predicate.endswith("attribute#name>"):
            counts[literal_value(value)] = counts.get(literal_value(value), 0) + 1
    return counts
