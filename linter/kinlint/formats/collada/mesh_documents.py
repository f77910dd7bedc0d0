"""States what is wrong inside the COLLADA meshes that robots name, each read once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.environment import modified
from kinlint.formats.collada.address_statements import address_statements
from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement, tree
from kinlint.formats.collada.format import COLLADA
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import src
from kinlint.formats.xml import reader as xml
from kinlint.light_dataclasses import dataclass
from kinlint.terms import RDF_TYPE, XSD, Term, Triple, iri, iri_value, literal, literal_value

LARGEST = 1 << 24
"""Most bytes of a mesh that is looked into."""
MOST_BYTES = 1 << 27
"""Most bytes of all meshes of a run that are looked into."""


@dataclass(frozen=True)
class Fault:
    """Kind of fault in a mesh, with the first place."""

    kind: str
    """"dangling", "repeated", "count" or "unreadable"."""
    written: str
    """Text at that place, or the reason for which the mesh cannot be read."""
    line: int
    """Its line."""


@dataclass(frozen=True)
class MeshDocument:
    """Properties of a mesh that readers may take differently."""

    metres: float
    """Its unit of length."""
    up: str
    """Its axis that points up; empty if not stated."""
    faults: tuple[Fault, ...]
    """Its faults."""


def mesh_statements(meshes: Mapping[Path, tuple[Term, Path]]) -> Iterator[Triple]:
    """Yield statements about *meshes*: by their paths the first element and directory to name it.

    Those that are too large, or cannot be opened, are passed over.
    """
    left = MOST_BYTES
    for path, (element, near) in meshes.items():
        stamp = modified(path)
        if stamp is None or stamp[1] > min(left, LARGEST):
            continue
        left -= stamp[1]
        found = _examined(path, near, stamp)
        if found is not None:
            yield from _stated(element, path.name, found)


def _stated(element: Term, name: str, mesh: MeshDocument) -> Iterator[Triple]:
    node = iri(f"{iri_value(element)};mesh")
    yield node, RDF_TYPE, src("MeshDocument")
    yield node, src("node"), element
    yield node, src("name"), literal(name)
    if all(each.kind != "unreadable" for each in mesh.faults):
        yield node, src("metres"), literal(repr(mesh.metres), f"{XSD}double")
        yield node, src("up"), literal(mesh.up)
    for each in mesh.faults:
        fault = iri(f"{iri_value(node)};{each.kind}")
        yield node, src("fault"), fault
        yield fault, src("kind"), literal(each.kind)
        yield fault, src("written"), literal(each.written)
        yield fault, src("line"), literal(str(each.line), f"{XSD}integer")


@lru_cache(maxsize=1000)
def _examined(path: Path, near: Path, _stamp: tuple[int, int]) -> MeshDocument | None:
    """Return what the file at *path* is like; None if it is not to be opened, or no COLLADA."""
    try:
        source = decode(path.name, contents(path, near, LARGEST))
        if source.format != COLLADA:
            return None
        document = xml.read(source, ReadOptions())
    except Unreadable:
        return None
    except SourceError as error:
        return MeshDocument(1.0, "", (Fault("unreadable", error.cause, error.line or 1),))
    root = tree(document.graph, document.statements)
    if root is None:
        return MeshDocument(1.0, "", (Fault("unreadable", "it has no <COLLADA>", 1),))
    up = root.first("asset", "up_axis")

    def line(triple: Triple) -> int:
        return source.position(document.map.triples[triple].start).line

    addressing = Addressing(root)
    dangling = [
        of
        for (_, way, _), of in address_statements(root, addressing)
        if of is not None and way.endswith("dangling>")
    ]
    repeated = [each.said["id"] for each, _ in addressing.repeated]
    counts = [each.said["count"] for each in root.below() if _is_miscounted(each)]
    kinds = {"dangling": dangling, "repeated": repeated, "count": counts}
    faults = (
        Fault(kind, literal_value(said[0][2]), line(said[0]))
        for kind, said in kinds.items()
        if said
    )
    return MeshDocument(metres(root), up.text() if up is not None else "", tuple(faults))


def _is_miscounted(element: ColladaElement) -> bool:
    """Tell whether *element* is an array that has not as many words as it says."""
    words = element.words
    return words is not None and "count" in element.said and element.text("count") != str(words)
