"""`--fix`, `--fix-only`, `--diff`: what they write, print and return."""

import io
import sys

import pytest

from kinlint.cli import fix_files
from kinlint.files import atomic_write as files

ARM = """<?xml version="1.0"?>\r
<robot name="arm">\r
  <link name="base"/>\r
  <link name="hand"/>\r
  <joint name="elbow" type="revolute">\r
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>\r
    <limit lower="2.60" upper="-2.6" effort="10" velocity="1"/>   <!-- wrong -->\r
  </joint>\r
</robot>"""
FIXED = ARM.replace('lower="2.60" upper="-2.6"', 'lower="-2.6" upper="2.60"')
ONLY = ("--select", "LIM001", "--unsafe-fixes")


@pytest.fixture
def arm(here):
    """A file with one fault, CRLF line ends, and no line end at its end."""
    path = here / "arm.urdf"
    path.write_bytes(ARM.encode())
    return path


def test_fix_writes_and_reports_what_is_left(kinlint, arm):
    """Every other byte stays; a second run changes nothing."""
    code, out, _ = kinlint("arm.urdf", "--fix", *ONLY)
    assert (code, arm.read_bytes()) == (0, FIXED.encode())
    assert "1 fixed" in out

    before = arm.stat().st_mtime_ns
    assert kinlint("arm.urdf", "--fix", *ONLY)[0] == 0
    assert (arm.read_bytes(), arm.stat().st_mtime_ns) == (FIXED.encode(), before)


def test_unsafe_fixes_are_not_made_unless_asked_for(kinlint, arm):
    """And the summary says that they are there."""
    code, out, _ = kinlint("arm.urdf", "--fix", "--select", "LIM001")

    assert (code, arm.read_bytes()) == (1, ARM.encode())
    assert "1 can be fixed with --fix --unsafe-fixes" in out


def test_exit_codes(kinlint, arm):
    """`--exit-non-zero-on-fix` tells that something was changed; `--diff` that it would be."""
    assert kinlint("arm.urdf", "--diff", *ONLY)[0] == 1
    assert arm.read_bytes() == ARM.encode()
    assert kinlint("arm.urdf", "--fix-only", "--exit-non-zero-on-fix", *ONLY)[0] == 1
    assert arm.read_bytes() == FIXED.encode()
    assert kinlint("arm.urdf", "--fix-only", "--exit-non-zero-on-fix", *ONLY)[0] == 0
    assert kinlint("arm.urdf", "--diff", *ONLY)[0] == 0


def test_rules_may_be_left_out(kinlint, arm):
    """`--unfixable` and `--fixable` take selectors."""
    kinlint("arm.urdf", "--fix", "--unfixable", "LIM", *ONLY)
    assert arm.read_bytes() == ARM.encode()
    kinlint("arm.urdf", "--fix", "--fixable", "TOP", *ONLY)
    assert arm.read_bytes() == ARM.encode()
    kinlint("arm.urdf", "--fix", "--fixable", "LIM001", *ONLY)
    assert arm.read_bytes() == FIXED.encode()


