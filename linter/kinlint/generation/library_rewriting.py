"""Rewriting of a model the way a library needs it, by SPARQL Updates."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import pyoxigraph as ox

from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.engine.math_functions import MATH
from kinlint.engine.store import Store, statement, token
from kinlint.resources import data
from kinlint.terms import Triple
from kinlint.vocabulary import GENERATION

SHARED = "shared"


def updates(library: str) -> Sequence[Path]:
    """Return the updates for *library*, in their order: those for all libraries come first."""
    home = data("shapes") / "generation"
    return [path for name in (SHARED, library) for path in sorted((home / name).glob("*.ru"))]


def rewritten(model: Store, numbers: Iterable[Triple], library: str) -> Sequence[Triple]:
    """Return the statements that a program for *library* is made of, sorted.

    *model* is closed; *numbers* are `ModelStatements` of it.
    """
    store = ox.Store()
    store.bulk_extend(ox.Quad(each.subject, each.predicate, each.object) for each in model.oxigraph)
    store.extend(map(statement, numbers))
    prefixes = {**model_prefixes(), "gen": GENERATION}
    for path in updates(library):
        text = path.read_text(encoding="utf-8")
        store.update(text, prefixes=prefixes, custom_functions={**MATH})
    return sorted(
        (token(each.subject), token(each.predicate), token(each.object))
        for each in store
        if each.predicate.value.startswith(GENERATION)
    )
