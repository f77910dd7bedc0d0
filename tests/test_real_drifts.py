"""Differences between public descriptions of one robot, each of which was looked at."""

from __future__ import annotations

import pytest
from data import locate_data
from real_drifts import PAIRS, difference, page

from kinlint.resources import data

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("public robots")]


def test_the_page_is_fresh() -> None:
    """If not: `python tests/real_drifts.py > rules/real-drifts.md`, and look at what changed."""
    locate_data("robots")
    kept = (data("rules") / "real-drifts.md").read_text("utf-8")

    assert kept.splitlines() == list(page())


def test_joints_that_correspond_are_most_of_them() -> None:
    """A pair that is matched badly has few in common, or differences in everything."""
    locate_data("robots")
    for old, new in PAIRS:
        joints = difference(old, new)["joints"]
        assert joints["common"] >= 2 / 3 * min(joints["old"], joints["new"]), (old, new)
