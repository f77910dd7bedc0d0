"""Fixes of MJCF change of the compiled model what they say, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.linting import book

from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.fixes.rounds import fix_in_rounds
from kinlint.rule import Applicability
from kinlint.text import SourceText

mujoco = pytest.importorskip("mujoco", reason="the wheel of MuJoCo is not installed")
np = pytest.importorskip("numpy")

pytestmark = pytest.mark.external
ARM = """<mujoco>
  {top}
  <worldbody>
    <body name="base">
      <geom size="0.1"/>
      <body name="arm" {pose}>
        <joint name="elbow" {joint}/>
        <geom name="shell" size="0.1"/>
        {more}
      </body>
    </body>
  </worldbody>
  <actuator><motor name="drive" joint="{driven}" {drive}/></actuator>
</mujoco>
"""
PLACES = ("qpos0", "body_pos", "body_quat", "body_mass", "body_inertia", "jnt_pos", "jnt_axis")
LIMITS = ("jnt_range", "jnt_limited", "actuator_ctrlrange", "actuator_ctrllimited")
ALL = (*PLACES, *LIMITS)


def arm(**parts: str) -> str:
    """A model of one joint with *parts* in it."""
    defaults = {"top": "", "pose": "", "joint": 'axis="0 1 0"', "more": "", "driven": "elbow"}
    return ARM.format(**{**defaults, "drive": "", **parts})


def fixed(path: Path, code: str) -> list[str]:
    """Fix what the rule *code* finds in *path*, and in what it includes; the names that changed."""
    settings = Settings(default=FileSettings((Choice(select=(code,)),)))
    source = SourceText(str(path), path.read_text())
    found = fix_in_rounds([source], (), settings, book(), Applicability.UNSAFE)
    for _, after in found.changed:
        Path(after.name).write_text(after.text)
    assert not [each for each in found.report.findings if each.rule.code == code]
    return [Path(after.name).name for _, after in found.changed]


def compiled(path: Path) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(path))


def differing(before: mujoco.MjModel, after: mujoco.MjModel) -> set[str]:
    """The arrays in which two models of the same size differ."""
    return {n for n in ALL if not np.array_equal(getattr(before, n), getattr(after, n))}


@pytest.mark.parametrize(
    ("code", "text", "changed"),
    [
        ("FRM050", arm(pose='euler="10 20 30"'), set()),
        ("FRM050", arm(pose='euler="10 20 30"', top='<compiler meshdir="a"/>'), set()),
        ("FRM051", arm(joint='range="-90 90"'), set()),
        ("LIM030", arm(joint='axis="0 1 0" range="90 -45"'), {"jnt_range", "jnt_limited"}),
        (
            "LIM030",
            arm(top='<default><joint range="90 -45"/></default>'),
            {"jnt_range", "jnt_limited"},
        ),
        ("LIM030", arm(drive='ctrlrange="1 -1"'), {"actuator_ctrlrange", "actuator_ctrllimited"}),
        ("LIM025", arm(joint='range="-90 90" limited="false"'), {"jnt_range", "jnt_limited"}),
        ("LIM025", arm(drive='ctrlrange="-1 1" ctrllimited="false"'), {"actuator_ctrllimited"}),
        ("UNI022", arm(joint='axis="0 1 0" range="-1.5 1.5"'), {"jnt_range"}),
        (
            "UNI022",
            arm(top='<compiler angle="radian"/>', joint='axis="0 1 0" range="-90 90"'),
            {"jnt_range"},
        ),
        (
            "INE021",
            arm(more='<geom size="0.1" contype="0" conaffinity="0"/>'),
            {"body_mass", "body_inertia"},
        ),
    ],
)
def test_a_fix_changes_what_it_says_and_nothing_else(
    code: str, text: str, changed: set[str], tmp_path: Path
) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(text)
    before = compiled(path)
    assert fixed(path, code) == ["arm.xml"]

    assert differing(before, compiled(path)) == changed


@pytest.mark.parametrize(
    ("code", "text"),
    [
        ("CMP033", arm(driven="elbwo")),
        (
            "LIM026",
            arm(top='<compiler autolimits="false"/>', joint='axis="0 1 0" range="-90 90"'),
        ),
        (
            "LIM026",
            arm(top='<compiler autolimits="false"/>', drive='ctrlrange="-1 1"'),
        ),
        ("LIM030", arm(joint='axis="0 1 0" range="90 -90" limited="true"')),
    ],
)
def test_a_fix_makes_mujoco_read_the_file(code: str, text: str, tmp_path: Path) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"Error|unknown|range"):
        compiled(path)
    fixed(path, code)

    assert compiled(path).njnt == 1


def test_the_default_class_of_an_included_file_is_fixed_there(tmp_path: Path) -> None:
    """Each of the joints that take the range is limited then."""
    path, classes = tmp_path / "arm.xml", tmp_path / "classes.xml"
    classes.write_text(
        '<mujoco><default><default class="bent"><joint range="90 0"/></default></default></mujoco>'
    )
    text = arm(
        top='<include file="classes.xml"/>',
        joint='class="bent"',
        more='<body><joint class="bent"/><geom size="0.1"/></body>',
    )
    path.write_text(text)
    assert not compiled(path).jnt_limited.any()

    assert fixed(path, "LIM030") == ["classes.xml"]
    assert 'range="0 90"' in classes.read_text()
    assert compiled(path).jnt_limited.all()


def test_a_value_of_a_class_that_is_lifted_is_fixed_in_the_class(tmp_path: Path) -> None:
    """A limit that was rounded up is written once, in the class, for all joints that take it."""
    path = tmp_path / "arm.xml"
    path.write_text(
        arm(
            top='<compiler angle="radian"/><default><joint range="-1.5708 1.5708"/></default>',
            more='<body><joint axis="1 0 0"/><geom size="0.1"/></body>',
        )
    )
    fixed(path, "LIM010")

    assert path.read_text().count("1.5707963267948966") == 2
    assert np.abs(compiled(path).jnt_range).max() <= np.pi / 2
