"""Editors find what addresses of COLLADA lead to, also elements without a name."""

from __future__ import annotations

import pytest
from support.linting import book, source

from kinlint.configuration.settings import Settings
from kinlint.formats.xml.element_types import Address
from kinlint.formats.xml.unfinished_text import UnfinishedText
from kinlint.navigation.completion.addressed_names import candidates
from kinlint.navigation.navigator import Navigator
from kinlint.pipeline.analyzer import Analyzer

TEXT = """<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_joints><joint id="hinge" name="elbow">
<revolute sid="a"><axis>0 0 1</axis></revolute></joint></library_joints>
<library_kinematics_models><kinematics_model id="arm"><technique_common>
<instance_joint url="#hinge" sid="elbow_inst"/>
<link sid="base"><attachment_full joint="arm/elbow_inst"><link sid="tip"/></attachment_full></link>
</technique_common></kinematics_model></library_kinematics_models>
<library_kinematics_scenes><kinematics_scene id="moved">
<instance_kinematics_model url="#arm" sid="robot"><newparam sid="turn">
<SIDREF>moved/robot/elbow_inst/a</SIDREF></newparam></instance_kinematics_model>
</kinematics_scene></library_kinematics_scenes>
<scene><instance_kinematics_scene url="#moved"/></scene>
</COLLADA>
"""


@pytest.mark.parametrize(
    ("address", "name"),
    [
        ('joint="arm/elbow_inst', 'sid="elbow_inst'),
        ('url="#hinge', 'name="elbow'),
        ("<SIDREF>moved/robot", 'revolute sid="a'),
        ('instance_kinematics_model url="#arm', 'kinematics_model id="arm'),
    ],
)
def test_addresses_lead_to_elements(address: str, name: str) -> None:
    sources = [source(TEXT, "arm.dae")]
    navigator = Navigator(Analyzer(Settings(), book(), repeated=True).examine(sources), book(), {})
    (found,) = navigator.definitions("arm.dae", TEXT.index(address) + len(address))

    assert found.span.end == TEXT.index(name) + len(name)


@pytest.mark.parametrize(
    ("manner", "targets", "offered"),
    [
        ("uri", ("joint",), ["#hinge"]),
        ("parameter", (), ["turn"]),
        ("sid", ("link",), ["moved/robot/base", "arm/base", "moved/robot/tip", "arm/tip"]),
        ("sid", ("revolute",), ["arm/elbow_inst/a", "hinge/a"]),
        ("sid", ("rigid_body",), []),
    ],
)
def test_addresses_are_completed(manner: str, targets: tuple[str, ...], offered: list[str]) -> None:
    found = candidates(Address("", manner, targets), UnfinishedText(TEXT).elements)

    assert [each.label for each in found] == offered
