"""Where a file does not expand, what is wrong is told in words, and placed."""

from __future__ import annotations

from pathlib import Path

import pytest
from expanding import document, failure, project, robot, said

MACRO = '<xacro:macro name="m" params="a *b"><link name="${a}"/></xacro:macro>'
BLOCK = "<box/>"

FAILURES = {
    "undefined name": (
        ['<link name="l${length}"/>'],
        "expression 'length' has no value: name 'length' is not defined",
        "main.xacro:2:13 l${length}",
    ),
    "undefined name in a property": (
        ['<xacro:property name="p" value="${q}"/>', '<link name="${p}"/>'],
        "expression 'q' has no value: name 'q' is not defined",
        "main.xacro:3:13 ${p}",
    ),
    "undefined name in text": (
        ["<link><x>", "  ${length}", "</x></link>"],
        "expression 'length' has no value: name 'length' is not defined",
        "main.xacro:3:3 ${length}",
    ),
    "slip in an expression": (
        ['<link name="${1 +}"/>'],
        "expression '1 +' has no value: invalid syntax",
        "main.xacro:2:13 ${1 +}",
    ),
    "division by zero": (
        ['<link name="${1 / 0}"/>'],
        "expression '1 / 0' has no value: division by zero",
        "main.xacro:2:13 ${1 / 0}",
    ),
    "open expression": (
        ['<link name="a${1"/>'],
        "an expression has no end: '${1'",
        "main.xacro:2:13 a${1",
    ),
    "unknown substitution": (
        ['<link name="$(anon x)"/>'],
        "substitution '$(anon x)' has no value: '$(anon x)' is not a substitution that xacro knows",
        "main.xacro:2:13 $(anon x)",
    ),
    "unknown macro": (["<xacro:arm/>"], "there is no macro 'arm'", "main.xacro:2:2 xacro:arm"),
    "unknown parameter": (
        [MACRO, f'<xacro:m a="1" c="2">{BLOCK}</xacro:m>'],
        "the macro has no parameter 'c'",
        "main.xacro:3:19 2",
    ),
    "missing parameter": (
        [MACRO, f"<xacro:m>{BLOCK}</xacro:m>"],
        "the macro is called without 'a'",
        "main.xacro:3:2 xacro:m",
    ),
    "missing block": (
        [MACRO, '<xacro:m a="1"/>'],
        "the macro is called without a block that it needs",
        "main.xacro:3:2 xacro:m",
    ),
    "block too many": (
        [MACRO, f'<xacro:m a="1">{BLOCK}<sphere/></xacro:m>'],
        "the macro takes no block like 'sphere'",
        "main.xacro:3:2 xacro:m",
    ),
    "unknown block": (
        ['<xacro:insert_block name="b"/>'],
        "there is no block 'b' here",
        "main.xacro:2:27 b",
    ),
    "no boolean": (
        ["<xacro:if value=\"${'maybe'}\"/>"],
        "the condition '${'maybe'}' is 'maybe', which is neither true nor false",
        "main.xacro:2:18 ${'maybe'}",
    ),
    "missing file": (
        ['<xacro:include filename="nowhere.xacro"/>'],
        "there is no file 'nowhere.xacro'",
        "main.xacro:2:26 nowhere.xacro",
    ),
    "missing attribute": (
        ['<xacro:arg name="a"/>'],
        "element 'xacro:arg' lacks the attribute 'default'",
        "main.xacro:2:2 xacro:arg",
    ),
    "bad name": (
        ['<xacro:property name="1a" value="0"/>'],
        "'1a' is not a valid property name",
        "main.xacro:2:23 1a",
    ),
    "two values": (
        ['<xacro:property name="p" value="0" default="1"/>'],
        "property 'p' has more than one of default, value and remove",
        "main.xacro:2:23 p",
    ),
    "nothing to forward": (
        ['<xacro:macro name="m" params="a:=^"/>', "<xacro:m/>"],
        "there is no property 'a' to forward",
        "main.xacro:3:2 xacro:m",
    ),
    "outermost scope": (
        ['<xacro:property name="p" value="0" scope="parent"/>'],
        "there is no scope around this one",
        "main.xacro:2:23 p",
    ),
    "fatal": (
        ["<link name=\"${xacro.fatal('no', 1)}\"/>"],
        "no 1",
        "main.xacro:2:13 ${xacro.fatal('no', 1)}",
    ),
}


