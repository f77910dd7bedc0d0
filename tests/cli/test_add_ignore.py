"""`--add-ignore`: writes suppressions of what is found."""

import io
import json
import os
import sys

import pytest

ARM = """<?xml version="1.0"?>\r
<robot name="arm">\r
  <link name="base"/>\r
  <link name="hand"/>\r
  <joint name="elbow" type="revolute">\r
    <parent link="base"/><child link="hand"/><axis xyz="0 0 2"/>\r
    <limit lower="2.60" upper="-2.6" effort="10" velocity="1"/>   <!-- wrong -->\r
  </joint>\r
</robot>"""
ONLY = ("--select", "LIM001,FRM009,LNT", "--output-format", "concise")
IGNORED = ARM.replace(
    '    <limit lower="2.60"',
    '    <!-- kinlint: ignore[LIM001] a slip -->\r\n    <limit lower="2.60"',
).replace('<axis xyz="0 0 2"/>', '<axis xyz="0 0 2"/><!-- kinlint: ignore[FRM009] a slip -->')


@pytest.fixture
def arm(here):
    path = here / "arm ü.urdf"
    path.write_bytes(ARM.encode())
    return path


def test_comments_in_xml(kinlint, arm):
    """A line above the element, or behind one that does not begin its line; nothing else."""
    code, out, err = kinlint("--add-ignore=a slip", *ONLY)
    assert (code, arm.read_bytes().decode()) == (0, IGNORED)
    assert "2 suppressed" in out
    assert "2 findings silenced" in err
    code, out, _ = kinlint(*ONLY)
    assert (code, "2 suppressed" in out) == (0, True)
    assert kinlint("--add-ignore=a slip", *ONLY)[0] == 0
    assert arm.read_bytes().decode() == IGNORED


def test_a_comment_that_is_there_is_joined(kinlint, arm):
    """If it gives the same reason; another reason makes another comment."""
    arm.write_text(
        ARM.replace("    <limit", "    <!-- kinlint: ignore[LIM016] why -->\n    <limit"), "utf-8"
    )
    kinlint("--add-ignore=why", *ONLY, "--ignore", "FRM,LNT")
    assert "<!-- kinlint: ignore[LIM016, LIM001] why -->\n    <limit" in arm.read_text("utf-8")
    arm.write_text(
        ARM.replace("    <limit", "    <!-- kinlint: ignore[LIM016] why -->\n    <limit"), "utf-8"
    )
    kinlint("--add-ignore", *ONLY, "--ignore", "FRM,LNT")
    assert "why -->\n    <!-- kinlint: ignore[LIM001] -->\n    <limit" in arm.read_text("utf-8")


def test_a_file_of_one_line(kinlint, here):
    """Keeps to it, and its byte order mark."""
    text = "\ufeff" + "".join(line.strip() for line in ARM.splitlines())
    path = here / "one.urdf"
    path.write_bytes(text.encode())
    assert kinlint("--add-ignore", *ONLY)[0] == 0
    written = path.read_bytes().decode()
    assert written.count("<!-- kinlint: ignore[") == 2
    assert (
        written.replace("<!-- kinlint: ignore[LIM001] -->", "").replace(
            "<!-- kinlint: ignore[FRM009] -->", ""
        )
        == text
    )


@pytest.mark.parametrize(("reason", "said"), [(None, '"LIM001"'), ("x ü 𝄞", "x ü 𝄞")])
def test_a_statement_in_json_ld(kinlint, write, reason, said):
    """On the node; the graph is the old one and that statement."""
    text = """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/#"}],
  "@id": "ex:limit", "@type": "JointPositionLimit", "of-joint": "ex:joint",
  "quantity-kind": "Angle", "unit": "RAD", "lower": 1.5, "upper": -1.5
}
"""
    path = write("limit.jsonld", text)
    option = "--add-ignore" if reason is None else f"--add-ignore={reason}"
    assert kinlint(option, "limit.jsonld", "--select", "LIM001,LNT")[0] == 0
    written = path.read_text("utf-8")
    told = json.loads(written)
    ignore = told.pop("kl:ignore")
    expected = "LIM001" if reason is None else {"kl:rule": "LIM001", "kl:reason": reason}
    assert ignore == expected
    told["@context"][1].pop("kl")
    assert told == json.loads(text)
    assert kinlint("limit.jsonld", "--select", "LIM001,LNT")[0] == 0


@pytest.mark.parametrize("end", ["\n", "\r\n", ""])
def test_a_statement_in_turtle(kinlint, here, end):
    """At the end of the file."""
    lines = [
        "@prefix kin: <https://w3id.org/kinlint/kinematics#> .",
        "@prefix qudt: <http://qudt.org/schema/qudt/> .",
        "<#limit> a kin:JointPositionLimit ; qudt:unit <http://qudt.org/vocab/unit/RAD> ;",
        "  qudt:hasQuantityKind <http://qudt.org/vocab/quantitykind/Angle> ;",
        '  kin:of-joint <#joint> ; kin:lower 1.5e0 ; kin:upper -1.5e0 .  # a "comment"',
    ]
    path = here / "limit.ttl"
    path.write_bytes(((end or "\n").join(lines) + end).encode())
    before = path.read_bytes()
    options = ("limit.ttl", "--select", "LIM001,LNT")
    assert kinlint(*options)[0] == 1
    assert kinlint(*options, "--add-ignore=why 'ü'")[0] == 0
    after = path.read_bytes()
    assert after.startswith(before)
    assert b"<#limit> <https://w3id.org/kinlint/ns#ignore> _:kinlint1x0 ." in after
    assert after.endswith((end or "\n").encode())
    assert kinlint(*options)[0] == 0


