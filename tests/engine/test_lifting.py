"""What is known of lifting queries without running them, and what running them does."""

from __future__ import annotations

from pathlib import Path

import pytest
from support import linting
from turtle_document import document

from kinlint.document import Document
from kinlint.engine.lifting import EVERYWHERE, FOUNDATION, Lifting, asked, lift, queries
from kinlint.engine.store import Store
from kinlint.formats.records import BY_NAME, LIFTED
from kinlint.terms import RDF_TYPE, Term, Triple, iri, is_blank
from kinlint.vocabulary import KIN

SAMPLES = Path(__file__).parents[2] / "samples"
QUERIES = [query for form in LIFTED for query in queries(form.name)]
MODELS = ("urdf/gripper.urdf", "urdf/six-axis.srdf", "urdf/six-axis.urdf", "sdf/six-axis.sdf")


def model(*names: str) -> Store:
    store = Store()
    store.load(_read(name) for name in names)
    return store


def _read(name: str) -> Document:
    text = (SAMPLES / name).read_text()
    return linting.document(text, name)


def named(store: Store) -> set[Triple]:
    """What was lifted, but for the cells of lists, which nobody asks for by themselves."""
    return {
        (subject, predicate, "list" if is_blank(value) else value)
        for subject, predicate, value in store.lifted()
        if not is_blank(subject)
    }


@pytest.mark.parametrize("query", QUERIES, ids=lambda each: f"{each.format}-{each.name}")
def test_a_query_makes_what_it_is_said_to_make(query: Lifting) -> None:
    """No property and no class that nobody could ask it for."""
    store = model(*MODELS)
    store.oxigraph.update(query.update())
    made: set[Term] = {o if p == RDF_TYPE else p for _, p, o in named(store)}

    assert made <= query.makes | EVERYWHERE


def test_queries_are_asked_by_what_they_make() -> None:
    """What everything is about is always made; of formats that are not there nothing is."""

    def names(*wanted: Term) -> set[str]:
        return {each.name.rpartition("/")[2] for each in asked({BY_NAME["urdf"]}, wanted)}

    assert names(iri(f"{KIN}follower")) == FOUNDATION | {"couplings"}
    assert names() == FOUNDATION
    assert {each.format for each in asked({BY_NAME["xacro"], BY_NAME["jsonld"]})} == {"urdf"}
    assert list(asked({BY_NAME["jsonld"], BY_NAME["turtle"]})) == []


def test_lifting_again_changes_nothing() -> None:
    """It replaces what was lifted before, and with less asked for leaves less."""
    store = model("urdf/gripper.urdf")
    lift(store)
    first, size = named(store), len(list(store.lifted()))
    lift(store)

    assert (named(store), len(list(store.lifted()))) == (first, size)
    lift(store, ())
    assert named(store) < first


def test_models_of_one_run_are_lifted_apart() -> None:
    """What a file means does not depend on what stands beside it."""
    together = model(*MODELS)
    lift(together)
    apart: set[Triple] = set()
    for name in MODELS:
        store = model(name)
        lift(store)
        apart |= named(store)

    assert named(together) == apart


def test_nothing_is_lifted_of_what_is_written_as_it_is_meant() -> None:
    """Composable models are left as they are."""
    store = Store()
    store.load([document(":a :p :b .")])
    lift(store)

    assert list(store.lifted()) == []
