"""`--baseline`, `--write-baseline`, `--prune-baseline`: what is known is not reported."""

import io
import json
import sys

import pytest

from kinlint.fixes.fix_generator import FixGenerator

LIMIT = '<limit lower="{}" upper="-2.6" effort="10" velocity="1"/>'
ARM = """\
<robot name="{name}">
  <link name="base"/><link name="hand"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
    {limit}
  </joint>
</robot>
"""
ONLY = ("--select", "LIM001,LNT", "--output-format", "concise")
NODE = """\
{ "@context": ["https://w3id.org/kinlint/composable.json", { "ex": "https://example.org/#" }],
  "@id": "ex:limit", "@type": "JointPositionLimit", "of-joint": "ex:joint",
  "quantity-kind": "Angle", "unit": "RAD", "lower": 1.5, "upper": -1.5 }
"""


def arm(name="arm", lower="2.6"):
    return ARM.format(name=name, limit=LIMIT.format(lower))


@pytest.fixture
def known(kinlint, write):
    """A baseline of two robots."""
    write("a ü,: 𝄞.urdf", arm("a"))
    write("b.urdf", arm("b"))
    assert kinlint("--write-baseline", *ONLY)[0] == 0


def said(here):
    return json.loads((here / "kinlint-baseline.json").read_text("utf-8"))


@pytest.mark.slow
def test_it_is_sorted_json_that_differs_where_findings_do(kinlint, known, here):
    """The same from everywhere, whatever the order of the files."""
    text = (here / "kinlint-baseline.json").read_bytes()
    assert said(here)["version"] == 1
    first = said(here)["findings"][0]
    assert list(first) == ["path", "rule", "entity", "message", "fingerprint"]
    assert [each["path"] for each in said(here)["findings"]] == ["a ü,: 𝄞.urdf", "b.urdf"]
    assert first["entity"] == "a ü,: 𝄞.urdf#/joint/elbow/position-limit"
    assert text.endswith(b"}\n")
    assert str(here).encode() not in text

    kinlint("b.urdf", "a ü,: 𝄞.urdf", "--write-baseline", *ONLY)
    assert (here / "kinlint-baseline.json").read_bytes() == text


def test_what_is_known_is_counted_and_not_reported(kinlint, known, write):
    """Moved, re-indented and with other line ends it is known all the same."""
    text = ("\n\n<!-- moved -->" + arm("a").replace("  ", "\t")).replace("\n", "\r\n")
    write("a ü,: 𝄞.urdf", text)
    write("c.urdf", arm("c"))
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *ONLY)
    assert code == 1
    assert [line.partition(":")[0] for line in out.splitlines()[:-1]] == ["c.urdf"]
    assert "2 in the baseline" in out


def test_from_another_directory(kinlint, known, here, monkeypatch):
    """Paths start where the baseline lies."""
    (here / "sub").mkdir()
    monkeypatch.chdir(here / "sub")
    assert kinlint("..", "--baseline", "../kinlint-baseline.json", *ONLY)[0] == 0


@pytest.mark.slow
def test_a_renamed_robot_is_known(kinlint, known, here, write):
    """Where its file is gone; a copy is new."""
    (here / "b.urdf").rename(here / "renamed.urdf")
    assert kinlint("--baseline", "kinlint-baseline.json", *ONLY)[0] == 0
    write("b.urdf", arm("b"))
    assert kinlint("--baseline", "kinlint-baseline.json", *ONLY)[0] == 1


def test_the_entry_of_a_file_that_is_gone_knows_it_first(kinlint, known, here, write):
    """Where others have an entry that is equal but for the file, and is found no more."""
    write("a ü,: 𝄞.urdf", arm("a", "-3"))
    (here / "b.urdf").rename(here / "renamed.urdf")
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *ONLY)
    assert (code, out.count("\n")) == (1, 2)
    assert "'a ü,: 𝄞.urdf#/joint/elbow/position-limit', which is no longer found" in out


