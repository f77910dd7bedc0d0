"""Defects of stages are found where they are; stages without are clean."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data
from support.defect_tables import found, rows

TABLE = Path(__file__).with_name("usd_defects.tsv")
"""What is found in each stage with one defect: a line and a code, or why nothing is."""
WITH_ERRORS = {"usdPhysicsDistanceJoint.usda"}
"""Public examples with an error: one with a type that no schema has."""


@pytest.mark.corpus
@pytest.mark.parametrize("row", rows(TABLE), ids=lambda row: row[0])
def test_a_defect_is_found_at_its_line(row: list[str]) -> None:
    file, line, code, reason = row
    places = found(locate_data("defects", "usd") / file)
    if line == "-":
        assert reason
        assert not [each for each in places if each[2] != "info"]
        return
    assert (int(line), code) in {each[:2] for each in places}


@pytest.mark.corpus
def test_the_table_has_each_defect() -> None:
    folder = locate_data("defects", "usd")
    names = {path.name for path in folder.glob("*.usda") if not path.name.startswith("clean")}
    assert {row[0] for row in rows(TABLE)} == names


@pytest.mark.corpus
def test_stages_without_defects_are_clean() -> None:
    clean = sorted(locate_data("defects", "usd").glob("clean*.usda"))
    assert clean
    assert {path.name: found(path) for path in clean if found(path)} == {}


@pytest.mark.corpus
def test_public_examples_have_the_errors_that_were_looked_at() -> None:
    examples = sorted(locate_data("robots", "usd").rglob("examples/*.usda"))
    assert examples
    errors = {path.name for path in examples if any(e[2] == "error" for e in found(path))}
    assert errors == WITH_ERRORS
