from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from data import locate_data
from support.linting import book

from kinlint import resources
from kinlint.configuration.settings import Settings
from kinlint.contexts.context_library import RELEASES, Contexts
from kinlint.document import Document
from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.evaluate import check
from kinlint.engine.lifting import lift
from kinlint.engine.literal_spelling import normal
from kinlint.engine.ontology import compile_axioms
from kinlint.engine.reference.owl import owlrl_closure
from kinlint.engine.reference.shacl import check_store
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read as read_any
from kinlint.text import SourceText

pytestmark = pytest.mark.oracle

CHECKOUT = Path(__file__).parents[2]
SHAPES = resources.data("shapes")
ONTOLOGY = sorted((SHAPES / "ontology").glob("*.ttl"))
UNITS = sorted((SHAPES / "units").glob("*.ttl"))

BROKEN = sorted((CHECKOUT / "samples" / "broken").glob("*.jsonld"))
MODELS = {
    **{
        folder.name: sorted(folder.rglob("*.jsonld"))
        for folder in sorted((CHECKOUT / "samples").iterdir())
        if folder.name not in ("broken", "vendor") and any(folder.rglob("*.jsonld"))
    },
    **{f"broken/{file.stem}": [file] for file in BROKEN[::4]},
}
PUBLISHED = {
    "tutorial": ("comp-rob2b", "modelling-tutorial", "models"),
    "Kinova Gen3": ("comp-rob2b", "robot-models"),
}


@cache
def axioms(vocabulary: tuple[Path, ...]) -> tuple[Axiom, ...]:
    return tuple(compile_axioms(vocabulary))


def documents(files: list[Path]) -> list[Document]:
    options = ReadOptions(Contexts.bundled(), RELEASES)
    return [read(SourceText(str(file), file.read_text("utf-8-sig")), options) for file in files]


def closed(model: list[Document], vocabulary: list[Path]) -> Store:
    store = Store()
    assert store.load(model) == ()
    store.load_vocabulary(vocabulary)
    lift(store)
    close(store, axioms(tuple(vocabulary)))
    store.state(facts(store))
    return store


def model_of(name: str) -> list[Document]:
    if name in MODELS:
        return documents(MODELS[name])
    return documents(sorted(locate_data(*PUBLISHED[name]).rglob("*.json")))


@pytest.mark.parametrize("name", [*MODELS, *PUBLISHED])
def test_the_closure_of_a_sample_is_that_of_owlrl(name):
    """The compiled axioms and the oracle infer the same about every model we have."""
    model = model_of(name)
    stated = [triple for document in model for triple in document.statements]

    assert set(closed(model, ONTOLOGY).inferred()) == owlrl_closure(stated, ONTOLOGY)


def reported(results: list[Result]) -> Counter[tuple[object, ...]]:
    """What matters of *results*: where, by which constraint, and what its message names."""
    return Counter(
        (
            each.constraint,
            each.focus,
            each.path,
            each.value and normal(each.value),
            *(
                normal(term)
                for name, term in sorted(each.bindings.items())
                if any(f"{sign}{name}}}" in m for m in each.constraint.messages for sign in "?$")
            ),
        )
        for each in results
    )


@pytest.mark.parametrize("name", ["one-dof", "orientations", *PUBLISHED])
def test_both_engines_find_the_same_in_a_sample(name):
    """pySHACL, which takes up to a minute for others, is the judge of the compiled catalogue.

    On what is broken they are compared by the examples of each rule, and by mutants.
    """
    store = closed(model_of(name), [*ONTOLOGY, *UNITS])

    rules = book()
    found = reported(list(check(store, rules.constraints)))

    assert found == reported(check_store(store, rules.shapes, rules.constraints))


LIFTED = ("urdf/gripper.urdf", "urdf/six-axis.srdf", "broken/automatic-inertia-of-nothing.sdf")


def lifted(name: str) -> Store:
    """A sample in an XML format with all that it means."""
    text = (CHECKOUT / "samples" / name).read_text()
    return closed(
        [read_any(SourceText(name, text), ReadOptions.from_settings(Settings()))], ONTOLOGY
    )


@pytest.mark.parametrize("name", LIFTED)
def test_the_closure_of_what_is_lifted_is_that_of_owlrl(name):
    """What is lifted is closed as what is written in JSON-LD."""
    store = lifted(name)
    stated = [triple for document in store.documents.values() for triple in document.statements]

    assert set(store.inferred()) == owlrl_closure([*stated, *store.lifted()], ONTOLOGY)


@pytest.mark.parametrize("name", LIFTED)
def test_both_engines_find_the_same_in_what_is_lifted(name):
    """The whole catalogue, rules of other formats included, on models that came from XML."""
    store = lifted(name)

    rules = book()
    found = reported(list(check(store, rules.constraints)))

    assert found == reported(check_store(store, rules.shapes, rules.constraints))
