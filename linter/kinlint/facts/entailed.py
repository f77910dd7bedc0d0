"""The classes that nodes are of only because something else follows."""

from __future__ import annotations

from collections.abc import Iterator

import pyoxigraph as ox

from kinlint.engine.store import token
from kinlint.facts.names import kin
from kinlint.facts.scan import Scan
from kinlint.facts.statement import fact
from kinlint.terms import RDF_TYPE, Triple, iri_value
from kinlint.vocabulary import INFERRED_GRAPH


def entailed_types(scan: Scan) -> Iterator[Triple]:
    """The inferred types of classes that the ontology wants stated with others."""
    graph, type_ = ox.NamedNode(iri_value(INFERRED_GRAPH)), ox.NamedNode(iri_value(RDF_TYPE))
    store = scan.store.oxigraph
    stated_with = ox.NamedNode(iri_value(kin("statedWith")))
    kinds = {quad.object for quad in store.quads_for_pattern(None, stated_with, None, None)}
    for kind in sorted(kinds, key=str):
        for quad in store.quads_for_pattern(None, type_, kind, graph):
            yield token(quad.subject), fact("entailed-type"), token(kind)
