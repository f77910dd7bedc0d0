"""Where a finding is, and how severe, does not depend on what else is selected."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

import pytest
from support.linting import book, lint
from test_samples import BROKEN, COMPANION, GOOD, files

from kinlint.configuration.settings import Choice, FileSettings
from kinlint.finding import Finding
from kinlint.formats.registry import decode
from kinlint.text import SourceText

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("selection")]

OF_NO_OTHER_RULE = "POR018"
"""The rule about what targets make of a feature that no rule selected reports as a defect."""
TARGETS = ("drake", "gazebo", "mujoco", "pinocchio")
BOXES = """<robot name="r">
  <link name="a">
    <inertial>
      <origin xyz="0 1 2" rpy="0 0 1"/>
      <mass value="1"/>
      <inertia ixx="0" ixy="0" ixz="0" iyy="1" iyz="0" izz="2"/>
    </inertial>
    <visual>
      <origin rpy="0 1 2" xyz="3 4 5"/>
      <geometry><box size="0 7 8"/></geometry>
      <material name="grey"><color rgba="0 1 2 3"/></material>
    </visual>
    <collision>
      <origin rpy="0 1.57 0" xyz="0 0 0"/>
      <geometry><box size="1 -2 0"/></geometry>
    </collision>
  </link>
  <link name="b"/>
  <joint name="j" type="revolute">
    <origin xyz="1 0 0" rpy="1.57 0 1.57"/>
    <parent link="a"/>
    <child link="b"/>
    <axis xyz="0 0 2"/>
    <limit lower="2" upper="1" effort="-1" velocity="-1"/>
    <dynamics damping="-1" friction="-1"/>
  </joint>
</robot>
"""
"""Equal numbers in all places where one may be mistaken for another."""


def _found(sources: Iterable[SourceText], *selected: str) -> Mapping[str, list[tuple[object, ...]]]:
    """Return what is said and where, by code, if the rules of *selected* are."""
    settings = FileSettings((Choice(select=selected),), targets=TARGETS)
    by_code: dict[str, list[tuple[object, ...]]] = defaultdict(list)
    for finding in lint(list(sources), default=settings).findings:
        by_code[finding.rule.code].append(_told(finding))
    return by_code


def _told(finding: Finding) -> tuple[object, ...]:
    return finding.location.source.name, finding.location.span, finding.severity


def _sources(*paths: Path) -> list[SourceText]:
    return [decode(str(path), path.read_bytes()) for path in paths]


@pytest.fixture(scope="module")
def among_all() -> Mapping[str, list[tuple[object, ...]]]:
    """What is found in the boxes if all rules are selected."""
    return _found([SourceText("boxes.urdf", BOXES)], "ALL")


@pytest.mark.parametrize("code", sorted(rule.code for rule in book().rules))
def test_every_rule_says_alone_what_it_says_among_all(
    code: str, among_all: Mapping[str, list[tuple[object, ...]]]
) -> None:
    """Equal numbers nearby lead no rule astray."""
    alone, together = _found([SourceText("boxes.urdf", BOXES)], code)[code], among_all.get(code, [])

    assert {*together} <= {*alone} if code == OF_NO_OTHER_RULE else together == alone


def test_features_that_are_told_alone_are_told_among_all() -> None:
    """By the rule that reports them as defects of their own, if not by the one about targets."""

    def features(selected: str) -> set[str]:
        settings = FileSettings((Choice(select=(selected,)),), targets=TARGETS)
        report = lint([SourceText("boxes.urdf", BOXES)], default=settings)
        return {each.feature for each in report.findings if each.departures}

    assert features(OF_NO_OTHER_RULE)
    assert features(OF_NO_OTHER_RULE) <= features("ALL")


@pytest.mark.parametrize("path", BROKEN, ids=lambda path: path.name)
def test_what_is_found_in_broken_samples_is_found_alone(path: Path) -> None:
    """Selecting one of the rules that speak moves nothing.

    Alone, it may tell more: what follows from a finding of another rule is counted there.
    """
    sources = _sources(path, *([COMPANION] if path.suffix == ".srdf" else []))
    together = _found(sources, "ALL")

    for code, told in together.items():
        assert set(told) <= set(_found(sources, code)[code])


@pytest.mark.parametrize("name", GOOD)
def test_what_is_found_in_good_samples_is_found_alone(name: str) -> None:
    """What good samples have are matters of taste, which are off unless selected."""
    sources = _sources(*files(name))
    together = _found(sources, "ALL")

    for code, told in together.items():
        assert set(told) <= set(_found(sources, code)[code])
