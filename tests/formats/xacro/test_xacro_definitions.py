"""Parameters that nobody uses and properties that hide others are found, and no others."""

from __future__ import annotations

from pathlib import Path

import pytest
from expanding import document, project, robot, said

from kinlint.vocabulary import SRC

UNUSED = {
    "unused": ('<xacro:macro name="m" params="a b"><link name="${a}"/></xacro:macro>', ["b"]),
    "in a string": ('<xacro:macro name="m" params="a"><link name="a"/></xacro:macro>', ["a"]),
    "with default": ('<xacro:macro name="m" params="a:=1 b:=${x+1}"/>', ["a", "b"]),
    "block": ('<xacro:macro name="m" params="*a **b"><link name="${a}"/></xacro:macro>', ["**b"]),
    "of text": ('<xacro:macro name="m" params="a"><x>${a}</x></xacro:macro>', []),
    "inserted": (
        '<xacro:macro name="m" params="*a"><xacro:insert_block name="a"/></xacro:macro>',
        [],
    ),
    "in a default": (
        '<xacro:macro name="m" params="a b:=${a}"><link name="${b}"/></xacro:macro>',
        [],
    ),
    "in a condition": (
        '<xacro:macro name="m" params="a"><xacro:if value="${a}"/></xacro:macro>',
        [],
    ),
    "by a macro called": (
        (
            '<xacro:macro name="inner"><link name="${a}"/></xacro:macro>'
            '<xacro:macro name="m" params="a"><xacro:inner/></xacro:macro>'
        ),
        [],
    ),
    "handed on": (
        (
            '<xacro:macro name="inner" params="a:=^"><link name="${a}"/></xacro:macro>'
            '<xacro:macro name="m" params="a"><xacro:inner/></xacro:macro>'
        ),
        [],
    ),
    "by an included file": (
        '<xacro:macro name="m" params="a"><xacro:include filename="x"/></xacro:macro>',
        [],
    ),
    "by a macro of any name": (
        '<xacro:macro name="m" params="a"><xacro:call macro="x"/></xacro:macro>',
        [],
    ),
    "by a macro not known": (
        '<xacro:macro name="m" params="a"><xacro:elsewhere/></xacro:macro>',
        [],
    ),
    "by a substitution": (
        '<xacro:macro name="m" params="a"><link name="$(find ${a})"/></xacro:macro>',
        [],
    ),
}


@pytest.mark.parametrize(("text", "expected"), UNUSED.values(), ids=UNUSED.keys())
def test_unused_parameters(tmp_path: Path, text: str, expected: list[str]) -> None:
    found = document(project(tmp_path, main=robot(text)))
    assert [name for name, _ in said(found, "UnusedParameter", "parameter")] == expected


def test_places_of_parameters(tmp_path: Path) -> None:
    main = robot("<xacro:macro name='m' params='a:=1   *b", "  c'/>")
    found = document(project(tmp_path, main=main))
    assert [place for _, place in said(found, "UnusedParameter", "parameter")] == [
        "main.xacro:2:31 a",
        "main.xacro:2:38 *b",
        "main.xacro:3:3 c",
    ]


def test_a_property_that_hides_one_of_another_file(tmp_path: Path) -> None:
    path = project(
        tmp_path,
        main=robot(
            '<xacro:include filename="parts.xacro"/>',
            '<xacro:macro name="m">',
            '  <xacro:property name="w" value="2"/>',
            '  <xacro:property name="own" value="2"/>',
            '  <xacro:property name="h" value="2" scope="global"/>',
            "</xacro:macro>",
        ),
        parts=robot('<xacro:property name="w" value="1"/>', '<xacro:property name="h" value="1"/>'),
    )
    found = document(path)
    assert said(found, "ShadowedProperty", "property") == [("w", "main.xacro:4:25 w")]
    ((outer, _),) = said(found, "ShadowedProperty", "outer")
    assert outer == f"{tmp_path / 'parts.xacro'}:2"


@pytest.mark.parametrize(
    ("called", "inside", "is_robot"),
    [
        (True, '<lnik name="${side}"/>', True),
        (True, '<jont name="${side}"/>', True),
        (True, '<material name="${side}"/>', False),
        (True, '<plugin name="${side}"/>', False),
        (False, '<lnik name="${side}"/>', False),
    ],
    ids=["link", "joint", "material", "other", "uncalled"],
)
def test_misspelt_elements_make_a_robot(
    tmp_path: Path, *, called: bool, inside: str, is_robot: bool
) -> None:
    macro = f'<xacro:macro name="leg" params="side">{inside}</xacro:macro>'
    calls = ['<xacro:leg side="left"/>'] if called else []
    found = document(project(tmp_path, arm=robot(macro, *calls)))
    assert (f"<{SRC}UndeclaredElement>" in {o for _, _, o in found.statements}) is is_robot
