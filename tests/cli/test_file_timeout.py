"""A file that takes too long is reported, and makes no others wait."""

import json
import os
import sys
import time
from multiprocessing import active_children
from pathlib import Path

import pytest

from kinlint.cli.main import main
from kinlint.configuration.keys import KEYS
from kinlint.parallel import shard, timed_processes

LIMIT = "0.5"
GOOD = '<robot name="r"><link name="a"/><lnk name="b"/></robot>'


def forever():
    """Wait in native code, where no signal handler of Python runs."""
    time.sleep(3600)


def never_ends(models):
    texts = [source.text for model in models for source in model]
    together = sum("SLOW TOGETHER" in each for each in texts)
    return together > 1 or any("FOREVER" in each for each in texts)


@pytest.fixture
def here(tmp_path, rules_cache, monkeypatch):
    """Robots, and a linter that never answers where a text says so.

    What it answers has all the time that it needs, whatever the machine is busy with.
    """
    monkeypatch.chdir(tmp_path)
    lint, give = shard.lint_shard, timed_processes._Worker.give

    def stubborn(models, *arguments):
        if never_ends(models):
            forever()
        if any("CRASH" in source.text for model in models for source in model):
            os._exit(9)
        return lint(models, *arguments)

    def patient(worker, task, seconds):
        give(worker, task, seconds if never_ends(task.models) else 600.0)

    monkeypatch.setattr(shard, "lint_shard", stubborn)
    monkeypatch.setattr(timed_processes._Worker, "give", patient)
    for number in range(3):
        (tmp_path / f"r{number}.urdf").write_text(GOOD)
    return tmp_path


def said(capsys, *arguments):
    """The exit code, and the places and codes of findings and errors."""
    capsys.readouterr()
    code = main([".", "--isolated", "--no-cache", "--output-format", "json", *arguments])
    report = json.loads(capsys.readouterr().out)
    found = [(Path(each["filename"]).name, each["code"], each["message"]) for each in report]
    return code, [each for each in found if each[1]], [each for each in found if not each[1]]


@pytest.mark.slow
@pytest.mark.parametrize("jobs", ["1", "3"])
def test_one_error_and_the_findings_of_the_others(here, capsys, jobs):
    """Whatever it is busy with, in one process or several; none of them is left."""
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    without, findings, _ = said(capsys, "--exclude", "evil.urdf")
    assert (without, bool(findings)) == (1, True)

    code, found, errors = said(capsys, "--file-timeout", LIMIT, "-j", jobs)

    assert (code, found) == (2, findings)
    assert [name for name, *_ in errors] == ["evil.urdf"]
    assert f"not linted within {LIMIT} s (--file-timeout)" in errors[0][2]
    assert not active_children()


@pytest.mark.slow
def test_a_limit_that_holds_changes_nothing(here, capsys):
    """Not one finding."""
    assert said(capsys, "--file-timeout", "300") == said(capsys)


@pytest.mark.slow
def test_a_slow_file_of_a_model_is_as_good_as_unreadable(here, capsys):
    """The other files of the model are judged without it."""
    for number in range(3):
        (here / f"r{number}.urdf").unlink()
    node = '{"@context": {"ex": "https://x.example/"}, "@id": "ex:%s", "ex:p": "x", "%s": 1}'
    (here / "good.jsonld").write_text(node % ("a", "nothing"))
    (here / "evil.jsonld").write_text(node % ("b", "FOREVER"))

    code, found, errors = said(capsys, "--file-timeout", LIMIT)

    assert code == 2
    assert {name for name, *_ in found} == {"good.jsonld"}
    assert [name for name, *_ in errors] == ["evil.jsonld"]


@pytest.mark.slow
def test_files_that_are_slow_only_together_are_all_reported(here, capsys):
    """None of them is to blame alone."""
    for number in range(3):
        (here / f"r{number}.urdf").unlink()
    for name in ("a", "b"):
        text = '{"@context": {}, "@id": "https://x.example/%s", "SLOW TOGETHER": 1}'
        (here / f"{name}.jsonld").write_text(text % name)

    code, _, errors = said(capsys, "--file-timeout", "1")

    assert code == 2
    assert [name for name, *_ in errors] == ["a.jsonld", "b.jsonld"]
    assert all("checked with 1 other" in message for _, _, message in errors)


def test_a_process_that_ends_is_reported(here, capsys):
    """Such as one that the system kills because of its memory."""
    (here / "evil.urdf").write_text(GOOD.replace("r", "CRASH"))

    code, found, errors = said(capsys, "--file-timeout", "30")

    assert (code, bool(found)) == (2, True)
    assert [name for name, *_ in errors] == ["evil.urdf"]
    assert "ended with 9" in errors[0][2]


