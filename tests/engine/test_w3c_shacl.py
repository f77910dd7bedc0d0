"""Both engines do on the W3C SHACL suite what the record beside this file says."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

import pytest
from data import locate_data
from w3c import Case, cases

from kinlint.document import Document, SourceMap
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.evaluate import check
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.formats.turtle.format import TURTLE
from kinlint.text import SourceText

RECORD = json.loads((Path(__file__).parent / "w3c_shacl.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def suite() -> dict[str, Case]:
    return {case.name: case for case in cases(locate_data("w3c", "shacl-tests"))}


def loaded(case: Case) -> Store:
    store = Store()
    source = SourceText(case.name, "")
    store.load([Document(source, "<urn:data>", case.data, SourceMap(), format=TURTLE)])
    return store


def default_results(case: Case) -> list[Result]:
    """The results of the default engine, which leaves what it defers to pySHACL."""
    store, constraints = loaded(case), compile_shapes([case.shapes])
    results = list(check(store, constraints))
    if any(each.deferred for each in constraints):
        from kinlint.engine.reference.shacl import check_deferred  # noqa: PLC0415

        results += check_deferred(store, [case.shapes], constraints)
    return results


def reference_results(case: Case) -> list[Result]:
    from kinlint.engine.reference.shacl import check_store  # noqa: PLC0415

    return check_store(loaded(case), [case.shapes])


def passes(case: Case, results: Iterable[Result]) -> bool:
    found = list(results)
    messages = {message for each in found for message in each.constraint.messages}
    return not case.fails and case.reported(found) == case.expected and case.messages <= messages


@pytest.mark.parametrize("engine", [default_results, reference_results])
@pytest.mark.parametrize("name", RECORD["tests"])
def test_engine_does_what_the_record_says(engine, name: str, suite: dict[str, Case]) -> None:
    """Passes, unless the record has a reason; a reason must not outlive its cause."""
    failing = RECORD["kinlint" if engine is default_results else "pyshacl"]["fails"]
    case = suite[name]
    try:
        outcome = passes(case, engine(case))
    except RuleInvalid:
        outcome = case.fails
    assert outcome == (name not in failing)


def test_record_names_every_test_of_the_suite(suite: dict[str, Case]) -> None:
    """And no other."""
    assert RECORD["tests"] == sorted(suite)
    for engine in ("kinlint", "pyshacl"):
        assert set(RECORD[engine]["fails"]) <= set(suite)


@pytest.mark.slow
def test_only_recorded_constraints_are_deferred(suite: dict[str, Case]) -> None:
    """Every other constraint of the suite runs as one SELECT on Oxigraph."""
    deferred = {}
    for name, case in suite.items():
        if not case.fails:
            reasons = {each.deferred for each in compile_shapes([case.shapes])} - {None}
            deferred |= {name: " ".join(sorted(filter(None, reasons)))} if reasons else {}
    assert deferred == RECORD["kinlint"]["deferred"]
