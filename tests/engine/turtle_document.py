"""Documents from Turtle, for tests of what happens after reading."""

from __future__ import annotations

import pyoxigraph as ox

from kinlint.document import Document, SourceMap
from kinlint.formats.turtle.format import TURTLE
from kinlint.terms import Triple
from kinlint.text import SourceText, Span

PREFIXES = """
    @prefix : <https://example.org/> .
    @prefix owl: <http://www.w3.org/2002/07/owl#> .
    @prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
    @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
    @prefix sh: <http://www.w3.org/ns/shacl#> .
    @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
"""


def ex(name: str) -> str:
    return f"<https://example.org/{name}>"


def triples(turtle: str) -> tuple[Triple, ...]:
    quads = ox.parse(PREFIXES + turtle, ox.RdfFormat.TURTLE)
    return tuple((str(q.subject), str(q.predicate), str(q.object)) for q in quads)


def document(turtle: str, name: str = "arm.ttl") -> Document:
    statements = triples(turtle)
    spans = {triple: Span(0, 0) for triple in statements}
    graph = f"<urn:kinlint:document:{name}>"
    return Document(SourceText(name, turtle), graph, statements, SourceMap(spans), format=TURTLE)
