"""Shapes as the shapes graph describes them: SHACL 2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinlint.engine.compiler.property_path import Path, read_path
from kinlint.engine.compiler.shacl_terms import CLASS, RULE_CLASS, SUBCLASS, TYPE, sh
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri_value, is_iri, is_literal, literal_value

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph

_KINDS = ("targetNode", "targetClass", "targetSubjectsOf", "targetObjectsOf", "target")
TARGETS = tuple(sh(kind) for kind in _KINDS)


@dataclass(frozen=True)
class Shape:
    """A node shape, or with a `path` a property shape."""

    graph: ShapesGraph
    """Triples of all shapes."""
    node: Term
    """Node that states the shape."""
    path: Path | None
    """Path of a property shape; None for a node shape."""

    def values(self, name: str) -> list[Term]:
        """Return the values of a SHACL property of this shape, in the order of the text."""
        return self.graph.values(self.node, sh(name))

    def one(self, name: str) -> Term | None:
        """Return the only value of a SHACL property, or None."""
        return self.graph.one(self.node, sh(name))

    @property
    def deactivated(self) -> bool:
        """True if the shape is switched off."""
        return self.graph.is_true(self.node, sh("deactivated"))

    @property
    def severity(self) -> str:
        """The IRI of the severity of its results."""
        return iri_value(self.one("severity") or sh("Violation"))

    @property
    def messages(self) -> tuple[str, ...]:
        """Its own messages, those for readers of English first."""
        return messages(self.graph, self.node)

    @property
    def owner(self) -> str:
        """The IRI of the only rule in its file; else that of the shape itself."""
        home = self.graph.home(self.node)
        rules = {s for s, p, o in home.triples if p == TYPE and o == RULE_CLASS}
        if len(rules) == 1:
            return iri_value(rules.pop())
        return iri_value(self.node) if is_iri(self.node) else self.node


def read_shape(graph: ShapesGraph, node: Term) -> Shape:
    """Return the shape that *node* describes; a value that cannot be a shape is refused."""
    if is_literal(node):
        raise graph.invalid(node, "a literal is not a shape")
    path = graph.one(node, sh("path"))
    return Shape(graph, node, read_path(graph, path) if path else None)


def messages(graph: ShapesGraph, node: Term) -> tuple[str, ...]:
    """Return the texts of `sh:message` of *node*: untagged and English ones first."""

    def rank(message: Term) -> int:
        tag = message[message.rindex('"') + 1 :].lower()
        return 0 if not tag or tag == "@en" else 1 if tag.startswith("@en-") else 2

    found = [m for m in graph.values(node, sh("message")) if is_literal(m)]
    return tuple(literal_value(message) for message in sorted(found, key=rank))


def target_shapes(graph: ShapesGraph) -> list[Shape]:
    """Return the shapes that have targets, in the order of the files."""
    return [
        read_shape(graph, node)
        for node in graph.subjects()
        if graph.values(node, *TARGETS) or is_class_shape(graph, node)
    ]


def is_class_shape(graph: ShapesGraph, node: Term) -> bool:
    """Tell whether *node* is a shape and a class, and so its own target: SHACL 2.1.3.3."""
    types = graph.values(node, TYPE)
    if not {sh("NodeShape"), sh("PropertyShape")} & set(types):
        return False
    seen: set[Term] = set()
    while types:
        kind = types.pop()
        if kind == CLASS:
            return is_iri(node)
        if kind not in seen:
            seen.add(kind)
            types += graph.values(kind, SUBCLASS)
    return False
