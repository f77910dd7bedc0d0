"""Errors in kinlint itself: told of one file, while the others are linted, and reported."""

from __future__ import annotations

import pytest

from kinlint.cli.bug_report import anonymised
from kinlint.pipeline.analyzer import Analyzer

READ = Analyzer._read

ARM = """<robot name="acme_secret_arm">
  <link name="base"/>
  <link name="acme_forearm">
    <inertial><mass value="12.5"/></inertial>
  </link>
  <material name="cursed"/>
</robot>
"""


@pytest.fixture
def cursed(monkeypatch):
    """Have kinlint fail at one word."""

    def fail(self, source, options):
        if "<material" in source.text:
            raise ZeroDivisionError("no such luck")
        return READ(self, source, options)

    monkeypatch.setattr(Analyzer, "_read", fail)
    monkeypatch.delenv("KINLINT_TRACEBACK", raising=False)


@pytest.fixture
def robots(write):
    write("a.urdf", ARM)
    write("b.urdf", '<robot name="b"><link name="l"/><joint name="j" type="fixed"/></robot>')


@pytest.mark.parametrize("output", ["concise", "json", "full"])
def test_the_other_files_are_linted(cursed, robots, kinlint, output):
    code, out, err = kinlint("a.urdf", "b.urdf", "--output-format", output)
    assert code == 2
    assert "a.urdf" in out + err
    assert "ZeroDivisionError: no such luck" in out + err
    assert "kinlint --report-bug a.urdf" in out + err
    assert "SRC011" in out


def test_it_is_not_recalled(cursed, robots, kinlint, monkeypatch):
    assert kinlint("a.urdf")[0] == 2
    monkeypatch.setattr(Analyzer, "_read", READ)
    assert kinlint("a.urdf")[0] != 2


def test_a_traceback_may_be_asked_for(cursed, robots, kinlint, monkeypatch):
    monkeypatch.setenv("KINLINT_TRACEBACK", "1")
    with pytest.raises(ZeroDivisionError):
        kinlint("a.urdf")


@pytest.mark.slow
def test_a_reproducer_is_small_and_has_no_names(cursed, robots, kinlint, here):
    _, _, err = kinlint("a.urdf", "b.urdf", "--report-bug", "bug")
    assert "wrote bug/bug-1.urdf: ZeroDivisionError" in err.replace("\\", "/")
    text = (here / "bug" / "bug-1.urdf").read_text("utf-8")
    assert "<material" in text
    assert "acme" not in text
    assert "12.5" not in text
    assert "ZeroDivisionError" in (here / "bug" / "bug-1.urdf.txt").read_text("utf-8")
    assert len(list((here / "bug").iterdir())) == 2


def test_nothing_is_written_where_nothing_fails(robots, kinlint, here):
    _, _, err = kinlint("b.urdf", "--report-bug", "bug")
    assert "no file makes kinlint fail" in err
    assert not (here / "bug").exists()


def test_words_of_the_formats_stay():
    assert anonymised('<joint name="acme" type="revolute">') == '<joint name="n1" type="revolute">'
    assert anonymised("acme/x acme") == anonymised("evil/x evil")
