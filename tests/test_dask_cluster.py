"""A Dask cluster: its report is that of one process."""

from __future__ import annotations

import os
import re
import signal
from contextlib import contextmanager
from pathlib import Path
from threading import Thread
from time import sleep

import pytest

from kinlint.cli.main import main

pytestmark = pytest.mark.slow

ROBOT = '<robot name="{0}"><link name="a"/><joint name="j"><parent link="a"/></joint></robot>'
COUNT = 20
DEADLY = """
import os, signal

def dask_setup(worker):
    from kinlint.formats import registry

    read = registry.read

    def deadly(source, options):
        if source.name == "poison.urdf":
            os.kill(os.getpid(), signal.SIGKILL)
        return read(source, options)

    registry.read = deadly
"""
"""Has the worker that reads `poison.urdf` end at once."""


def said(capsys, *arguments: str) -> tuple[int, str]:
    """Return the exit code and the output of a run without configuration."""
    capsys.readouterr()
    code = main([".", "--isolated", "--output-format", "json", *arguments])
    return code, re.sub(r'"seconds": [\d.]+', "", capsys.readouterr().out)


@pytest.fixture
def robots(tmp_path, monkeypatch, rules_cache):
    """Makes the working directory one of robots with faults."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(tmp_path / "cache"))
    directory = tmp_path / "robots"
    directory.mkdir()
    monkeypatch.chdir(directory)
    for number in range(COUNT):
        (directory / f"r{number}.urdf").write_text(ROBOT.format(f"r{number}"))


@contextmanager
def workers(failures=3, **more):
    """Two workers, each in a process that is started again when it ends, however long it takes.

    What more than so many *failures* of workers were at is given up.
    """
    distributed = pytest.importorskip("distributed")
    patient = {
        "distributed.deploy.lost-worker-timeout": "1 hour",
        "distributed.scheduler.allowed-failures": failures,
    }
    with (
        pytest.importorskip("dask").config.set(patient),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=":0", **more
        ) as found,
    ):
        yield found


@pytest.fixture
def cluster(robots):
    with workers() as found:
        yield found


def address(cluster) -> str:
    return cluster.scheduler_address.replace("tcp://", "dask://")


def test_a_cluster_reports_what_one_process_does(cluster, capsys):
    """What was linted is recalled by the next run, even if nobody is there any more."""
    alone = said(capsys, "--no-cache")

    assert said(capsys, "--executor", address(cluster)) == alone
    assert said(capsys, "--executor", "dask://127.0.0.1:1") == alone


def test_what_lost_workers_were_at_is_done_by_others(cluster, capsys):
    """Each worker is killed once, with what it has done and what waits for it."""
    alone = said(capsys, "--no-cache")
    victims = [each.pid for each in cluster.workers.values()]
    tasks = cluster.scheduler.tasks

    def kill():
        for victim in victims:
            while not any(name.startswith("lint_at") for name in list(tasks)):
                sleep(0.05)
            os.kill(victim, signal.SIGKILL)

    killer = Thread(target=kill, daemon=True)
    killer.start()

    assert said(capsys, "--no-cache", "--executor", address(cluster)) == alone
    killer.join()


def test_a_file_that_ends_its_workers_is_reported_and_no_other(robots, tmp_path, capsys):
    """What was judged beside it is judged again: once, as one process does."""
    lines = "json-lines"
    _, alone = said(capsys, "--no-cache", "--output-format", lines)
    Path("poison.urdf").write_text(ROBOT.format("poison"))
    preload = tmp_path / "deadly.py"
    preload.write_text(DEADLY)

    with workers(1, preload=[str(preload)]) as found:
        code, told = said(
            capsys, "--no-cache", "--output-format", lines, "--executor", address(found)
        )

    error, *left = sorted(told.splitlines(), key=lambda each: '"poison.urdf"' not in each)
    assert '"message": "each worker that linted it was lost"' in error
    assert code == 2
    assert left == alone.splitlines()
    assert len(left) >= COUNT
