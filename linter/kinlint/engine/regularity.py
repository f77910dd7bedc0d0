"""Refuses property chains that could generate without end."""

from __future__ import annotations

from kinlint.engine.axioms import name
from kinlint.engine.ontology_index import INVERSE, Schema
from kinlint.engine.strata import components
from kinlint.errors import RuleInvalid
from kinlint.terms import Term
from kinlint.vocabulary import OWL, RDFS


def check_regular(schema: Schema) -> None:
    """Raise `RuleInvalid` for a chain that breaks OWL 2's property hierarchy.

    There must be an order of properties, blind to inverses, in which those of a chain come
    before what the chain makes, unless that one stands at one end of it or the chain says that
    it is transitive (OWL 2 Structural Specification 11.2). A closure over a finite graph ends
    without the order too, but chains that feed themselves from the inside infer quadratically
    many triples that nobody meant.
    """
    edges: dict[Term, list[Term]] = {}
    strict: list[tuple[Term, Term]] = []
    for keyword in (f"<{RDFS}subPropertyOf>", f"<{OWL}equivalentProperty>", INVERSE):
        for one, other in schema.pairs(keyword):
            part, whole = _plain(schema, one), _plain(schema, other)
            edges.setdefault(part, []).append(whole)
            if not keyword.endswith("subPropertyOf>"):
                edges.setdefault(whole, []).append(part)
    for whole, items in schema.pairs(f"<{OWL}propertyChainAxiom>"):
        for part in _inner(schema.list(items), whole):
            strict.append((_plain(schema, part), whole))
            edges.setdefault(_plain(schema, part), []).append(whole)

    home = {node: found for found in components(edges) for node in found}
    for part, whole in strict:
        if home[part] is home[whole]:
            raise RuleInvalid(
                f"The property chain that makes {name(whole)} uses {name(part)}, "
                f"which itself depends on {name(whole)}."
            )


def _inner(chain: tuple[Term, ...], whole: Term) -> tuple[Term, ...]:
    """Return the members of *chain* that must come before *whole*."""
    if chain == (whole, whole):
        return ()
    if chain[:1] == (whole,):
        return chain[1:]
    return chain[:-1] if chain[-1:] == (whole,) else chain


def _plain(schema: Schema, relation: Term) -> Term:
    """Return *relation*, or what it is the anonymous inverse of."""
    if relation.startswith("_:"):
        return next(iter(schema.objects(relation, INVERSE)), relation)
    return relation
