"""States which files that models refer to are not there, as the rules about references ask."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from os.path import relpath
from pathlib import Path, PurePosixPath

from kinlint.document import Document
from kinlint.files.environment import kind
from kinlint.files.file_exists import AbsentDirectory, Fault, Missing, References, UnknownPackage
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.formats.urdf.mujoco_directories import mujoco_directories
from kinlint.formats.xml.references import file_names
from kinlint.terms import RDF_TYPE, XSD, Term, Triple, iri, iri_value, literal, literal_value
from kinlint.vocabulary import SRC

CLASSES = {
    Missing: iri(f"{SRC}MissingFile"),
    UnknownPackage: iri(f"{SRC}UnresolvedPackage"),
    AbsentDirectory: iri(f"{SRC}AbsentDirectory"),
}
MESH = iri(f"{SRC}MeshDocument")
"""Class of what is said of a COLLADA mesh (`kinlint.formats.collada.mesh_documents`)."""
NODE, NAME, RESEMBLES, PRESENT = (
    iri(f"{SRC}{name}") for name in ("node", "name", "resembles", "present")
)
FILES_IN, STRIPPED = iri(f"{SRC}filesIn"), iri(f"{SRC}strippedPath")
"""The directory, from that of the whole document, in which files that an element names are looked
for first, and whether this is done without the directories in their names."""
UNREAD = iri(f"{SRC}MissingForMujoco")
"""Class of what is said of a file that is not where the settings for MuJoCo say."""
OF_MESHES = ("metres", "up", "fault", "kind", "written", "line")
STATED = frozenset(
    {
        *CLASSES.values(),
        NODE,
        NAME,
        RESEMBLES,
        PRESENT,
        MESH,
        UNREAD,
        *(iri(f"{SRC}{name}") for name in OF_MESHES),
    }
)
"""The properties and classes of what is said of a file that is not found, and of a mesh."""


def references(
    documents: Iterable[Document],
    packages_of: Callable[[str], Packages],
    wanted: Collection[Term] | None = None,
) -> Iterator[Triple]:
    """Yield a node for each reference in *documents* to a file that is not found, saying why not.

    A path is meant from the file in which it stands, be it one that another includes.

    *packages_of* has the packages that the file of a name can name. With *wanted*, nothing is
    looked up unless one of these terms is such a reason.
    """
    if not asks_for_files(wanted):
        return
    lookups: dict[int, References] = {}
    meshes: dict[Path, tuple[Term, Path]] = {}
    for document in documents:
        packages = packages_of(document.source.name)
        known = lookups.setdefault(id(packages), References(packages))
        directories = _directories(document)
        found, lost = _sought_by_mujoco(document, known)
        yield from lost
        for triple in file_names(document):
            written, near = literal_value(triple[2]), _home(document, triple)
            fault = None if triple[0] in found else known.fault(written, near)
            if fault is not None and triple[0] in directories:
                near = absolute(document.source.name).parent
                place = directories[triple[0]]
                fault = known.fault(_below(place, written), near)
                if isinstance(fault, Missing) and fault.resembles:
                    fault = Missing(relpath(fault.resembles, place[0] or "."))
            if fault is not None:
                yield from _stated(triple[0], fault, near)
            elif written.lower().endswith(".dae") and (path := known.path(written, near)):
                meshes.setdefault(path, (triple[0], near))
    if meshes and (wanted is None or MESH in wanted):
        # Few robots name any.
        from kinlint.formats.collada.mesh_documents import mesh_statements  # noqa: PLC0415

        yield from mesh_statements(meshes)


def asks_for_files(wanted: Collection[Term] | None) -> bool:
    """Tell whether one of the terms *wanted* says that a file is not found, or of a mesh."""
    return wanted is None or not {*CLASSES.values(), MESH, UNREAD}.isdisjoint(wanted)


def _home(document: Document, triple: Triple) -> Path:
    """Return the directory of the file of *document* in which *triple* stands.

    What macros write stands in the file that they are expanded for.
    """
    included = document.pieces and document.format.expands_to is None
    span = document.map.triples.get(triple) if included else None
    source = document.source if span is None else document.location(span).source
    return absolute(source.name).parent


def _directories(document: Document) -> Mapping[Term, tuple[str, bool]]:
    """Return where files are that elements of *document* name, and if by the last part alone."""
    if not document.format.includes:
        return {}
    stripped = {element for element, _, _ in document.saying(STRIPPED)}
    return {s: (literal_value(o), s in stripped) for s, _, o in document.saying(FILES_IN)}


def _sought_by_mujoco(document: Document, known: References) -> tuple[set[Term], list[Triple]]:
    """Return the elements of a URDF whose files are where its settings for MuJoCo say.

    With them, what is to be said of others, whose files are only where they are for others.
    """
    found, lost = set[Term](), list[Triple]()
    directories = mujoco_directories(document)
    for element, _, name in file_names(document) if directories else ():
        if (place := directories.get(element)) is None:
            continue
        written, near = literal_value(name), absolute(document.source.name).parent
        if known.fault(_below(place, written), near) is None:
            found.add(element)
        elif known.fault(written, near) is None and (place[1] or "://" not in written):
            node = iri(f"{iri_value(element)};mujoco-file")
            lost += (node, RDF_TYPE, UNREAD), (node, NODE, element), (node, NAME, literal(place[0]))
    return found, lost


def _below(place: tuple[str, bool], written: str) -> str:
    """Return the path of the file *written*, of which *place* is the directory."""
    path = PurePosixPath(written.replace("\\", "/"))
    return str(PurePosixPath(place[0].replace("\\", "/")) / (path.name if place[1] else path))


def _stated(element: Term, fault: Fault, near: Path) -> Iterator[Triple]:
    node = iri(f"{iri_value(element)};file")
    yield node, RDF_TYPE, CLASSES[type(fault)]
    yield node, NODE, element
    if isinstance(fault, Missing):
        if fault.resembles is not None:
            yield node, RESEMBLES, literal(fault.resembles)
    else:
        yield node, NAME, literal(fault.name)
        if isinstance(fault, AbsentDirectory) and kind(near / fault.name) == "directory":
            yield node, PRESENT, literal("true", f"{XSD}boolean")
