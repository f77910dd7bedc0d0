"""Times the lint of many real robots in one run against loading them one by one."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from benchmarks.processes import KINLINT, PYTHON
from benchmarks.table import Row
from benchmarks.timing import interleaved

EACH = """
import contextlib, logging, os, sys, yourdfpy
logging.disable(logging.CRITICAL)
null = open(os.devnull, "w")
with contextlib.redirect_stdout(null), contextlib.redirect_stderr(null):
    for file in sys.argv[1:]:
        with contextlib.suppress(Exception):
            yourdfpy.URDF.load(file)
"""
"""Loads the files named, whether they can be or not; meshes are looked for and are not there."""

CHECK_URDF = Path(sysconfig.get_path("purelib"), "cmeel.prefix", "bin", "check_urdf")
"""urdfdom's own checker, which the package of Pinocchio brings along."""

NOT_STARTED = (2, 126, 127)
"""Exit codes of what did no work; 0, 1 and 255 tell what was found of a robot."""

PROCESSES = 40
"""So many files are loaded in a process of their own; the time for all is in proportion."""


@dataclass(frozen=True)
class Fleet:
    """The URDF files below `directory`, on one processor."""

    directory: Path

    @property
    def files(self) -> Sequence[str]:
        """Their paths."""
        return sorted(map(str, self.directory.rglob("*.urdf")))

    def rows(self, runs: int) -> Iterator[Row]:
        """One run of kinlint against each peer that is installed."""
        files = self.files
        few = files[:: max(1, len(files) // PROCESSES)]
        scale = len(files) / len(few)
        name = f"`kinlint`, {len(files)} URDF files in one run"
        self.run(self.lint)  # fills the caches of byte code and of the compiled catalogue
        if CHECK_URDF.exists():
            ours, theirs = self._compared(
                lambda: [self.run([str(CHECK_URDF), file]) for file in files], runs
            )
            yield Row(name, "`check_urdf`, once for each", (ours, theirs), "faster")
        if find_spec("yourdfpy"):
            ours, theirs = self._compared(
                lambda: [self.run([PYTHON, "-c", EACH, file]) for file in few], 1
            )
            yield Row(
                name, "`yourdfpy`, once for each", (ours, theirs * scale), "faster", target=20
            )
            ours, theirs = self._compared(lambda: self.run([PYTHON, "-c", EACH, *files]), runs)
            yield Row(name, "`yourdfpy`, all in one process, no meshes", (ours, theirs), "faster")

    @property
    def lint(self) -> list[str]:
        """The run of kinlint that is measured."""
        return [KINLINT, "--isolated", "--quiet", "--output-format=concise", str(self.directory)]

    def _compared(self, theirs: Callable[[], object], runs: int) -> tuple[float, float]:
        one, other = interleaved([lambda: self.run(self.lint), theirs], runs)
        return one, other

    def run(self, command: list[str]) -> None:
        """Run *command*; raises `RuntimeError` if it cannot even start, which is no measurement."""
        beside = str(CHECK_URDF.parent.with_name("lib"))
        kept = {**os.environ, "LD_LIBRARY_PATH": beside}
        # Peers that pip compiled would else have a head start.
        kept.pop("PYTHONDONTWRITEBYTECODE", None)
        done = subprocess.run(
            command,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            check=False,
            env=kept,
            preexec_fn=_on_one_processor,
        )
        if done.returncode in NOT_STARTED or b"Traceback" in done.stderr:
            raise RuntimeError(f"{command[:4]}: {done.stderr.decode(errors='replace')}")


def _on_one_processor() -> None:
    if sys.platform == "linux":
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
