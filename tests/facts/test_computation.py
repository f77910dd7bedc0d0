"""Facts are those that are declared, so that a rule which asks for others can be told."""

from importlib import import_module
from pathlib import Path

import pytest
from computed import closed

from kinlint.engine.lifting import lift
from kinlint.facts.computation import computed, computed_by
from kinlint.facts.fact_context import FactContext
from kinlint.facts.fact_kinds import HINTS, KINDS
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import RDF_TYPE
from kinlint.vocabulary import FACT

SAMPLES = Path(__file__).parents[2] / "samples"
MODELS = (
    "urdf/six-axis.urdf",
    "sdf/six-axis.sdf",
    "broken/frame-graph-cycle.jsonld",
    "broken/inconsistent-representations.jsonld",
    "broken/dataflow-cycle.jsonld",
)


@pytest.fixture(scope="module", params=MODELS)
def context(request):
    """What computes the facts of a model."""
    file = SAMPLES / request.param
    store = closed({file.name: file.read_text()})
    lift(store)
    return FactContext(PredicateIndex(store))


def test_a_kind_computes_what_it_declares(context):
    """Properties and classes of facts, and no others."""
    for kind in (*KINDS, *HINTS):
        terms = {o if p == RDF_TYPE else p for _, p, o in kind.found(context)}
        names = {
            each.removeprefix(f"<{FACT}")[:-1] for each in terms if each.startswith(f"<{FACT}")
        }
        assert names <= {*kind.needs, *kind.details}, kind.module


def test_a_fact_has_a_module():
    """The one that computes it."""
    for name in computed(for_repairs=True):
        assert import_module(f"kinlint.facts.{computed_by(name, for_repairs=True)}")
    assert computed_by("least-moment") == "inertia"
    assert computed_by("free-name") is None
    assert computed_by("free-name", for_repairs=True) == "identifier_slips"
