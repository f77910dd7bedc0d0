"""Formats are told apart by what a text says, and by the end of its name if that is not enough."""

from __future__ import annotations

import pytest
from data import locate_data

from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.recognition import objection, recognise
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import decode, read

MACROS = '<robot xmlns:xacro="x" name="a"><xacro:arm/></robot>'
EXPANDED = '<robot xmlns:xacro="x" name="a"><!-- <xacro:arm/> --><link name="a"/></robot>'
SEMANTIC = "<robot name='a'><!-- <link/> --><group name='g'><link name='a'/></group></robot>"


@pytest.mark.parametrize(
    ("name", "text", "form"),
    [
        ("-", "<robot name='a'/>", "urdf"),
        ("-", "<?xml version='1.0'?>\n<!-- <sdf> -->\n<robot name='a'><link/></robot>", "urdf"),
        ("-", "\n\n<robot name='a'><material/></robot>", "urdf"),
        ("a.srdf", "<robot name='a'/>", "srdf"),
        ("a.urdf", SEMANTIC, "srdf"),
        ("-", SEMANTIC, "srdf"),
        ("-", "<robot><unknown><group/></unknown><joint/></robot>", "urdf"),
        ("-", MACROS, "xacro"),
        ("a.xml", MACROS, "xacro"),
        ("a.urdf", MACROS, "urdf"),
        ("a.URDF", MACROS, "urdf"),
        ("a.srdf", MACROS, "srdf"),
        ("-", EXPANDED, "urdf"),
        ("a.urdf.xacro", EXPANDED, "xacro"),
        ("a.sdf.xacro", "<sdf version='1.9'/>", "xacro"),
        ("a.xml", "<sdf version='1.9'/>", "sdf"),
        ("a.urdf", "<sdf version='1.9'/>", "sdf"),
        ("a.sdf", "<robot name='a'/>", "urdf"),
        ("-", "<gazebo version='1.0'/>", "sdf"),
        ("-", "<gazebo reference='a'/>", None),
        ("a.world", "<sdf version='1.9'/>", "sdf"),
        ("a.world", "<world/>", "sdf"),
        ("a.sdf", "  benzene\n  CDK\n", None),
        ("a.urdf", "", "urdf"),
        ("a.urdf", "no robot", "urdf"),
        ("a.urdf", "<html/>", "urdf"),
        ("a.xml", "<package format='3'/>", None),
        ("a.xml", "<launch/>", None),
        ("a.xml", "<model><name>a</name></model>", None),
        ("a.xml", "<mujoco/>", "mjcf"),
        ("a.dae", "<COLLADA version='1.5.0'/>", "collada"),
        ("-", "<a> <b> <c> .", "nquads"),
        ("-", "<https://e.org/a> <https://e.org/b> <https://e.org/c> .", "nquads"),
        ("-", "@prefix a: <b> .\n<a> a:b <c> .", "turtle"),
        ("-", "<!-- only a comment", None),
        ("-", "<robot <robot", "urdf"),
    ],
)
def test_a_text_is_recognised(name: str, text: str, form: str | None) -> None:
    assert recognise(name, text) == BY_NAME.get(form)


@pytest.mark.parametrize("kind", ["urdf", "srdf", "sdf", "xacro"])
def test_every_robot_is_recognised(kind: str) -> None:
    for path in sorted(locate_data("robots", kind).rglob(f"*.{kind}")):
        source = decode(str(path), path.read_bytes())
        assert source.format == BY_NAME[kind], path


def test_a_file_that_is_no_robot_is_told_what_is_read() -> None:
    with pytest.raises(SourceError, match=r"^a\.xml: not a robot model: kinlint reads JSON-LD"):
        read(decode("a.xml", b"<launch/>"), ReadOptions())
    assert objection()
