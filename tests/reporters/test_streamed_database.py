"""A database beside a stream is that of the whole report."""

import sqlite3
from contextlib import closing

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