def test_an_included_macro_is_silenced_where_it_is_written(kinlint, write):
    """Once, for all its uses."""
    write(
        "limits.xacro",
        '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:macro name="limits">\n'
        '  <limit lower="2" upper="1" effort="1" velocity="1"/>\n</xacro:macro></robot>',
    )
    joint = '<joint name="{}" type="revolute"><parent link="a"/><child link="{}"/>'
    joint += "<xacro:limits/></joint>"
    path = write(
        "arm.urdf.xacro",
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">'
        '<xacro:include filename="limits.xacro"/><link name="a"/><link name="b"/><link name="c"/>'
        + joint.format("j", "b")
        + joint.format("k", "c")
        + "</robot>",
    )
    before = path.read_text("utf-8")
    code, _, _ = kinlint("arm.urdf.xacro", "--add-ignore", "--select", "LIM001,LNT")
    assert (code, path.read_text("utf-8")) == (0, before)
    text = (path.parent / "limits.xacro").read_text("utf-8")
    assert text.count('  <!-- kinlint: ignore[LIM001] -->\n  <limit lower="2"') == 1


def test_a_path_is_no_reason(kinlint, arm, write):
    """The reason stands behind `=` alone."""
    other = write("other.urdf", ARM.replace("arm", "other"))
    before = other.read_bytes()
    assert kinlint("--add-ignore", "arm ü.urdf", *ONLY)[0] == 0
    assert "ignore[LIM001] -->" in arm.read_text("utf-8")
    assert other.read_bytes() == before


def test_what_no_comment_can_hold(kinlint, arm):
    """Such a reason is refused, and nothing is written."""
    code, _, err = kinlint("--add-ignore=a -- b", *ONLY)
    assert (code, arm.read_bytes()) == (1, ARM.encode())
    assert "LIM001 at arm ü.urdf:7:19 is not silenced: no comment in XML can hold this" in err


def test_a_reason_that_is_required(kinlint, arm, write):
    """Has to be given, since without one there would be another finding."""
    write("kinlint.toml", "require-reason = true\n")
    code, _, err = kinlint("--add-ignore", *ONLY)
    assert (code, arm.read_bytes()) == (1, ARM.encode())
    assert "the configuration requires a reason" in err
    assert kinlint("--add-ignore=why", *ONLY)[0] == 0


def test_what_cannot_be_silenced_is_told(kinlint, write):
    """With the reason, and nothing is written."""
    path = write("bad.urdf", "<robot name='a'><link name='l'></robot>")
    before = path.read_bytes()
    code, _, err = kinlint("--add-ignore", "--output-format", "concise")
    assert (code, path.read_bytes()) == (2, before)
    assert "SRC019 at bad.urdf:1:32 is not silenced: it would be found all the same" in err


def test_what_can_be_silenced_is_although_something_cannot(kinlint, arm, write):
    """Suppressions in one model are tried together, and apart where they do not hold."""
    path = write("bad.urdf", "<robot name='arm'><link name='l'></robot>")
    before = path.read_bytes()
    code, _, err = kinlint("--add-ignore=a slip", "--select", "LIM001,FRM009,SRC019")
    assert (code, path.read_bytes()) == (2, before)
    assert "2 findings silenced" in err
    assert "SRC019 at bad.urdf:1:34 is not silenced: it would be found all the same" in err
    assert arm.read_bytes().decode() == IGNORED


def test_standard_input_comes_out_with_suppressions(kinlint, here, capsys, monkeypatch):
    """The text on standard output, the report aside."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(ARM.encode())))
    code, out, err = kinlint("-", "--stdin-filename", "arm.urdf", "--add-ignore=a slip", *ONLY)
    assert (code, out) == (0, IGNORED)
    assert "2 suppressed" in err


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no modes here")
def test_a_file_that_is_read_only_stays(kinlint, arm):
    """As with `--fix`: an error, and exit code 2."""
    arm.chmod(0o444)
    code = kinlint("--add-ignore", *ONLY, "-q")[0]
    assert (code, arm.read_bytes()) == (2, ARM.encode())


@pytest.mark.parametrize("other", ["--fix", "--fix-only", "--diff", "--write-baseline"])
def test_what_excludes_it(kinlint, arm, other):
    """Options that would have it write two things."""
    code, _, err = kinlint("--add-ignore", other, *ONLY)
    assert (code, f"--add-ignore and {other} exclude each other" in err) == (2, True)


def test_what_is_known_is_left(kinlint, arm):
    """With a baseline only what is new is silenced."""
    kinlint("--write-baseline", *ONLY)
    assert kinlint("--baseline", "kinlint-baseline.json", "--add-ignore", *ONLY)[0] == 0
    assert arm.read_bytes() == ARM.encode()
