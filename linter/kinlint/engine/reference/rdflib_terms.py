"""Tokens as rdflib nodes and back, without a change of spelling or of blank node labels."""

from __future__ import annotations

import logging
from collections.abc import Iterable
from functools import lru_cache

from rdflib import BNode, Graph, Literal, URIRef
from rdflib.term import Identifier, Node

from kinlint.terms import (
    Term,
    Triple,
    blank,
    iri,
    iri_value,
    is_blank,
    is_iri,
    literal,
    literal_value,
)

# That "0.3 m" is no xsd:double is for rules to say; rdflib would print a traceback.
logging.getLogger("rdflib.term").setLevel(logging.ERROR)


@lru_cache(maxsize=100_000)
def node(term: Term) -> Identifier:
    """Return the rdflib node of a token."""
    if is_iri(term):
        return URIRef(iri_value(term))
    if is_blank(term):
        return BNode(term[2:])
    tail = term[term.rindex('"') + 1 :]
    language = tail[1:] if tail.startswith("@") else None
    datatype = URIRef(tail[3:-1]) if tail.startswith("^^") else None
    # Without normalize=False rdflib would write 1.570 as 1.57.
    return Literal(literal_value(term), language, datatype, normalize=False)


def term(of: Node) -> Term:
    """Return the token of an rdflib node."""
    if isinstance(of, Literal):
        return literal(str(of), str(of.datatype or ""), of.language or "")
    return blank(str(of)) if isinstance(of, BNode) else iri(str(of))


def graph(triples: Iterable[Triple], store: str = "default") -> Graph:
    """Return a graph of *triples* that knows no prefix: none is then taken from it by mistake.

    The *store* "SimpleMemory" takes a third of the time and knows no named graphs, which pySHACL
    asks for.
    """
    made = Graph(store=store, bind_namespaces="none")
    for s, p, o in triples:
        made.store.add((node(s), node(p), node(o)), made)
    return made
