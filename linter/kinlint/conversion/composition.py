"""Makes one composable model of what is lifted from robots in XML formats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import PurePath
from urllib.parse import quote

from kinlint.conversion.conversion_losses import Loss, conversion_losses
from kinlint.conversion.expanded_nodes import Node, Order, Statements, absolute_iri, expanded_nodes
from kinlint.conversion.graph_rewriting import rewritten
from kinlint.conversion.published import contexts_for
from kinlint.conversion.rotations import ROTATIONS
from kinlint.document import Document
from kinlint.engine.provenance import Provenance
from kinlint.errors import UsageError
from kinlint.formats.records import ELEMENTS
from kinlint.formats.unread_text import refuse_unread
from kinlint.light_dataclasses import dataclass
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.terms import RDF_TYPE, Term, iri, iri_value, is_literal, literal_value
from kinlint.vocabulary import ATTRIBUTE, METAMODELS

EXAMPLE = "https://example.org/"
"""Namespace of names for which none is given."""

PREFIX = "robot"
GRAPH = "model"
"""Local name of the graph."""

CONTAINS = tuple(f"<{each}" for each in ELEMENTS)
"""Prefixes of the properties that lead from an element to one within it."""
NAME = iri(f"{ATTRIBUTE}name")
INERTIA = iri(f"{METAMODELS}newtonian-rigid-body-dynamics/structural-entities#RigidBodyInertia")
STILL = "the root stands still and has no mass"


@dataclass(frozen=True)
class Composition:
    """A model, or a part of one, as a named graph of nodes in expanded JSON-LD."""

    name: str
    """IRI of the graph."""
    nodes: Sequence[Node]
    """Nodes in the order of the files that they come from."""
    namespaces: Mapping[str, str]
    """Namespaces of the names of nodes, by prefix."""
    losses: Sequence[Loss]
    """Losses of the conversion: parts of the files that the model does not have."""

    @property
    def contexts(self) -> tuple[str, ...]:
        """The contexts that define the terms of the nodes."""
        used: set[str] = set()
        for node in self.nodes:
            used.update(node["@type"])
            used.update(key for key in node if key[0] != "@")
        return contexts_for(used)


def compose(
    documents: Sequence[Document], namespace: str | None = None, rotation: str = ROTATIONS[0]
) -> Composition:
    """Return the model that *documents* describe together, rotations represented by *rotation*.

    Its names live under *namespace*, or under one for each robot. Raises `UsageError` where a
    document is none to be lifted, where nothing is, and where two things would have one name.
    """
    for document in documents:
        if not document.format.is_tree:
            raise UsageError(f"{document.source.name}: composable already, nothing to convert")
    refuse_unread(documents)
    store = run_stages("lifting", Run(()), Inputs(documents))
    lifted = list(store.lifted())
    left_out = conversion_losses(documents, lifted, Provenance(store))
    statements = Statements(rewritten(store, rotation))
    if not statements.subjects:
        raise UsageError(f"{documents[0].source.name}: no links and joints, nothing to convert")
    names = {
        iri_value(each.graph): namespace or f"{EXAMPLE}{quote(robot_name(each), safe='')}#"
        for each in documents
    }
    _distinct(statements, names)
    inertias = {s for s, p, o in lifted if p == RDF_TYPE and o == INERTIA}
    if still := len(inertias.difference(statements.said)):
        left_out.append(Loss("'link/inertial'", still, STILL))
    made = list(expanded_nodes(statements, Order(statements, documents), names))
    return Composition(f"{next(iter(names.values()))}{GRAPH}", made, _prefixes(names), left_out)


def robot_name(document: Document) -> str:
    """The name of the robot: of the root, or of the one model in it; else that of the file."""
    below: dict[Term, list[Term]] = {}
    called: dict[Term, str] = {}
    for s, p, o in document.statements:
        if p == NAME and is_literal(o):
            called[s] = literal_value(o)
        elif p.startswith(CONTAINS):
            below.setdefault(s, []).append(o)
    for root in below.get(document.graph, ()):
        held = [called[each] for each in below.get(root, ()) if each in called]
        if found := called.get(root) or (held[0] if len(held) == 1 else ""):
            return found
    return PurePath(document.source.name).name.partition(".")[0] or PREFIX


def _distinct(statements: Statements, names: Mapping[str, str]) -> None:
    """Raise `UsageError` if two subjects get one name."""
    taken: dict[str, Term] = {}
    for subject in statements.subjects:
        name = absolute_iri(subject, names)
        if taken.setdefault(name, subject) != subject:
            raise UsageError(f"two files both describe <{name}>: convert them one by one")


def _prefixes(names: Mapping[str, str]) -> dict[str, str]:
    """A prefix for each namespace."""
    spaces = dict.fromkeys(names.values())
    return {
        PREFIX if number == 1 else f"{PREFIX}{number}": space
        for number, space in enumerate(spaces, 1)
    }
