"""Fixes of a process that is killed at any moment: each file is old or new, and nothing is left.

`KINLINT_KILLS=1000 pytest -m slow tests/files/test_durability.py` kills that often for each format.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import time
from collections.abc import Callable
from functools import partial
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

KILLS = int(os.environ.get("KINLINT_KILLS", "12"))


def read(directory: Path) -> dict[str, bytes]:
    """The files of *directory*, hidden ones too."""
    return {each.name: each.read_bytes() for each in directory.iterdir()}


def unharmed() -> None:
    """Let this process end as it will."""


def fixed(directory: Path, begin: Callable[[], None]) -> int:
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


def killed_while_writing(seed: int) -> None:
    """Let this process kill itself at one of the lines that are run while files are written."""
    left = random.Random(seed).randrange(400)  # noqa: S311
    write = fix_files.write_fixes

    def line(_frame, _event, _argument):
        nonlocal left
        left -= 1
        if left < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return line

    def traced(*arguments, **options):
        sys.settrace(line)
        return write(*arguments, **options)

    fix_files.write_fixes = traced


@pytest.fixture(scope="module", autouse=True)
def rules():
    """Load the rules before processes are forked, which need not do so again."""
    book()


@pytest.mark.parametrize("forms", [*([form] for form in FILES), [*FILES]], ids="-".join)
def test_a_killed_process_leaves_old_or_new(forms, tmp_path, rules_cache):
    """Killed at any moment, or at any line of the writing; the next run leaves nothing else."""
    before = {f"arm.{form}": FILES[form].encode() for form in forms}
    after, seconds, interrupted = {}, 0.0, 0
    for seed in range(KILLS + 1):
        for name, text in before.items():
            (tmp_path / name).write_bytes(text)
        started = time.monotonic()
        child = fixed(tmp_path, partial(killed_while_writing, seed) if seed % 2 else unharmed)
        if seed and not seed % 2:
            time.sleep(random.Random(seed).uniform(0, seconds))  # noqa: S311
            os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        left = read(tmp_path)
        if not seed:
            after, seconds = left, time.monotonic() - started
            assert all(after[name] != text for name, text in before.items())
        interrupted += os.WIFSIGNALED(status)
        for name, text in before.items():
            assert left[name] in (text, after[name]), (seed, name)
        os.waitpid(fixed(tmp_path, unharmed), 0)
        assert read(tmp_path) == after, seed
    assert interrupted > KILLS // 3
