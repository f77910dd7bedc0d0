"""A Dask cluster: its report is that of one process."""

from __future__ import annotations

import re

import pytest

from kinlint.cli.main import main

distributed = pytest.importorskip("distributed")
pytestmark = pytest.mark.slow

ROBOT = '<robot name="{0}"><link name="a"/><joint name="j"><parent link="a"/></joint></robot>'
COUNT = 20


def said(capsys, *arguments: str) -> tuple[int, str]:
    """Return the exit code and the output of a run without configuration."""
    capsys.readouterr()
    code = main([".", "--isolated", "--output-format", "json", *arguments])
    return code, re.sub(r'"seconds": [\d.]+', "", capsys.readouterr().out)


def test_a_cluster_reports_what_one_process_does(tmp_path, monkeypatch, rules_cache, capsys):
    """What was linted is recalled by the next run, even if nobody is there any more."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(tmp_path / "cache"))
    directory = tmp_path / "robots"
    directory.mkdir()
    monkeypatch.chdir(directory)
    for number in range(COUNT):
        (directory / f"r{number}.urdf").write_text(ROBOT.format(f"r{number}"))
    alone = said(capsys, "--no-cache")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=":0"
    ) as cluster:
        address = cluster.scheduler_address.replace("tcp://", "dask://")
        assert said(capsys, "--executor", address) == alone
    assert said(capsys, "--executor", "dask://127.0.0.1:1") == alone
