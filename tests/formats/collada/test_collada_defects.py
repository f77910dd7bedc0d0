"""Defects of COLLADA are found where they are; robots without are clean, and so are public ones."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data
from support.defect_tables import found, rows

TABLE = Path(__file__).with_name("collada_defects.tsv")
"""What is found in each robot with one defect: a line and a code, or why it is not there."""
TRUE_ERRORS = {
    "FRM008": ("test.dae",),
    "ID007": ("puma.dae",),
    "INE001": ("pumaarm.dae",),
    "SRC001": ("test.dae", "simpleArm.dae"),
    "TOP002": ("simple.dae",),
    "TOP023": ("fail4.dae", "fail5_4d.dae", "testik0.dae", "puma.dae", "simple.dae"),
}
"""The public robots with errors, each of which has been looked at, by code."""


@pytest.mark.corpus
@pytest.mark.parametrize("row", rows(TABLE), ids=lambda row: row[0])
def test_a_defect_is_found_at_its_line(row: list[str]) -> None:
    file, line, code, _remark = row
    places = found(locate_data("defects", "collada") / file)
    assert (int(line), code) in {each[:2] for each in places}


@pytest.mark.corpus
def test_the_table_has_each_defect() -> None:
    folder = locate_data("defects", "collada")
    defects = {path.name for path in folder.glob("*.dae") if not path.name.startswith("clean")}
    assert {row[0] for row in rows(TABLE)} == defects


@pytest.mark.corpus
def test_robots_without_defects_are_clean() -> None:
    clean = sorted(locate_data("defects", "collada").glob("clean*.dae"))
    assert clean
    assert {path.name: found(path) for path in clean if found(path)} == {}


@pytest.mark.corpus
def test_errors_in_public_robots_have_been_looked_at() -> None:
    robots = sorted(locate_data("robots", "collada").rglob("*.dae"))
    assert robots
    errors: dict[str, set[str]] = {}
    for path in robots:
        for _, code, severity in found(path):
            if severity == "error":
                errors.setdefault(code, set()).add(path.name)
    assert errors == {code: {*names} for code, names in TRUE_ERRORS.items()}
