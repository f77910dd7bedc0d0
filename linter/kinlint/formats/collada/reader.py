"""Reads one COLLADA document, and states what its addresses lead to and what its models come to."""

from __future__ import annotations

from kinlint.document import Document, NodeSpans
from kinlint.errors import SourceError
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.collada.address_statements import address_statements
from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_statements import state_assets
from kinlint.formats.collada.binding_statements import BindingStatements
from kinlint.formats.collada.collada_elements import (
    ColladaElement,
    Excess,
    refuse_countless,
    tree,
)
from kinlint.formats.collada.coupling_statements import CouplingStatements
from kinlint.formats.collada.drawn_links import state_open_loops
from kinlint.formats.collada.joint_statements import JointStatements
from kinlint.formats.collada.kinematics import models
from kinlint.formats.collada.mesh_statements import state_materials, state_meshes
from kinlint.formats.collada.physics import PhysicsStatements
from kinlint.formats.collada.structure_statements import state_empty, state_models, state_rings
from kinlint.formats.collada.transform_statements import state_transforms
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xml import reader as xml
from kinlint.formats.xml.added_statements import with_statements
from kinlint.terms import Triple
from kinlint.text import SourceText, Span


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the statements of a COLLADA document; the numbers of meshes are not stated.

    Raises SourceError for a document type definition, and for what no robot is as large as.
    """
    refuse_countless(source)
    document = xml.read(source, options)
    try:
        root = tree(document.graph, document.statements)
    except Excess as excess:
        line, column = source.position(document.map.nodes[excess.node].best.start)
        raise SourceError(source.name, excess.cause, line, column) from None
    return document if root is None else _derived(document, root)


def _derived(document: Document, root: ColladaElement) -> Document:
    """Return *document* with what follows from it."""
    addressing = Addressing(root)
    layer = SourceLayer(document.graph, BlankNodes(f"{document.source.name}#addresses"))
    for kind, attribute, repeated in (
        ("RepeatedIdentifier", "id", addressing.repeated),
        ("RepeatedScopedIdentifier", "sid", addressing.repeated_sids),
    ):
        for element, first in repeated:
            said = element.said[attribute]
            details = ("node", element.node), ("written", said[2]), ("first", first.node)
            layer.add_node(kind, document.map.triples[said], *details)
    triples: dict[Triple, Span | None] = {}
    for triple, of in address_statements(root, addressing):
        triples.setdefault(triple, document.map.triples[of] if of is not None else None)
    found = models(root, addressing)
    said_ = DerivedStatements()
    joints = JointStatements(root, found, addressing, said_)
    joints.state()
    CouplingStatements(root, joints.uses, addressing, said_).state()
    BindingStatements(root, joints.uses, addressing, said_).state()
    state_models(root, found, said_)
    for model in found:
        state_open_loops(model, said_)
    state_rings(root, addressing, said_)
    state_empty(root, said_)
    state_assets(root, said_)
    state_transforms(root, said_)
    state_materials(addressing, said_)
    state_meshes(addressing, document.source.text, document.map.nodes, said_)
    PhysicsStatements(root, found, addressing, said_).state()
    places = document.map.nodes
    for node, element_ in said_.made_of.items():
        layer.nodes[node] = NodeSpans(places[element_].best, None)
    triples.update(dict.fromkeys(said_.triples))
    return with_statements(document, layer, triples)
