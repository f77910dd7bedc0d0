"""Formats of one finding a line begin before the last file is linted, and end the same."""

from __future__ import annotations

import pytest

from kinlint.cli.report_outputs import Outputs
from kinlint.parallel import partition, shard

ROBOT = """<robot name="{name}">{extra}
  <link name="base"/><link name="tip"/>
  <joint name="wrist" type="revolute">
    <parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
    <limit lower="2" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
INCLUDE = '<xacro:include filename="{}"/>'
XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro" name'
UNUSED = "<!-- kinlint: ignore[UNI001] no such finding -->"
FLEETS = {
    "robots": {f"r{number}.urdf": ROBOT.format(name=number, extra="") for number in range(9)},
    "a file that cannot be read": {
        **{f"r{number}.urdf": ROBOT.format(name=number, extra=UNUSED) for number in range(5)},
        "s.urdf": "<robot name='s'><link",
    },
    "suppressions that are unused": {
        f"r{number}.urdf": ROBOT.format(name=number, extra=UNUSED if number % 2 else "")
        for number in range(7)
    },
    "an included file": {
        **{f"r{number}.urdf": ROBOT.format(name=number, extra="") for number in range(5)},
        "z.xacro": ROBOT.format(name="z", extra=INCLUDE.format("b/part.xml")).replace(
            "name", XACRO, 1
        ),
        "b/part.xml": ROBOT.format(name="part", extra="").replace("name", XACRO, 1),
    },
    "a composable model": {
        "a.urdf": ROBOT.format(name="a", extra=""),
        "b.jsonld": '{"@context": {"ex": "https://example.org/#"}, "@id": "ex:b", "ex:c": {}}',
    },
}
EARLY = ("concise", "json-lines", "rdjsonl")
ALONE = ("--isolated", "--no-cache", "--jobs=1")
RUNS = (
    (*ALONE, "--output-format=concise", "--show=info"),
    ("--isolated", "--no-cache", "--jobs=2", "--output-format=json-lines"),
    ("--jobs=1", "--output-format=rdjsonl"),
)


@pytest.fixture
def shares(monkeypatch, capsys):
    """What was written when each share was about to be linted; a share is of two models."""
    written: list[str] = []
    lint = shard.lint_shard

    def linting(*given):
        written.append(capsys.readouterr().out)
        return lint(*given)

    monkeypatch.setattr(partition, "MOST", 2)
    monkeypatch.setattr(shard, "lint_shard", linting)
    return written


@pytest.mark.slow
@pytest.mark.parametrize("form", EARLY)
def test_findings_are_written_before_the_last_file_is_linted(kinlint, write, shares, form):
    fleet = FLEETS["robots"]
    for name, text in fleet.items():
        write(name, text)
    code, rest, _ = kinlint(*ALONE, "-q", f"--output-format={form}")

    assert code == 1
    assert len(shares) == 5
    for number, (before, after) in enumerate(zip(shares, [*shares[1:], rest], strict=True)):
        assert before == "" or number > 0
        names = [f"r{each}.urdf" for each in range(9) if f"r{each}.urdf" in after]
        assert names == sorted(fleet)[2 * number : 2 * number + 2]


@pytest.mark.slow
@pytest.mark.parametrize("title", FLEETS)
@pytest.mark.parametrize("given", RUNS, ids=" ".join)
def test_the_whole_is_as_if_written_at_the_end(kinlint, write, monkeypatch, title, given):
    """Also where findings depend on files that are read later, and where reports are recalled."""
    for name, text in FLEETS[title].items():
        write(name, text)
    monkeypatch.setattr(partition, "MOST", 2)
    early = [kinlint(*given) for _ in range(2)]
    monkeypatch.setattr(Outputs, "begins_early", False)
    late = kinlint(*given)

    assert late[1]
    assert early == [late, late]


@pytest.mark.slow
def test_other_outputs_wait(kinlint, write, shares):
    for name, text in FLEETS["robots"].items():
        write(name, text)
    for option in ("--output-format=github", "--statistics", "--show-suppressed", "--in-project"):
        shares.clear()
        kinlint(*ALONE, "--output-format=concise", option)
        assert shares
        assert not any(shares)
