"""A database beside a stream, or SARIF in parts, is that of the whole report."""

import json
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from kinlint.cli.main import main

ROBOT = '<robot name="{0}"><link name="a"/><joint name="j"/></robot>'
QUERIES = (
    "SELECT * FROM file",
    "SELECT * FROM rule",
    "SELECT file, code, line, message FROM finding ORDER BY 1, 2, 3, 4",
    "SELECT * FROM unread",
)


@pytest.mark.slow
def test_findings_go_to_it_as_they_are_found_and_the_last_ones_as_well(
    tmp_path, monkeypatch, rules_cache
):
    monkeypatch.chdir(tmp_path)
    for number in range(20):
        (tmp_path / f"r{number}.urdf").write_text(ROBOT.format(f"r{number}"))
    (tmp_path / "unread.jsonld").write_bytes(b'\xff\xfe{\0"@id"')
    said = []
    for form in ("json-lines", "full"):
        main(["--isolated", "-n", "--output", form, "--output", "sqlite=found.db"])
        with closing(sqlite3.connect("found.db")) as made:
            said.append([made.execute(each).fetchall() for each in QUERIES])

    assert said[0] == said[1]
    assert all(said[0])


@pytest.mark.slow
@pytest.mark.parametrize("form", ["json-lines", "full"])
def test_sarif_in_parts_has_the_results_of_one_log(form, tmp_path, monkeypatch, rules_cache):
    """In their order; each part is a log, and what could not be read is told in the last."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("kinlint.reporters.sarif.sarif_parts.MOST", 15)
    for number in range(20):
        (tmp_path / f"r{number}.urdf").write_text(ROBOT.format(f"r{number}"))
    (tmp_path / "unread.jsonld").write_bytes(b'\xff\xfe{\0"@id"')
    main(["--isolated", "-n", "--output", form, "--output", "sarif=part-*.sarif"])
    main(["--isolated", "-n", "--output", "full", "--output", "sarif=whole.sarif"])
    logs = [json.loads(each.read_text())["runs"][0] for each in sorted(Path().glob("part-*"))]
    whole = json.loads(Path("whole.sarif").read_text())["runs"][0]
    ids = [[one["ruleId"] for one in each["results"]] for each in logs]
    assert [one for each in ids for one in each] == [one["ruleId"] for one in whole["results"]]
    assert max(map(len, ids)) == 15
    assert [each["invocations"][0]["executionSuccessful"] for each in logs[-2:]] == [True, False]