@pytest.mark.slow
def test_of_a_file_that_is_gone_all_is_found_no_more(kinlint, known, here):
    """If the run searched where it lay."""
    (here / "b.urdf").unlink()
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *ONLY)
    assert (code, out.count("no longer found")) == (1, 1)
    only_a = ("a ü,: 𝄞.urdf", "--baseline", "kinlint-baseline.json", *ONLY)
    assert kinlint(*only_a)[0] == 0
    assert kinlint("--in-project", *only_a)[0] == 0
    kinlint("--write-baseline", *ONLY)
    assert [each["path"] for each in said(here)["findings"]] == ["a ü,: 𝄞.urdf"]


def test_an_entity_is_the_same_in_another_file(kinlint, here, write):
    """If it has an IRI of its own."""
    write("one.jsonld", NODE)
    kinlint("--write-baseline", *ONLY)
    (here / "one.jsonld").unlink()
    write("sub/two.jsonld", NODE)
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *ONLY)
    assert (code, "1 in the baseline" in out) == (0, True)


@pytest.mark.slow
def test_an_entity_is_the_same_however_it_is_abbreviated(kinlint, here, write):
    """A name that others have, too, is written with its kind; a prefix is as good as any."""
    write("a.urdf", arm("a"))
    write("b.jsonld", NODE)
    kinlint("--write-baseline", *ONLY)
    write("a.urdf", arm("a").replace("<link name", '<link name="elbow"/><link name', 1))
    write("b.jsonld", NODE.replace('"ex', '"other'))
    for path in (here / "a.urdf", here / "b.jsonld"):
        code, out, _ = kinlint(path.name, "--baseline", "kinlint-baseline.json", *ONLY)
        assert (code, "1 in the baseline" in out) == (0, True), out


def test_equal_findings_count(kinlint, here, write):
    """Each entry knows one of them."""
    double = f"<joint name='elbow' type='revolute'>{LIMIT.format('2.6')}</joint>"
    write("a.urdf", f"<robot name='a'><link name='l'/>{double}</robot>")
    kinlint("--write-baseline", *ONLY)
    path = here / "kinlint-baseline.json"
    listed = said(here)
    listed["findings"] *= 2
    path.write_text(json.dumps(listed), "utf-8")
    code, out, _ = kinlint("--baseline", path.name, *ONLY)
    assert (code, out.count("is no longer found")) == (1, 1)


def test_what_is_found_no_more_is_reported(kinlint, known, write):
    """At its place in the baseline, as a suppression that silences nothing."""
    write("b.urdf", arm("b", "-3"))
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *ONLY)
    assert code == 1
    assert out.startswith(
        "kinlint-baseline.json:14:17: warning: The baseline lists 'LIM001' for"
        " 'b.urdf#/joint/elbow/position-limit', which is no longer found. [LNT001]\n"
    )
    assert kinlint("--baseline", "kinlint-baseline.json", "--fail-on", "error", *ONLY)[0] == 0
    assert kinlint("--baseline", "kinlint-baseline.json", "--ignore", "LNT", *ONLY)[0] == 0


@pytest.mark.parametrize(
    "arguments",
    [("a ü,: 𝄞.urdf",), ("--ignore", "LIM001"), ("--partial",), ("--exclude", "b.urdf")],
)
def test_nothing_is_said_of_what_was_not_looked_at(kinlint, known, write, arguments):
    """Other files, rules that are silent, and parts of a model."""
    write("b.urdf", arm("b", "-3"))
    code, out, _ = kinlint(*arguments, "--baseline", "kinlint-baseline.json", *ONLY)
    assert (code, "no longer found" in out) == (0, False)


@pytest.mark.slow
def test_pruning_drops_what_is_found_no_more(kinlint, known, here, write):
    """And what was of files that are gone; what is new does not become known."""
    write("b.urdf", arm("b", "-3"))
    write("c.urdf", arm("c"))
    code, _, err = kinlint("--prune-baseline", *ONLY)
    assert (code, "1 stale entry dropped" in err) == (1, True)
    assert [each["path"] for each in said(here)["findings"]] == ["a ü,: 𝄞.urdf"]
    (here / "c.urdf").unlink()
    (here / "a ü,: 𝄞.urdf").unlink()
    kinlint("--prune-baseline", *ONLY)
    assert said(here)["findings"] == []


