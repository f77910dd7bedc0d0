"""Times the lint of many real robots in one run against loading them one by one.

Also whether two processors take half the time, and whether more files take more memory.
"""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from benchmarks import robot
from benchmarks.processes import KINLINT, PYTHON
from benchmarks.table import Row
from benchmarks.timing import interleaved
from benchmarks.urdf_robot import urdf_chain

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

NOT_STARTED = (126, 127)
"""Exit codes of what did no work, as 2 is with a message; others tell what was found."""

LINT = (KINLINT, "--isolated", "--no-cache", "--quiet", "--output-format=concise")
SHARED, GROWN, SMALL = 1.7, 1.3, 400
"""Speed of two processors against one, memory of four times the files, and small files."""
WATCHED = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""
"""Tells the memory of a command; a large process that starts one would tell its own."""
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
            yield Row(name, "`check_urdf`, once for each", (ours, theirs), "faster", target=1)
        if find_spec("yourdfpy"):
            ours, theirs = self._compared(
                lambda: [self.run([PYTHON, "-c", EACH, file]) for file in few], 1
            )
            yield Row(
                name, "`yourdfpy`, once for each", (ours, theirs * scale), "faster", target=20
            )
            ours, theirs = self._compared(lambda: self.run([PYTHON, "-c", EACH, *files]), runs)
            yield Row(name, "`yourdfpy`, all in one process, no meshes", (ours, theirs), "faster")
        if sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1:
            two = [*self.lint, "--jobs=2"]
            actions = [lambda: self.run(two, processors=2), lambda: self.run(self.lint)]
            shared = interleaved(actions, runs)
            yield Row(f"{name}, two processors", "one", (shared[0], shared[1]), "faster", SHARED)
        yield memory_row("of these", files)
        with tempfile.TemporaryDirectory() as directory:
            yield memory_row("small files, URDF and JSON-LD", small_files(Path(directory)))

    def compared_by_size(self, models: Path, runs: int) -> Iterator[Row]:
        """A run over the MJCF files below *models* against one over the robots, per megabyte."""
        mjcf, urdf = sorted(models.rglob("*.xml")), [*map(Path, self.files)]
        others = [*self.lint[:-1], str(models)]
        commands = [[*each, "--no-cache"] for each in (others, self.lint)]
        self.run(others)
        seconds = interleaved([partial(self.run, each) for each in commands], runs)
        shares = (
            each / sum(file.stat().st_size for file in files) * 1e6
            for each, files in zip(seconds, (mjcf, urdf), strict=True)
        )
        one, other = shares
        name = f"`kinlint`, {len(mjcf)} MJCF files in one run, per megabyte"
        yield Row(name, f"{len(urdf)} URDF files, per megabyte", (one, other), "ratio", target=1)

    @property
    def lint(self) -> list[str]:
        """The run of kinlint that is measured."""
        return [*LINT, str(self.directory)]

    def _compared(self, theirs: Callable[[], object], runs: int) -> tuple[float, float]:
        one, other = interleaved([lambda: self.run(self.lint), theirs], runs)
        return one, other

    def run(self, command: list[str], processors: int = 1) -> None:
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
            preexec_fn=partial(_on_processors, processors),
        )
        refused = done.returncode == 2 and done.stderr
        if done.returncode in NOT_STARTED or refused or b"Traceback" in done.stderr:
            raise RuntimeError(f"{command[:4]}: {done.stderr.decode(errors='replace')}")


def memory_row(what: str, files: Sequence[str]) -> Row:
    """Compare the memory that *files* take at most with that of a quarter of them."""
    few = files[::4]
    sizes = [peak([*LINT, "--jobs=1", *some]) for some in (files, few)]
    titles = [f"`kinlint`, {len(some)} {what}, memory" for some in (files, few)]
    return Row(titles[0], titles[1], (sizes[0], sizes[1]), target=GROWN, unit="B")


def peak(command: Sequence[str]) -> int:
    """Return the most memory that *command* takes, in bytes."""
    watched = [PYTHON, "-c", WATCHED, *command]
    told = subprocess.run(watched, stdout=subprocess.PIPE, check=True, text=True).stdout
    return int(told) * (1 if sys.platform == "darwin" else 1024)


def small_files(directory: Path) -> list[str]:
    """Write robots of one joint into *directory*, one half in JSON-LD; return their paths."""
    found = []
    for number in range(SMALL):
        name = f"arm{number:03}"
        urdf = number % 8 < 4
        text = urdf_chain(1).replace('"arm"', f'"{name}"') if urdf else robot.chain(1)
        file = directory / f"{name}.{'urdf' if urdf else 'jsonld'}"
        file.write_text(text.replace(robot.NAMESPACE, f"https://{name}.example/#"), "utf-8")
        found.append(str(file))
    return found


def _on_processors(count: int) -> None:
    if sys.platform == "linux":
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:count])
