"""The prefixes that a SPARQL text in a shapes graph may use: SHACL 5.2.1."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from kinlint.engine.compiler.shacl_terms import IMPORTS, sh
from kinlint.terms import Term, is_literal, literal_value

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph


def declared(graph: ShapesGraph, node: Term) -> Mapping[str, str]:
    """Return the namespaces by prefix that `sh:prefixes` of *node* gives, imports followed."""
    return namespaces(graph, *graph.values(node, sh("prefixes")))


def namespaces(graph: ShapesGraph, *ontologies: Term) -> Mapping[str, str]:
    """Return the namespaces by prefix that *ontologies* declare, with those that they import."""
    if ontologies not in graph.namespaces:
        graph.namespaces[ontologies] = _namespaces(graph, ontologies)
    return graph.namespaces[ontologies]


def _namespaces(graph: ShapesGraph, ontologies: tuple[Term, ...]) -> dict[str, str]:
    found: dict[str, str] = {}
    todo, seen = list(ontologies), set[Term]()
    while todo:
        ontology = todo.pop()
        if ontology in seen:
            continue
        seen.add(ontology)
        todo += graph.values(ontology, IMPORTS)
        for declaration in graph.values(ontology, sh("declare")):
            prefix, namespace = (
                _text(graph, declaration, name) for name in ("prefix", "namespace")
            )
            if found.setdefault(prefix, namespace) != namespace:
                raise graph.invalid(
                    ontology, f"the prefix '{prefix}:' is declared for two namespaces"
                )
    return found


def _text(graph: ShapesGraph, declaration: Term, name: str) -> str:
    value = graph.one(declaration, sh(name))
    if value is None or not is_literal(value):
        raise graph.invalid(declaration, f"this prefix declaration lacks sh:{name}")
    return literal_value(value)
