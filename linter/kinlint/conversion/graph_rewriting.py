"""Rewriting of lifted models the way published models are written, by SPARQL Updates."""

from __future__ import annotations

from collections.abc import Iterator

import pyoxigraph as ox

from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.engine.math_functions import MATH
from kinlint.engine.store import Store, token
from kinlint.resources import data
from kinlint.terms import Triple
from kinlint.vocabulary import INTERMEDIATE, LIFTED_GRAPH

STEPS = (
    *(
        "free-bodies",
        "world-placements",
        "unlifted",
        "coordinates",
        "frames",
        "axes",
        "replacement",
    ),
    *("fixed-joints", "vectors", "limits", "scales"),
)
"""Updates of `shapes/conversion`, in their order."""


def rewritten(store: Store, rotation: str) -> Iterator[Triple]:
    """Yield what is lifted in *store*, rewritten, with rotations as *rotation* says.

    The default graph of *store*, which nothing else uses, takes the model.
    """
    store.oxigraph.update(f"COPY {LIFTED_GRAPH} TO DEFAULT")
    prefixes = {**model_prefixes(), "ir": INTERMEDIATE}
    for step in (*STEPS, f"rotations/{rotation}"):
        text = (data("shapes") / "conversion" / f"{step}.ru").read_text(encoding="utf-8")
        store.oxigraph.update(text, prefixes=prefixes, custom_functions={**MATH})
    for quad in store.oxigraph.quads_for_pattern(None, None, None, ox.DefaultGraph()):
        yield token(quad.subject), token(quad.predicate), token(quad.object)
