"""A Dask cluster: its report is that of one process, whatever becomes of its workers."""

from __future__ import annotations

import re

import pytest

from kinlint.cli.main import main

dask = pytest.importorskip("dask")
distributed = pytest.importorskip("distributed")
pytestmark = pytest.mark.slow

ROBOT = '<robot name="{0}"><link name="a"/><joint name="j"><parent link="a"/></joint></robot>'
COUNT = 40
POISONED = """
import os, pathlib
from kinlint.parallel import shard

lint_shard = getattr(shard, "immortal", shard.lint_shard)

def mortal(models, *arguments):
    names = [each.name for model in models for each in model]
    mark = pathlib.Path({marker!r})
    if {poison!r} in names:
        os._exit(1)
    if "r20.urdf" in names and not mark.exists():
        mark.touch()
        os._exit(1)
    return lint_shard(models, *arguments)

shard.immortal, shard.lint_shard = lint_shard, mortal
"""
"""Ends a worker once in the middle of the run, and with each task that has the poisonous file."""


@pytest.fixture
def robots(tmp_path, monkeypatch):
    """A directory of robots."""
    directory = tmp_path / "robots"
    directory.mkdir()
    monkeypatch.chdir(directory)
    for number in range(COUNT):
        (directory / f"r{number}.urdf").write_text(ROBOT.format(f"r{number}"))
    return directory


@pytest.fixture
def address(tmp_path, monkeypatch):
    """A function that starts a cluster of two workers, given the name of a poisonous file."""
    clusters = []

    def start(poison: str) -> str:
        preload = tmp_path / "preload.py"
        preload.write_text(POISONED.format(marker=str(tmp_path / "killed"), poison=poison))
        with dask.config.set({"distributed.scheduler.allowed-failures": 1}):
            cluster = distributed.LocalCluster(
                n_workers=2, threads_per_worker=1, dashboard_address=":0", preload=[str(preload)]
            )
        clusters.append(cluster)
        return cluster.scheduler_address.replace("tcp://", "dask://")

    yield start
    for each in clusters:
        each.close()


def said(capsys, *arguments: str) -> tuple[int, str]:
    """Return the exit code and the output of a run without configuration."""
    capsys.readouterr()
    code = main([".", "--isolated", "--output-format", "json", *arguments])
    return code, re.sub(r'"seconds": [\d.]+', "", capsys.readouterr().out)


def test_a_cluster_that_loses_workers_reports_what_one_process_does(
    robots, address, capsys, tmp_path, monkeypatch
):
    """One is lost in the middle of the run; what was linted before is recalled by the next."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(tmp_path / "cache"))
    alone = said(capsys, "--no-cache")
    cluster = address("")
    assert said(capsys, "--no-cache", "--executor", cluster) == alone
    assert (tmp_path / "killed").exists()
    assert said(capsys, "--executor", cluster) == alone
    assert said(capsys, "--executor", "dask://127.0.0.1:1") == alone


def test_a_file_that_ends_workers_is_an_error_of_its_own(robots, address, capsys):
    cluster = address("r7.urdf")
    code, told = said(capsys, "--no-cache", "--executor", cluster)
    assert code == 2
    assert told.count("each worker that linted it was lost") == 1
    (robots / "r7.urdf").unlink()
    for number in range(COUNT):
        assert f"r{number}.urdf" in told, number