def test_writing_keeps_what_was_not_looked_at(kinlint, known, here, write):
    """So that a run over a part of the files loses nothing."""
    write("b.urdf", arm("b", "-3"))
    kinlint("b.urdf", "--write-baseline", *ONLY)
    assert [each["path"] for each in said(here)["findings"]] == ["a ü,: 𝄞.urdf"]


def test_the_configuration_names_it(kinlint, known, here, write):
    """From its own directory; it may not be there yet when it is written."""
    write("kinlint.toml", 'baseline = "known/base line.json"\n')
    code, _, err = kinlint(*ONLY)
    assert (code, "kinlint.toml: baseline: known/base line.json" in err) == (2, True)
    (here / "known").mkdir()
    assert kinlint("--write-baseline", *ONLY)[0] == 0
    assert kinlint(*ONLY)[0] == 0


@pytest.mark.parametrize("form", ["full", "json", "sarif", "github", "rdjson", "turtle", "gitlab"])
def test_every_format(kinlint, known, write, form):
    """Tells what is new and nothing else."""
    write("c.urdf", arm("c"))
    options = ("--select", "LIM001", "--baseline", "kinlint-baseline.json")
    code, out, _ = kinlint(*options, "--output-format", form)
    assert (code, "c.urdf" in out, "b.urdf" in out) == (1, True, False)


def test_sarif_says_of_each_result_that_it_is_new(kinlint, known, write):
    """Or of none, where nothing was compared."""
    write("c.urdf", arm("c"))
    options = ("--select", "LIM001", "--output-format", "sarif")
    found = json.loads(kinlint(*options, "--baseline", "kinlint-baseline.json")[1])
    assert [each["baselineState"] for each in found["runs"][0]["results"]] == ["new"]
    found = json.loads(kinlint(*options)[1])
    assert not any("baselineState" in each for each in found["runs"][0]["results"])


@pytest.mark.slow
def test_standard_input_processes_and_fixes(kinlint, known, here, write, monkeypatch):
    """All go by it; `--fix` leaves what is known."""
    options = ("--baseline", "kinlint-baseline.json", *ONLY)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(arm("b").encode())))
    assert kinlint("-", "--stdin-filename", "b.urdf", *options)[0] == 0
    assert kinlint("-j", "2", *options)[0] == 0
    new = write("c.urdf", arm("c"))
    assert kinlint("--fix", "--unsafe-fixes", *options)[0] == 0
    assert (here / "b.urdf").read_text("utf-8") == arm("b")
    assert new.read_text("utf-8") != arm("c")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "--baseline: base.json: no such file or directory"),
        ("", "--baseline: base.json:1:1: the file is empty"),
        ("{\n<<<<<<< HEAD", "--baseline: base.json:2:1: not JSON"),
        ("[]", "--baseline: base.json:1:1: not a baseline"),
        ('{"version": 2, "findings": []}', "base.json:1:1: expected version 1"),
        ('{"version": 1, "findings": 3}', "base.json:1:1: findings: expected an array"),
        ('{"version": 1,\n"findings": [1]}', "base.json:2:14: expected a finding"),
        ('{"version": 1,\n"findings": [{}]}', "base.json:2:14: a finding without 'path'"),
        (b"\xff\xfe\x00\xd8", "base.json"),
    ],
)
def test_what_is_no_baseline(kinlint, here, write, text, said):
    """File, place and cause; exit code 2."""
    write("a.urdf", arm())
    if isinstance(text, bytes):
        (here / "base.json").write_bytes(text)
    elif text is not None:
        write("base.json", text)
    code, _, err = kinlint("--baseline", "base.json", *ONLY)
    assert (code, said in err) == (2, True), err


