"""The table of facts in shapes/README.md has every fact that is computed, and no other."""

from __future__ import annotations

import re

import pytest

from kinlint import resources
from kinlint.facts.computation import computed

ROW = re.compile(r"\| (?P<on>.*?) \| (?P<facts>.*) \|")
NAME = re.compile(r"`(?:fact:)?([A-Za-z][A-Za-z-]*)`")


def rows() -> list[tuple[str, str]]:
    """The cells of the table."""
    text = (resources.data("shapes") / "README.md").read_text("utf-8")
    facts = text.partition("\n### Facts\n")[2].partition("\n#")[0]
    found = [row.group("on", "facts") for line in facts.splitlines() if (row := ROW.match(line))]
    return found[1:]


def test_each_fact_is_in_the_table_and_no_other():
    """By its name; classes of fact nodes stand in the first column."""
    named = {name for _, facts in rows() for name in NAME.findall(facts)}
    classes = {name for on, _ in rows() for name in NAME.findall(on) if name[0].isupper()}
    assert (named | classes) - {"derived-from"} == computed(for_repairs=True) - {"derived-from"}


@pytest.mark.parametrize("name", sorted(computed(for_repairs=True) - computed()))
def test_what_only_repairs_may_ask_for_is_said_to_be_for_them(name):
    """Rules that ask for it would find nothing."""
    told = [on for on, facts in rows() if name in NAME.findall(facts)]
    assert any("for repairs" in on for on in told)