def test_standard_input_comes_out_mended(kinlint, here, capsys, monkeypatch):
    """The text on standard output, the report aside."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(ARM.encode())))
    code, out, err = kinlint("-", "--stdin-filename", "arm.urdf", "--fix", *ONLY)

    assert (code, out) == (0, FIXED)
    assert "1 fixed" in err


def test_a_file_that_changed_meanwhile_is_not_overwritten(kinlint, arm, monkeypatch):
    """It is reported, with exit code 2."""
    mended = fix_files.fix_in_rounds

    def meanwhile(*given, **more):
        outcome = mended(*given, **more)
        arm.write_bytes(ARM.replace("base", "root").encode())
        return outcome

    monkeypatch.setattr(fix_files, "fix_in_rounds", meanwhile)
    code, out, err = kinlint("arm.urdf", "--fix", *ONLY)

    assert code == 2
    assert "the file has changed since it was read" in out + err
    assert b"root" in arm.read_bytes()


def test_a_file_that_cannot_be_written(kinlint, arm, monkeypatch):
    """An error that names the file, with exit code 2, and the file as it was."""

    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(files, "_new_file", refuse)
    code, out, err = kinlint("arm.urdf", "--fix", *ONLY)

    assert (code, arm.read_bytes()) == (2, ARM.encode())
    assert "arm.urdf: not fixed: Permission denied" in out + err


def test_a_file_that_is_read_only_stays_as_it_is(kinlint, arm):
    """Whoever runs kinlint, and though the directory lets it be replaced."""
    arm.chmod(0o444)
    code, out, err = kinlint("arm.urdf", "--fix", *ONLY)

    assert (code, arm.read_bytes()) == (2, ARM.encode())
    assert "arm.urdf: not fixed: the file is read-only" in out + err
    assert "1 fixed" not in out


LIMIT = """{{
  "@context": ["https://w3id.org/kinlint/composable.json", {{"ex": "https://example.org/{name}#"}}],
  "@id": "ex:limit", "@type": "JointPositionLimit", "quantity-kind": "Angle", "unit": "RAD", {said}
}}
"""


def test_files_that_are_fixed_together_are_written_together(kinlint, here):
    """If one cannot be written, the others stay as well; what is fixed apart is written."""
    files = {
        "low.jsonld": LIMIT.format(name="arm", said='"lower": 2.6'),
        "high.jsonld": LIMIT.format(name="arm", said='"upper": -2.6'),
        "other.jsonld": LIMIT.format(name="leg", said='"lower": 2.6, "upper": -2.6'),
    }
    for name, text in files.items():
        (here / name).write_text(text)
    (here / "low.jsonld").chmod(0o444)
    code, out, err = kinlint(*files, "--fix", *ONLY)

    assert code == 2
    assert "high.jsonld: not fixed: it changes together with low.jsonld" in out + err
    assert {name for name, text in files.items() if (here / name).read_text() != text} == {
        "other.jsonld"
    }
    (here / "low.jsonld").chmod(0o644)
    assert kinlint(*files, "--fix", *ONLY)[0] == 0
    assert '"upper": 2.6' in (here / "high.jsonld").read_text()


def test_a_file_that_cannot_be_read_keeps_no_other_from_being_fixed(kinlint, here):
    """Though all files that are composable make one model."""
    (here / "torn.jsonld").write_text("{ // no JSON\n}")
    low = here / "low.jsonld"
    low.write_text(LIMIT.format(name="arm", said='"lower": 2.60, "upper": -2'))

    assert kinlint("torn.jsonld", "low.jsonld", "--fix", *ONLY)[0] == 2
    assert '"lower": -2, "upper": 2.60' in low.read_text()


def test_links_and_modes_stay(kinlint, arm, here):
    """The linked file is mended, the link stays one."""
    arm.chmod(0o600)
    (here / "link.urdf").symlink_to("arm.urdf")
    kinlint("link.urdf", "--fix", *ONLY)

    assert (here / "link.urdf").is_symlink()
    assert (arm.read_bytes(), arm.stat().st_mode & 0o777) == (FIXED.encode(), 0o600)
    assert sorted(each.name for each in here.iterdir()) == ["arm.urdf", "link.urdf"]


def test_why_a_repair_is_not_offered_is_told_if_asked(kinlint, here):
    """Under `-v`."""
    text = ARM.replace('lower="2.60" upper="-2.6"', 'lower="${2.6}" upper="-2.6"')
    robot = text.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"')
    (here / "arm.urdf.xacro").write_text(robot)
    code, _, err = kinlint("arm.urdf.xacro", "-v", *ONLY)

    assert code == 1
    assert "LIM001 at arm.urdf.xacro:7:19 has no fix 'Swap the two limits': " in err


CIRCLE = """
@prefix at: <https://w3id.org/kinlint/attribute#> .
@prefix dash: <http://datashapes.org/dash#> .
@prefix kl: <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .

rule:circle-{number} a kl:Rule, sh:NodeShape ;
    kl:code "TST00{number}" ; rdfs:label "effort of {value}" ; rdfs:comment "A test." ;
    sh:severity sh:Warning ; sh:targetObjectsOf urdf:limit ;
    sh:sparql [ sh:message "Effort of {value}." ; sh:prefixes kl:prefixes ; sh:select '''
        SELECT $this (at:effort AS ?path) ?value {{
            $this at:effort ?value FILTER (?value = {value}) }}''' ] ;
    dash:suggestionGenerator [ a dash:SPARQLUpdateSuggestionGenerator ;
        rdfs:label "Write {other}" ; kl:applicability kl:unsafe ; sh:prefixes kl:prefixes ;
        rdfs:comment "It is a guess." ; sh:update '''DELETE {{ $this at:effort ?value }}
        INSERT {{ $this at:effort {other} }} WHERE {{ $this at:effort ?value }}''' ] .
"""


@pytest.mark.slow
def test_fixes_that_undo_each_other_are_not_made(kinlint, arm, here):
    """By two rules of the user; one line says which."""
    for number, value, other in ((1, "10.0", "20.0"), (2, "20.0", "10.0")):
        rule = CIRCLE.format(number=number, value=value, other=other)
        (here / f"circle-{number}.ttl").write_text(rule, "utf-8")
    rules = ("--rules", "circle-1.ttl", "--rules", "circle-2.ttl", "--select", "TST")
    code, _, err = kinlint("arm.urdf", "--fix", "--unsafe-fixes", *rules)

    assert (code, arm.read_bytes()) == (1, ARM.encode())
    assert err == (
        "kinlint: warning: fixes of TST001 and TST002 undo or feed each other; they were not made\n"
    )
