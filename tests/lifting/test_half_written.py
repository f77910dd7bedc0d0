"""Robots that somebody is still writing: a joint without a type or an end keeps its findings."""

from __future__ import annotations

import pytest
from support.linting import lint

from kinlint.rule import Severity

URDF = {
    '<joint name="j"><parent link="a"/><child link="b"/></joint>': ["SRC011"],
    '<joint name="j" type="revolut"><parent link="a"/><child link="b"/></joint>': ["TOP007"],
    '<joint name="j" type="revolute"><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="2" upper="1" effort="-1" velocity="1"/></joint>': ["LIM001", "LIM007", "SRC011"],
    '<joint name="j" type="revolute"><parent link="a"/>'
    '<limit lower="2" upper="1" effort="1" velocity="1"/></joint>': ["FRM007", "LIM001", "SRC011"],
    '<joint name="j" type="prismatic"><axis xyz="1 0 0"/>'
    '<limit lower="0" upper="0" effort="1" velocity="1"/></joint>': ["LIM004", "SRC011", "SRC011"],
    '<joint name="j" type="fixed"><parent/><child link="b"/></joint>': ["SRC011"],
    '<joint name="j" type="fixed"><parent link="aa"/><child link="b"/></joint>': ["TOP001"],
    '<joint name="j" type="fixed"><parent link="a"/><parent link="b"/><child link="b"/></joint>': [
        "SRC006"
    ],
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0"/>'
    '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>': ["SRC007"],
    '<joint type="fixed"><parent link="a"/><child link="b"/></joint>': ["SRC011"],
    '<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>': ["TOP005"],
}
SDF = {
    '<joint name="j"><parent>a</parent><child>b</child></joint>': ["SRC011"],
    '<joint name="j" type="revolute"><child>b</child><axis><xyz>0 0 1</xyz>'
    "<limit><lower>2</lower><upper>1</upper></limit></axis></joint>": ["LIM001", "SRC011"],
    '<joint name="j" type="revolute"><parent>a</parent><axis><xyz>0 0 1</xyz></axis></joint>': [
        "SRC011"
    ],
    '<joint name="j" type="revolute"><parent>a</parent><child>b</child></joint>': ["FRM007"],
    '<joint name="j" type="fixed"><parent>a</parent><child>bb</child></joint>': ["TOP001"],
    '<joint name="j" type="screw"><axis><xyz>0 0 1</xyz><limit><lower>1</lower>'
    "<upper>0</upper></limit></axis></joint>": ["LIM001", "SRC011", "SRC011"],
}


def codes(text: str, name: str) -> list[str]:
    """The codes of errors and warnings in *text*."""
    report = lint(text, name)
    return sorted(each.rule.code for each in report.findings if each.severity != Severity.INFO)


@pytest.mark.parametrize("joint", URDF)
def test_half_a_urdf(joint: str) -> None:
    """What is there is judged, and what is missing is told once."""
    text = f'<robot name="r"><link name="a"/><link name="b"/>{joint}</robot>'
    assert codes(text, "arm.urdf") == URDF[joint]


@pytest.mark.parametrize("joint", SDF)
def test_half_an_sdf(joint: str) -> None:
    """What is there is judged, and what is missing is told once."""
    text = (
        f'<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>{joint}</model></sdf>'
    )
    assert codes(text, "arm.sdf") == SDF[joint]