@pytest.mark.slow
def test_nothing_is_written_of_files_that_cannot_be_read(kinlint, known, here, write):
    """The old baseline stays."""
    before = (here / "kinlint-baseline.json").read_bytes()
    code, _, err = kinlint("--write-baseline", ".", "missing.urdf", *ONLY)
    assert (code, "not written: 1 file could not be read" in err) == (2, True)
    assert (here / "kinlint-baseline.json").read_bytes() == before


def test_it_is_no_place_for_a_report(kinlint, known):
    """Which would be lost."""
    options = ("--baseline", "kinlint-baseline.json", "-o", "kinlint-baseline.json")
    code, _, err = kinlint(*options, *ONLY)
    assert (code, "would be lost" in err) == (2, True)


@pytest.mark.slow
def test_a_part_of_a_model_accuses_nothing_that_others_may_say(kinlint, here, write):
    """What is found of an IRI may depend on files that were not given this time."""
    write("one.jsonld", NODE)
    same, other = NODE.replace("1.5", "1.25"), NODE.replace("ex:limit", "ex:other")
    write("two.jsonld", f"[{same}, {other}]")
    options = ("--select", "ID004,LIM001,LNT", "--output-format", "concise")
    assert kinlint("--write-baseline", *options)[0] == 0
    assert any(each["rule"] == "ID004" for each in said(here)["findings"])
    code, out, _ = kinlint("one.jsonld", "--baseline", "kinlint-baseline.json", *options)
    assert "no longer found" not in out
    (here / "two.jsonld").unlink()
    code, out, _ = kinlint("--baseline", "kinlint-baseline.json", *options)
    assert (code, "no longer found" in out) == (1, True)


@pytest.mark.slow
def test_a_part_accuses_nothing_where_the_other_file_has_no_findings(kinlint, here, write):
    """The limit is below the joint's only as long as the file of the joint is there."""
    joint = '{ "@id": "ex:joint", "@type": ["Joint", "PrismaticJoint"] }'
    head = NODE[: NODE.index('"@id"')]
    write("joint.jsonld", f'{head} "@graph": [{joint}] }}')
    write("limit.jsonld", NODE.replace("1.5", "-3", 1))
    options = ("--select", "UNI,LIM,LNT", "--output-format", "concise")
    assert kinlint("--write-baseline", *options)[0] == 0
    assert {each["path"] for each in said(here)["findings"]} == {"limit.jsonld"}
    assert said(here)["composed"] == ["joint.jsonld", "limit.jsonld"]
    assert "no longer found" not in kinlint("limit.jsonld", *known_as(), *options)[1]
    assert "no longer found" not in kinlint(*known_as(), *options)[1]

    (here / "joint.jsonld").unlink()
    assert "no longer found" in kinlint(*known_as(), *options)[1]


def known_as():
    return "--baseline", "kinlint-baseline.json"


@pytest.mark.slow
def test_fixes_are_proven_of_what_is_new(kinlint, known, write, monkeypatch):
    """Of the robot that has something new; and nothing is tried where nothing is."""
    tried = []

    def noted(self, findings, least):
        tried.extend(each.location.source.name for each in findings)
        return candidates(self, findings, least)

    candidates = FixGenerator.candidates
    monkeypatch.setattr(FixGenerator, "candidates", noted)
    full = (
        "--select",
        "LIM001",
        "--baseline",
        "kinlint-baseline.json",
        "--jobs",
        "1",
        "--no-cache",
    )
    assert kinlint(*full)[0] == 0
    assert tried == []

    second = LIMIT.format("3.1").join(('<joint name="wrist" type="revolute">', "</joint>"))
    second = second.replace("<limit", '<parent link="hand"/><child link="tip"/><limit')
    write("b.urdf", arm("b").replace("</robot>", f'<link name="tip"/>{second}</robot>'))
    code, out, _ = kinlint(*full)

    assert (code, tried) == (1, ["b.urdf"])
    assert "Swap the two limits" in out
    assert "1 can be fixed" in out
