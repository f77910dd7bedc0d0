"""What the names in an SDF file stand for, as its scopes have it."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.document import Document
from kinlint.formats.sdf.scopes import Scopes
from kinlint.formats.sdf.tree import Element, tree
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, SRC

OUTSIDE = frozenset({"relative_to", "frame", "attached_to", "expressed_in", "joint"})
"""Attributes whose value is a name in the scope around what they belong to."""
INSIDE = frozenset({"canonical_link", "placement_frame"})
"""Attributes of a model whose value is a name in it."""
TEXTS = frozenset({"parent", "child", "gearbox_reference_body"})
"""Elements of a joint whose text is a name in the scope around it."""
TEXT = iri(f"{SRC}text")


def sdf_names(document: Document, said: StatementIndex) -> Iterator[tuple[Triple, Term]]:
    """The attributes and texts of *document* that name a frame, each with what they name."""
    root = tree(document.graph, document.statements)
    if root is None:
        return
    scopes = Scopes.below(root)
    for owner in scopes.around:
        for carrier in _belonging(owner, scopes):
            for name in carrier.attributes.keys() & OUTSIDE:
                attribute = iri(f"{ATTRIBUTE}{name}")
                yield from _meant(said, carrier, attribute, owner, scopes)
            if carrier.tag in TEXTS and carrier.parent is owner:
                yield from _meant(said, carrier, TEXT, owner, scopes)
        for name in owner.attributes.keys() & INSIDE if owner.tag == "model" else ():
            found = scopes.inside(owner.attributes[name], owner)
            if isinstance(found, Element):
                attribute = iri(f"{ATTRIBUTE}{name}")
                for value in said.values(owner.node, attribute):
                    yield (owner.node, attribute, value), found.node


def _belonging(owner: Element, scopes: Scopes) -> Iterator[Element]:
    """*owner* and all within it that is in no scope of its own."""
    pending = [owner]
    while pending:
        element = pending.pop()
        yield element
        pending += [each for each in element.children if each not in scopes.around]


def _meant(
    said: StatementIndex, carrier: Element, property_: Term, owner: Element, scopes: Scopes
) -> Iterator[tuple[Triple, Term]]:
    for value in said.values(carrier.node, property_):
        found = scopes.find(literal_value(value).strip(), owner)
        if isinstance(found, Element):
            yield (carrier.node, property_, value), found.node