@pytest.mark.slow
def test_what_is_too_slow_is_not_fixed(here, capsys):
    """The others are."""
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    before = (here / "evil.urdf").read_bytes()

    code, _, errors = said(capsys, "--file-timeout", LIMIT, "--fix", "--unsafe-fixes")

    assert (code, [name for name, *_ in errors]) == (2, ["evil.urdf"])
    assert (here / "evil.urdf").read_bytes() == before
    assert all("<lnk" not in (here / f"r{number}.urdf").read_text() for number in range(3))


@pytest.mark.slow
def test_what_is_too_slow_is_not_silenced(here, capsys, monkeypatch):
    """Comments are written into the others, by rounds that are limited themselves."""
    from kinlint.parallel import runner  # noqa: PLC0415

    monkeypatch.setattr(runner.ParallelRunner, "report", None)
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    before = (here / "evil.urdf").read_bytes()

    code, found, errors = said(capsys, "--file-timeout", LIMIT, "--add-ignore=known")

    assert (code, found, [name for name, *_ in errors]) == (2, [], ["evil.urdf"])
    assert (here / "evil.urdf").read_bytes() == before
    assert all("ignore[SRC003]" in (here / f"r{number}.urdf").read_text() for number in range(3))


@pytest.mark.slow
def test_a_file_that_was_too_slow_is_tried_again(here, tmp_path_factory, capsys, monkeypatch):
    """It is not among the reports that are kept, as those of the others are."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(tmp_path_factory.mktemp("cache")))
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    assert main([".", "--isolated", "-v", "--file-timeout", LIMIT]) == 2
    monkeypatch.setattr(sys.modules[__name__], "never_ends", lambda _: False)
    capsys.readouterr()
    assert main([".", "--isolated", "-v", "--file-timeout", "300"]) == 1
    assert "recalled: 3 " in capsys.readouterr().err


@pytest.mark.slow
def test_the_configuration_sets_it(here, capsys):
    """The command line wins, also with 0, which is no limit."""
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    (here / "kinlint.toml").write_text("file-timeout = 1\n")
    assert main([".", "-q", "--no-cache"]) == 2
    assert "within 1 s" in capsys.readouterr().out
    for given, told in (
        ((), "1"),
        (("--file-timeout", "0"), "0"),
        (("--file-timeout=7.5",), "7.5"),
    ):
        main([".", "--show-settings", *given])
        assert f"file-timeout = {told}\n" in capsys.readouterr().out


@pytest.mark.parametrize("value", [True, -1, "60", float("nan"), float("inf"), 1e12])
def test_a_limit_is_a_number_of_seconds(value):
    """From 0 up, and one that a clock can hold."""
    assert KEYS["file-timeout"].kind.problem(value)
    assert not KEYS["file-timeout"].kind.problem(0.5)


@pytest.mark.slow
def test_fixing_is_limited_and_lints_once(here, capsys, monkeypatch):
    """The rounds themselves run in time, and what they find is what a run without limit finds."""
    from kinlint.parallel import runner  # noqa: PLC0415

    monkeypatch.setattr(runner.ParallelRunner, "report", None)
    (here / "a").mkdir()
    for name in ("r0.urdf", "r1.urdf", "a/r2.urdf"):
        (here / name).write_text(GOOD)
    limited = said(capsys, "--file-timeout", "300", "--fix", "--unsafe-fixes")
    texts = {path: path.read_text() for path in here.rglob("*.urdf")}
    for path in texts:
        path.write_text(GOOD)
    free = said(capsys, "--fix", "--unsafe-fixes")
    assert (limited, texts) == (free, {path: path.read_text() for path in texts})
    assert all("<lnk" not in text for text in texts.values())


@pytest.mark.slow
def test_recognising_a_file_is_limited(here, capsys, monkeypatch):
    """Before any process reads it."""
    from kinlint.project import reading  # noqa: PLC0415

    known = reading.is_model

    def stubborn(source, own=()):
        while "FOREVER" in source.text:
            pass
        return known(source, own)

    monkeypatch.setattr(reading, "is_model", stubborn)
    (here / "evil.urdf").write_text(GOOD.replace("r", "FOREVER"))
    code, found, errors = said(capsys, "--file-timeout", LIMIT)
    assert (code, bool(found)) == (2, True)
    assert [name for name, *_ in errors] == ["evil.urdf"]
    assert "not read within" in errors[0][2]
