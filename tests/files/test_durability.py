"""Fixes of a process that is killed at any moment: each file is old or new, and nothing is left.

`KINLINT_KILLS=1000 pytest -m slow tests/files/test_durability.py` kills that often for each format.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import time
from ast import literal_eval
from collections.abc import Callable, Mapping
from functools import partial
from itertools import count
from pathlib import Path

import pytest
from support.fixable_files import FILES
from support.linting import book

from kinlint.cli import fix_files
from kinlint.cli.main import main

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot be forked here"),
]

KILLS = int(os.environ.get("KINLINT_KILLS", "50"))
RUNS = 6
"""Number of runs that are killed anywhere, not only while they write."""


def read(directory: Path) -> dict[str, bytes]:
    """The files of *directory*, hidden ones too."""
    return {each.name: each.read_bytes() for each in directory.iterdir()}


def put(directory: Path, files: Mapping[str, bytes]) -> None:
    """Let *files* be all that *directory* has."""
    for each in directory.iterdir():
        each.unlink()
    for name, text in files.items():
        (directory / name).write_bytes(text)


def fixed(directory: Path, begin: Callable[[], None] = lambda: None) -> int:
    """Fix all files of *directory* in a process that calls *begin* first; its number."""
    child = os.fork()
    if child:
        return child
    os.chdir(directory)
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    begin()
    names = sorted(path.name for path in Path().iterdir() if not path.name.startswith("."))
    main(["--fix", "--unsafe-fixes", "--silent", "--isolated", "--no-cache", *names])
    os._exit(0)


def written_lines(
    directory: Path, before: Mapping[str, bytes], write: Callable[..., object], arguments: tuple
) -> int:
    """The number of lines of Python that write all files, counted in a process of its own."""
    put(directory, before)
    reading, writing = os.pipe()
    if not os.fork():
        passed = count()

        def line(_frame, _event, _argument):
            next(passed)
            return line

        sys.settrace(line)
        write(*arguments)
        sys.settrace(None)
        os.write(writing, str(next(passed)).encode())
        os._exit(0)
    os.wait()
    return int(os.read(reading, 20))


def kill_writers(directory: Path, before: Mapping[str, bytes], record: Path) -> None:
    """Let this process write its fixes in many others, which are killed; *record* what they leave.

    Every other one is killed at a line of the writing, these lines evenly apart, so that each step
    is met whatever the machine is busy with; the rest after a random part of the time.
    """
    write = fix_files.write_fixes

    def many(*arguments):
        left: dict[tuple[tuple[str, bytes], ...], int] = {}
        interrupted, seconds, lines = 0, 0.0, written_lines(directory, before, write, arguments)
        for seed in range(KILLS + 1):
            chance = random.Random(seed)  # noqa: S311
            put(directory, before)
            started = time.monotonic()
            child = os.fork()
            if not child:
                if seed % 2:
                    sys.settrace(killer(lines * seed // KILLS))
                write(*arguments)
                os._exit(0)
            if seed and not seed % 2:
                time.sleep(chance.uniform(0, seconds))
                os.kill(child, signal.SIGKILL)
            _, status = os.waitpid(child, 0)
            seconds = seconds or time.monotonic() - started
            interrupted += os.WIFSIGNALED(status)
            left.setdefault(tuple(sorted(read(directory).items())), seed)
        record.write_text(repr((interrupted, [(seed, dict(each)) for each, seed in left.items()])))
        os._exit(0)

    fix_files.write_fixes = many


def killer(lines: int) -> Callable[..., object]:
    """A trace function that kills this process after so many *lines*."""

    def line(_frame, _event, _argument):
        nonlocal lines
        lines -= 1
        if lines < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return line

    return line


@pytest.fixture(scope="module", autouse=True)
def rules():
    """Load the rules before processes are forked, which need not do so again."""
    book()


@pytest.fixture(params=[*([form] for form in FILES), [*FILES]], ids="-".join)
def before(request, tmp_path, rules_cache):
    """The files of a directory, by name."""
    files = {f"arm.{form}": FILES[form].encode() for form in request.param}
    (tmp_path / "arms").mkdir()
    put(tmp_path / "arms", files)
    return files


@pytest.fixture
def after(before, tmp_path):
    """The files when all are fixed."""
    os.waitpid(fixed(tmp_path / "arms"), 0)
    files = read(tmp_path / "arms")
    assert all(files[name] != text for name, text in before.items())
    put(tmp_path / "arms", before)
    return files


def test_a_process_killed_while_it_writes_leaves_old_or_new(before, after, tmp_path):
    """At any line and at any moment; the next run finishes that, and leaves nothing else."""
    arms, record = tmp_path / "arms", tmp_path / "record"
    os.waitpid(fixed(arms, partial(kill_writers, arms, before, record)), 0)
    interrupted, states = literal_eval(record.read_text())
    assert interrupted > KILLS // 3
    assert len(states) > len(before)
    for seed, left in states:
        for name, text in before.items():
            assert left[name] in (text, after[name]), (seed, name)
        put(arms, left)
        os.waitpid(fixed(arms), 0)
        assert read(arms) == after, seed


def test_a_run_killed_anywhere_leaves_old_or_new(before, after, tmp_path):
    arms = tmp_path / "arms"
    started = time.monotonic()
    os.waitpid(fixed(arms), 0)
    seconds = time.monotonic() - started
    for seed in range(RUNS):
        put(arms, before)
        child = fixed(arms)
        time.sleep(random.Random(seed).uniform(0, seconds))  # noqa: S311
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        left = read(arms)
        for name, text in before.items():
            assert left[name] in (text, after[name]), (seed, name)
        os.waitpid(fixed(arms), 0)
        assert read(arms) == after, seed
