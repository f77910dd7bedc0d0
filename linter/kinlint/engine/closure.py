"""Materialises what axioms conclude: SPARQL updates, stratum by stratum, to a fixpoint."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby

import pyoxigraph as ox

from kinlint.engine.axioms import Axiom, insertion, unify
from kinlint.engine.store import Store
from kinlint.terms import Term, iri_value
from kinlint.vocabulary import INFERRED_GRAPH, KINLINT

FRESH: Term = f"<{KINLINT}inferred/fresh>"
NEXT: Term = f"<{KINLINT}inferred/next>"


def close(store: Store, axioms: Sequence[Axiom]) -> int:
    """Infer all that follows by *axioms* from what *store* holds; return how many triples.

    They go to the inferred graph, whose former content is dropped. A triple that a document or
    the vocabulary states is never inferred.
    """
    store.oxigraph.clear_graph(ox.NamedNode(iri_value(INFERRED_GRAPH)))
    before = len(store.oxigraph)
    for (_, recursive), group in groupby(axioms, key=_round):
        if recursive:
            _iterate(store, list(group))
        else:
            _run(store, (axiom.update for axiom in group))
    return len(store.oxigraph) - before


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
