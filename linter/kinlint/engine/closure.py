"""Materialises what axioms conclude: SPARQL updates, stratum by stratum, to a fixpoint."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.axioms import Axiom, Pattern, insertion, is_variable, unify
from kinlint.engine.pruning import Presence
from kinlint.engine.store import Store
from kinlint.terms import RDF_TYPE, Term, iri_value
from kinlint.vocabulary import INFERRED_GRAPH, KINLINT

FRESH: Term = f"<{KINLINT}inferred/fresh>"
NEXT: Term = f"<{KINLINT}inferred/next>"

Key: TypeAlias = tuple[Term, Term | None]
"""A property, and the class where it says that something is of one."""


def close(store: Store, axioms: Sequence[Axiom]) -> None:
    """Infer all that follows by *axioms* from what *store* holds.

    It goes to the inferred graph, whose former content is dropped. A triple that a document or
    the vocabulary states is never inferred.
    """
    store.oxigraph.clear_graph(ox.NamedNode(iri_value(INFERRED_GRAPH)))
    for (_, recursive), group in groupby(_feasible(axioms, Presence(store)), key=_round):
        if recursive:
            _iterate(store, list(group))
        else:
            _run(store, (axiom.update for axiom in group))


def _feasible(axioms: Sequence[Axiom], presence: Presence) -> Iterator[Axiom]:
    """Yield those of *axioms* whose premises all match something stated, or concluded by others."""
    coming: set[Key] = set()
    chosen: set[int] = set()
    grew = True
    while grew:
        found = {
            index
            for index, axiom in enumerate(axioms)
            if index not in chosen
            and all(
                (key := _key(pattern)) in coming or presence.matches(*key) for pattern in axiom.body
            )
        }
        chosen |= found
        grew = bool(found)
        coming.update(_key(axioms[index].head) for index in found)
    return (axiom for index, axiom in enumerate(axioms) if index in chosen)


def _key(pattern: Pattern) -> Key:
    """Return the property, or the class, that a triple must have to match *pattern*."""
    _, predicate, value = pattern
    return predicate, value if predicate == RDF_TYPE and not is_variable(value) else None


def _round(axiom: Axiom) -> tuple[int, bool]:
    return axiom.stratum, axiom.recursive


def _run(store: Store, updates: Iterable[str]) -> None:
    store.oxigraph.update(" ;\n".join(updates))


def _iterate(store: Store, axioms: Sequence[Axiom]) -> None:
    """Run axioms that feed each other, after the first round on what the last one added."""
    fresh, following = FRESH, NEXT
    _run(store, (insertion(axiom, fresh) for axiom in axioms))
    while _any(store, fresh):
        _run(
            store,
            [
                f"ADD {fresh} TO {INFERRED_GRAPH}",
                *(
                    insertion(axiom, following, (index, fresh))
                    for axiom in axioms
                    for index, pattern in enumerate(axiom.body)
                    if any(unify(each.head, pattern) for each in axioms)
                ),
                f"DROP GRAPH {fresh}",
            ],
        )
        fresh, following = following, fresh


def _any(store: Store, graph: Term) -> bool:
    node = ox.NamedNode(iri_value(graph))
    return any(store.oxigraph.quads_for_pattern(None, None, None, node))
