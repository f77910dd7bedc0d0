"""What is found in public robots: few errors, each of them looked at, and each thing told once.

`urdf_verdicts.tsv` has the URDF files with errors, the codes of these, and what is wrong.
"""

from __future__ import annotations

import csv
from collections import Counter, defaultdict
from pathlib import Path

import pytest
from data import locate_data
from real_robots import files, findings, is_robot, page, short, warnings, with_error

from kinlint.resources import data
from kinlint.rule import Severity

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("public robots")]

TABLE = Path(__file__).with_name("urdf_verdicts.tsv")


def test_the_section_of_the_readme_is_fresh() -> None:
    """If not: `python tests/real_robots.py > rules/real-robots.md`, and look at what changed."""
    locate_data("robots")
    kept = (data("rules") / "real-robots.md").read_text("utf-8")

    assert kept.splitlines() == list(page())


def test_few_robots_have_an_error() -> None:
    """Hardly more even with files that are input of tests, which are often wrong on purpose."""
    every = files("urdf")
    robots = {name for name in every if is_robot(name)}

    assert len(robots) > 250
    assert len(with_error("urdf")) <= 0.22 * len(every)
    assert len(with_error("urdf") & robots) <= len(robots) / 7


def test_the_median_robot_has_one_warning_at_most() -> None:
    assert warnings("urdf") <= 1


def test_each_error_was_looked_at() -> None:
    """The table says of each why it is true; no file stands there without."""
    locate_data("robots")
    with TABLE.open(encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text, delimiter="\t"))
    errors: dict[str, set[str]] = defaultdict(set)
    for each in findings("urdf"):
        if each.severity is Severity.ERROR:
            errors[short(each.location.source.name).removeprefix("urdf/")].add(each.rule.code)

    assert {row["file"]: set(row["found"].split()) for row in rows} == errors
    assert all(row["why"] for row in rows)


def test_what_is_grouped_is_told_once_in_a_file() -> None:
    """A package, a convention or a pattern is one finding, with its places."""
    grouped = [each for each in findings("urdf") if each.rule.group_by]
    told = Counter((each.location.source.name, each.rule.code, each.group) for each in grouped)

    assert sum(len(each.related) for each in grouped) > 3000
    assert set(told.values()) == {1}