@pytest.mark.parametrize(("lines", "reason", "place"), FAILURES.values(), ids=FAILURES.keys())
def test_failures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, lines: list[str], reason: str, place: str
) -> None:
    monkeypatch.chdir(tmp_path)
    assert failure(document(project(tmp_path, main=robot(*lines)))) == (reason, place)


def test_a_failure_inside_a_macro_tells_of_the_call(tmp_path: Path) -> None:
    path = project(
        tmp_path,
        main=robot('<xacro:include filename="parts.xacro"/>', '<xacro:part w="a"/>'),
        parts=robot('<xacro:macro name="part" params="w"><link name="${w / 2}"/></xacro:macro>'),
    )
    reason, place = failure(document(path))
    assert reason == (
        "expression 'w / 2' has no value: unsupported operand type(s) for /: 'str' and 'int'"
        f", in macro 'part' called at {path}:3"
    )
    assert place == "parts.xacro:2:49 ${w / 2}"


def test_an_optional_file_may_be_missing(tmp_path: Path) -> None:
    main = robot('<xacro:include filename="nowhere.xacro" optional="true"/>', '<link name="a"/>')
    assert not said(document(project(tmp_path, main=main)), "ExpansionFailure", "reason")


@pytest.mark.parametrize("own", [True, False], ids=["the file itself", "an included file"])
def test_what_is_no_xml(tmp_path: Path, own: bool) -> None:  # noqa: FBT001
    path = project(
        tmp_path,
        main=robot('<xacro:include filename="broken.xacro"/>'),
        broken="<robot>\n<link></robot>\n",
    )
    found = document(tmp_path / "broken.xacro" if own else path)
    assert said(found, "MalformedText", "reason") == [
        ("not well-formed: mismatched tag", "broken.xacro:2:9 r")
    ]


def test_an_included_file_that_is_no_text(tmp_path: Path) -> None:
    path = project(tmp_path, main=robot('<xacro:include filename="other.xacro"/>'))
    (tmp_path / "other.xacro").write_bytes(b"robot\0")
    reason, place = failure(document(path))
    assert "other.xacro' cannot be read: " in reason
    assert place == "main.xacro:2:26 other.xacro"


REMARKS = {
    "unknown attribute": (
        ['<xacro:property name="p" value="1" unit="m"/>'],
        "xacro:property: unknown attribute(s): unit",
        "main.xacro:2:2 xacro:property",
    ),
    "children of an include": (
        ['<xacro:include filename="other.xacro"><link/></xacro:include>'],
        "Child elements of a <xacro:include> tag are ignored",
        "main.xacro:2:2 xacro:include",
    ),
    "no file": (
        ['<xacro:include filename="no*.xacro"/>'],
        "no file matches 'no*.xacro'",
        "main.xacro:2:2 xacro:include",
    ),
    "own warning": (
        ["<link name=\"a${xacro.warning('old')}\"/>"],
        "old",
        "main.xacro:2:2 link",
    ),
}


@pytest.mark.parametrize(("lines", "message", "place"), REMARKS.values(), ids=REMARKS.keys())
def test_remarks(
    tmp_path: Path, lines: list[str], message: str, place: str, capfd: pytest.CaptureFixture[str]
) -> None:
    path = project(tmp_path, main=robot(*lines), other=robot())
    assert said(document(path), "XacroRemark", "reason") == [(message, place)]
    assert capfd.readouterr() == ("", "")


def test_symbols_of_xacro(tmp_path: Path) -> None:
    main = robot('<xacro:property name="pi" value="3.14"/>', '<link name="a"/>')
    found = document(project(tmp_path, main=main))
    assert said(found, "ShadowedSymbol", "symbol") == [("pi", "main.xacro:2:23 pi")]
