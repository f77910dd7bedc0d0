"""Fixes that undo or feed each other are recognised before anything is written."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from mending import OURS, book, outcome, repair

from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.fixes.fix_circles import circle_warning
from kinlint.fixes.texts import Texts
from kinlint.server.quick_fixes import safe_edits
from kinlint.text import SourceText

ARM = """<robot name="arm"><link name="base"/><link name="tip"/><link name="hand"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="tip"/>
    <limit lower="2.6" upper="1.5" effort="1" velocity="1"/></joint>
  <joint name="wrist" type="revolute"><parent link="tip"/><child link="hand"/>
    <limit lower="0.5" upper="1.5" effort="1" velocity="1"/></joint>
</robot>
"""
LOWER = 'lower="2.6"'


@pytest.fixture
def rules(tmp_path):
    """Rules as a test writes them."""
    return lambda *parts: book(tmp_path, *parts)


def written(attribute, test, new, where=""):
    """A rule that an *attribute* of limits passes unless *test*; its fix writes *new* there."""
    return {
        "target": "sh:targetObjectsOf urdf:limit",
        "select": f"""SELECT $this (at:{attribute} AS ?path) ?value
            {{ $this at:{attribute} ?value {where} FILTER ({test}) }}""",
        "repairs": [
            repair(
                f"DELETE {{ $this at:{attribute} ?value }} INSERT {{ $this at:{attribute} ?new }} "
                f"WHERE {{ $this at:{attribute} ?value {where} BIND ({new} AS ?new) }}",
                claim="unsafe",
            )
        ],
    }


INNOCENT = written("effort", "?value = 1", "2.0")
MODEL = """{
  "@context": "https://comp-rob2b.github.io/metamodels/geometry/structural-entities.json",
  "@graph": [ { "@id": "https://example.org/arm#a", "@type": "Frame" } ]
}
"""


def _successor(kind, other):
    """A rule that each node of a *kind* is the simplex of a new node of the *other* kind."""
    geom = "<https://comp-rob2b.github.io/metamodels/geometry/structural-entities#{}>".format
    return {
        "target": f"sh:targetClass {geom(kind)}",
        "select": f"""SELECT $this {{ $this a {geom(kind)}
            FILTER NOT EXISTS {{ ?next {geom("simplices")} $this }} }}""",
        "repairs": [
            repair(
                f"INSERT {{ ?next {geom('simplices')} $this ; a {geom(other)} }} WHERE {{ "
                "BIND (IRI(CONCAT(STR($this), 'x')) AS ?next) }",
                claim="unsafe",
            )
        ],
    }


CIRCLES = {
    "two undo each other": [
        written("lower", "?value > 2", "-1e0"),
        written("lower", "?value < 0", "3e0"),
    ],
    "two feed each other": [
        written("upper", "?low > 2 && ?value <= ?low", "?low + 1", "; at:lower ?low ."),
        written("lower", "?up > 2 && ?value < ?up", "?up", "; at:upper ?up ."),
    ],
    "three in a ring": [
        written("lower", "?value > 2 && ?value < 3", "3.5"),
        written("lower", "?value >= 3 && ?value < 4", "4.5"),
        written("lower", "?value >= 4", "2.6"),
    ],
    "three in a ring of places": [
        written("upper", "?v > 2 && ?value != ?v + 1", "?v + 1", "; at:lower ?v ."),
        written("velocity", "?v > 2 && ?value != ?v + 1", "?v + 1", "; at:upper ?v ."),
        written("lower", "?v > 2 && ?value != ?v + 1", "?v + 1", "; at:velocity ?v ."),
    ],
    "two grow a number": [
        written("lower", "?value > 2 && FLOOR(?value / 2) * 2 = FLOOR(?value)", "?value + 1"),
        written("lower", "?value > 2 && FLOOR(?value / 2) * 2 != FLOOR(?value)", "?value + 1"),
    ],
}


@pytest.mark.parametrize("name", CIRCLES)
def test_nothing_of_a_circle_is_written(rules, name):
    """And what others fix is, in the same element too; the rules of the circle are named."""
    parts = CIRCLES[name]
    made = outcome(rules(*parts, INNOCENT), ARM)

    assert made.texts[0].text == ARM.replace('effort="1"', 'effort="2"')
    assert made.restless == [f"TST{number:03}" for number in range(1, len(parts) + 1)]
    assert {one.rule.code for one in made.report.fixed} == {f"TST{len(parts) + 1:03}"}
    reasons = {why for _, _, why in made.report.unfixed}
    assert reasons == {"it and other fixes undo or feed each other"}


def test_a_rule_of_a_circle_fixes_what_is_not_in_it(rules):
    """The second rule finds something in the first joint only."""
    odds = rules(
        written("lower", "?value > 2 || ?value = 0.5", "?value - 4"),
        written("lower", "?value < -1 && ?value > -2", "?value + 4"),
    )
    made = outcome(odds, ARM)

    assert made.restless == ["TST001", "TST002"]
    assert made.texts[0].text == ARM.replace('"0.5"', '"-3.5"')


def test_a_fix_that_leaves_its_own_finding_is_none(rules):
    """So a rule alone makes no circle in one place."""
    made = outcome(rules(written("lower", "?value > 2", "?value + 1")), ARM)

    assert (made.restless, made.changed) == ([], [])


def test_new_nodes_without_end(rules):
    """Each turn writes what was not there before, by two rules."""
    growing = rules(
        *(_successor(kind, other) for kind, other in (("Frame", "Point"), ("Point", "Frame")))
    )
    made = outcome(growing, MODEL, "arm.jsonld")

    assert (made.restless, made.changed) == (["TST001", "TST002"], [])


def test_fixes_that_come_to_an_end_are_at_odds_with_nothing(rules):
    """One fix, and one that follows from it."""
    following = rules(
        written("lower", "?value > 2", "0.75"),
        written("lower", "?value = 0.75", "0.25"),
    )
    made = outcome(following, ARM)

    assert (made.restless, len(made.report.fixed)) == ([], 2)
    assert made.texts[0].text == ARM.replace(LOWER, 'lower="0.25"')


def test_the_editor_makes_nothing_of_a_circle(rules):
    """Where the settings call the fixes safe."""
    known = rules(
        written("lower", "?value > 2", "-1e0"),
        written("lower", "?value < 0", "3e0"),
        written("effort", "?value = 1", "2.0"),
    )
    source = SourceText("arm.urdf", ARM)
    session = SimpleNamespace(texts=Texts([source]), model=SimpleNamespace(errors=()))
    settings = Settings(default=FileSettings(choices=(Choice(extend_safe_fixes=("ALL",)),)))
    view = SimpleNamespace(
        source=source, session=session, settings=settings, rulebook=known, cancelled=lambda: False
    )

    edits, codes = safe_edits(view)

    assert codes == ["TST001", "TST002"]
    assert all('effort="2"' in edit.text for edit in edits)
    assert [edit.text.count(LOWER) for edit in edits] == [1, 0]


GRIPPER = """<robot name="gripper">
  <link name="palm"/><link name="left_finger"/><link name="right_finger"/>
  <joint name="left_finger_joint" type="prismatic">
    <parent link="palm"/><child link="left_finger"/>
    <origin xyz="0 0.02 0.1"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.0425" effort="20" velocity="0.1"/>
  </joint>
  <joint name="right_finger_joint" type="prismatic">
    <parent link="palm"/><child link="right_finger"/>
    <origin xyz="0 -0.02 0.1"/><axis xyz="0 -1 0"/>
    <limit lower="0" upper="0.0425" effort="20" velocity="0.1"/>
    <mimic joint="left_finger_joint" multiplier="2"/>
  </joint>
</robot>
"""


def test_a_gripper_keeps_its_stroke():
    """The follower would be widened, the twin made equal, and so on."""
    made = outcome(OURS, GRIPPER, "gripper.urdf")

    assert made.restless == ["INE007", "LIM011"]
    assert made.texts[0].text == GRIPPER


def test_one_line_names_the_rules():
    """In the words of a list."""
    assert circle_warning(["A"]) == "fixes of A lead to more of it without end; they were not made"
    assert circle_warning(["A", "B", "C"]) == (
        "fixes of A, B and C undo or feed each other; they were not made"
    )
