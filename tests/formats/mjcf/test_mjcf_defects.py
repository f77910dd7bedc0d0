"""Defects that MuJoCo rejects or passes over are found where they are; robots without are clean."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from data import locate_data
from support.defect_tables import found, rows

TABLE = Path(__file__).with_name("mjcf_defects.tsv")
"""What is found in each robot with one defect: a line and a code, or why nothing is.

A code with a reason is that of a rule that is off unless it is selected.
"""
MOST_WITH_ERRORS = 0.15
"""The share of public models that may have errors, each of which has been looked at."""


@pytest.mark.corpus
@pytest.mark.parametrize("row", rows(TABLE), ids=lambda row: row[0])
def test_a_defect_is_found_at_its_line(row: list[str]) -> None:
    file, line, code, reason = row
    selected = (code,) if reason and code != "-" else ()
    places = found(locate_data("defects", "mjcf") / file, selected)
    if line == "-":
        assert reason
        assert not [each for each in places if each[2] != "info"]
        return
    assert (int(line), code) in {each[:2] for each in places}


@pytest.mark.corpus
def test_the_table_has_each_defect() -> None:
    folder = locate_data("defects", "mjcf")
    assert {row[0] for row in rows(TABLE)} == {path.name for path in folder.glob("*.xml")}


@pytest.mark.corpus
def test_robots_without_defects_are_clean() -> None:
    clean = sorted((locate_data("defects", "mjcf") / "clean").glob("*.xml"))
    assert clean
    assert {path.name: found(path) for path in clean if found(path)} == {}


@pytest.mark.corpus
def test_few_public_models_have_errors() -> None:
    models = sorted(locate_data("robots", "mjcf").rglob("*.xml"))
    errors = [path for path in models if any(each[2] == "error" for each in found(path))]
    assert len(errors) <= MOST_WITH_ERRORS * len(models)
    assert not [path for path in models if re.search("SRC019", str(found(path)))]
