"""States what MuJoCo's compiler makes of an MJCF document, and where each value is written."""

from __future__ import annotations

from kinlint.document import Document
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.mjcf.asset_files import state_directories
from kinlint.formats.mjcf.body_statements import BodyStatements
from kinlint.formats.mjcf.compiled_model import CompiledModel
from kinlint.formats.mjcf.contact_masks import state_unmet
from kinlint.formats.mjcf.convention_statements import state_conventions
from kinlint.formats.mjcf.keyframe_statements import KeyframeStatements
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.mjcf_references import KnownNames, references
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.formats.mjcf.relation_statements import RelationStatements
from kinlint.formats.mjcf.unread_attributes import unchecked, unread
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.xml.added_statements import with_statements
from kinlint.terms import RDF_TYPE, Triple, literal
from kinlint.text import Span

UNREAD = (src("UnresolvedInclude"), src("CircularInclude"), src("RepeatedInclude"))
UNLISTED = (src("UndeclaredAttribute"), src("UndeclaredElement"), src("LaterFeature"))


def stated(document: Document, root: MjcfElement) -> Document:
    """Return *document* with what its elements, below *root*, come to."""
    model = CompiledModel.from_root(root)
    said = ModelStatements()
    BodyStatements(model, said).state()
    RelationStatements(model, said).state()
    KeyframeStatements(model, said).state()
    state_unmet(model, said)
    state_conventions(model, said)
    state_directories(root, model.settings, said)
    found = dict(said.triples)
    unread_file = any(p == RDF_TYPE and o in UNREAD for _, p, o in document.statements)
    whole = root.tag == "mujoco" and bool(model.bodies) and not unread_file
    names = KnownNames.from_model(root, model)
    found |= dict(references(root, names, model, certain=whole))
    for each, first in (*names.repeated, *model.repeated):
        found[each.node, src("sameNameAs"), first.node] = None
    layer = SourceLayer(document.graph, BlankNodes(f"{document.source.name}#compiled"))
    for node, element in said.made_of.items():
        spans = document.map.nodes.get(element)
        if spans is not None:
            layer.nodes[node] = spans
    _state_losses(document, model, layer)
    _state_unchecked(document, root, found)
    return with_statements(document, layer, derived=found)


def _state_losses(document: Document, model: CompiledModel, layer: SourceLayer) -> None:
    """State attributes that are not read, and copies that are not made."""
    for each in unread(model):
        said = each.element.said[each.attribute][each.first]
        layer.add_node(
            "UnreadAttribute",
            document.map.triples[said],
            ("node", each.element.node),
            ("tag", literal(each.element.tag)),
            ("attribute", literal(each.attribute)),
            ("reason", literal(each.reason)),
        )
    for element in dict.fromkeys(model.excessive):
        layer.add_node("UnmadeCopies", _span(document, element), ("node", element.node))


def _state_unchecked(
    document: Document, root: MjcfElement, found: dict[Triple, Triple | None]
) -> None:
    """State in which frame attributes stand that the format, or a former one, lacks, if in any."""
    inside = {element.node: frame.node for element, frame in unchecked(root)}
    kinds = {s for s, p, o in document.statements if p == RDF_TYPE and o in UNLISTED}
    for node, predicate, element in document.statements:
        if node in kinds and predicate == src("node") and element in inside:
            found[node, src("uncheckedIn"), inside[element]] = None


def _span(document: Document, element: MjcfElement) -> Span:
    return document.map.nodes[element.node].best
