"""Values of joints in COLLADA that follow from units, levels of limits and formulas."""

from __future__ import annotations

from math import radians

import pytest
from reading_collada import derived, model, read

from kinlint.errors import SourceError

ELBOW = (
    '<joint id="elbow" name="elbow"><revolute sid="a"><axis>0 1 0</axis>'
    "<limits><min>-90</min><max>90</max></limits></revolute></joint>"
)
SLIDE = '<joint id="slide" name="slide"><prismatic sid="a"><axis>0 0 1</axis></prismatic></joint>'
ARM = (
    '<instance_joint url="#elbow" sid="elbow"/><instance_joint url="#slide" sid="slide"/>'
    '<link sid="base"><attachment_full joint="arm/elbow"><link sid="tip">'
    '<attachment_full joint="arm/slide"><link sid="rod"/></attachment_full></link>'
    "</attachment_full></link>"
)
SYSTEM = (
    '<library_articulated_systems><articulated_system id="kin"><kinematics>'
    '<instance_kinematics_model url="#arm" sid="inst"/><technique_common>'
    '<axis_info sid="info" axis="arm/elbow/a"><limits><min><float>-45</float></min>'
    "<max><float>30</float></max></limits></axis_info></technique_common></kinematics>"
    '</articulated_system><articulated_system id="motion"><motion>'
    '<instance_articulated_system url="#kin"/><technique_common>'
    '<axis_info axis="kin/info"><speed><float>90</float></speed></axis_info>'
    "</technique_common></motion></articulated_system></library_articulated_systems>"
)
MILLIMETRE = '<unit name="millimeter" meter="0.001"/>'


def test_limits_of_an_axis_info_count_before_those_of_the_joint() -> None:
    found = read(model(ARM, joints=ELBOW + SLIDE), SYSTEM)
    assert [*derived(found, "lower").values()] == [pytest.approx(radians(-45))]
    assert [*derived(found, "upper").values()] == [pytest.approx(radians(30))]


@pytest.mark.parametrize(
    ("tool", "speed"),
    [
        ("OpenRAVE Collada Writer", 90.0),
        ("OpenRAVE Collada Writer 2", radians(90)),
        ("", radians(90)),
    ],
)
def test_the_name_of_the_tool_decides_on_the_unit_of_speeds(tool: str, speed: float) -> None:
    """OpenRAVE reads radians in what its writer of that very name wrote."""
    said = f"<contributor><authoring_tool>{tool}</authoring_tool></contributor>"
    found = read(model(ARM, joints=ELBOW + SLIDE), SYSTEM, unit=f"{said}<unit/>")
    assert [*derived(found, "velocity").values()] == [pytest.approx(speed)]


@pytest.mark.parametrize(
    ("math", "multiplier", "offset"),
    [
        ("{}", 1.0, 0.0),
        ("<apply><minus/>{}</apply>", -1.0, 0.0),
        ("<apply><plus/><apply><times/><cn>2</cn>{}</apply><cn>5</cn></apply>", 2.0, 5.0),
        ("<apply><minus/>{}<cn>5</cn></apply>", 1.0, -5.0),
        ("<apply><divide/>{}<cn>4</cn></apply>", 0.25, 0.0),
        ("<apply><sin/>{}</apply>", None, None),
        ("<apply><times/>{0}{0}</apply>", None, None),
    ],
)
def test_a_linear_formula_is_a_coupling(
    math: str, multiplier: float | None, offset: float | None
) -> None:
    """In metres and radians; the formula is in millimetres for each degree."""
    symbol = '<csymbol encoding="COLLADA">arm/elbow</csymbol>'
    formula = (
        "<formula><target><param>arm/slide</param></target><technique_common>"
        f'<math xmlns="http://www.w3.org/1998/Math/MathML">{math.format(symbol)}</math>'
        "</technique_common></formula>"
    )
    found = read(model(ARM, formula, joints=ELBOW + SLIDE), unit=MILLIMETRE)
    if multiplier is None or offset is None:
        assert derived(found, "multiplier") == {}
        return
    assert [*derived(found, "multiplier").values()] == [
        pytest.approx(multiplier * 0.001 / radians(1))
    ]
    assert [*derived(found, "offset").values()] == [pytest.approx(offset * 0.001)]
    assert [*derived(found, "leader").values()] == ["library_joints/joint/elbow"]


def test_the_halves_of_a_loop_are_one_joint() -> None:
    """With a frame on each of the two links."""
    loop = ELBOW.replace("elbow", "closing")
    links = ARM.replace(
        '<link sid="rod"/>',
        '<link sid="rod"><attachment_end joint="arm/closing"><translate>0 0 200</translate>'
        "</attachment_end></link>",
    ).replace(
        '<link sid="base">',
        '<link sid="base"><attachment_start joint="arm/closing"><translate>100 0 0</translate>'
        "</attachment_start>",
    )
    inside = '<instance_joint url="#closing" sid="closing"/>', links
    found = read(model(*inside, joints=ELBOW + SLIDE + loop), unit=MILLIMETRE)
    name = "library_joints/joint/closing"
    assert derived(found, "parent-x")[name] == pytest.approx(0.1)
    assert derived(found, "child-z")[name] == pytest.approx(0.2)
    assert str(derived(found, "childBody")[name]).count("link") == 3


@pytest.mark.parametrize(
    ("content", "cause"),
    [
        ('<link sid="a"/>' * 3_001, "more than 3000 elements <link>"),
        (f'<link sid="a">{"<translate/>" * 2_001}</link>', "<link> has more than 2000 transforms"),
    ],
    ids=["links", "transforms"],
)
def test_more_than_any_robot_has_is_refused(content: str, cause: str) -> None:
    with pytest.raises(SourceError, match=cause):
        read(model(content))
