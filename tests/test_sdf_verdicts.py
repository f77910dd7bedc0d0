"""Files that sdformat keeps because something is wrong with them are flagged, the others are not.

`sdf_verdicts.tsv` has the path of each file that is flagged, below the data, the codes of what is
found, and why. Every other file has no error.
"""

from __future__ import annotations

import csv
from collections import defaultdict
from functools import cache
from pathlib import Path

import pytest
from data import locate_data
from real_robots import report

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("public robots")]

TABLE = Path(__file__).with_name("sdf_verdicts.tsv")
WRONG = ("bad_", "invalid", "duplicate_sibling", "missing", "without", "_error", "noname")
"""What the names of broken files have in them."""
SOUND = (
    "model_without_top_level/model.sdf",  # an empty file is a file without a robot
    "sdformat/test/sdf/empty.sdf",
)


def expected() -> dict[str, set[str]]:
    with TABLE.open(encoding="utf-8", newline="") as text:
        return {
            row["file"]: set(row["found"].split()) for row in csv.DictReader(text, delimiter="\t")
        }


@cache
def found() -> tuple[dict[str, set[str]], dict[str, set[str]]]:
    """The codes of all that is found in each file, and of the errors."""
    root = locate_data("robots", "sdf")
    linted = report("sdf")
    assert linted.errors == ()
    every: dict[str, set[str]] = defaultdict(set)
    errors: dict[str, set[str]] = defaultdict(set)
    for finding in linted.findings:
        name = Path(finding.location.source.name).relative_to(root).as_posix()
        every[name].add(finding.rule.code)
        if finding.severity.label == "error":
            errors[name].add(finding.rule.code)
    return every, errors


@pytest.mark.parametrize("name", sorted(expected()))
def test_what_is_wrong_with_a_file_is_found(name: str) -> None:
    every, _ = found()
    assert expected()[name] <= every[name]


def test_nothing_else_is_an_error() -> None:
    _, errors = found()
    assert {name: codes for name, codes in errors.items() if not codes <= expected()[name]} == {}


def test_files_that_are_broken_by_their_name_are_in_the_table() -> None:
    root = locate_data("robots", "sdf", "sdformat", "test")
    names = [path.relative_to(root.parents[1]).as_posix() for path in root.rglob("*.sdf")]
    broken = [
        name for name in names if any(word in name for word in WRONG) and not name.endswith(SOUND)
    ]
    assert len(broken) > 40
    assert set(broken) - set(expected()) == set()
