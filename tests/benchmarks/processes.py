"""Times whole processes: kinlint as its users start it, and what it is compared with."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks import robot
from benchmarks.table import Row
from benchmarks.timing import interleaved

KINLINT = str(Path(sysconfig.get_path("scripts")) / "kinlint")
PYTHON = sys.executable
WARNING = "kinlint: warning: "
PEERS = "import rdflib, pyshacl, owlrl, pyld"


@dataclass(frozen=True)
class Workplace:
    """A directory of models, in which processes run with warm caches of their own."""

    directory: Path

    def model(self, joints: int, *, spoiled: bool = True) -> str:
        """The name of a file with a chain of *joints*."""
        file = self.directory / f"{'spoiled' if spoiled else 'clean'}-{joints}.jsonld"
        if not file.exists():
            file.write_text(robot.chain(joints, spoiled=spoiled), "utf-8")
        return file.name

    def rows(self, runs: int, *, quick: bool = False) -> Iterator[Row]:
        """What is measured of whole processes: start-up, a small model, and growth."""
        started = self._compared([KINLINT, "--version"], [PYTHON, "-c", "pass"], 4 * runs)
        yield Row("`kinlint --version`", "`python -c pass`", started, target=3)
        small = [KINLINT, self.model(7, spoiled=False)]
        linted = self._compared(small, [PYTHON, "-c", PEERS], 4 * runs)
        yield Row("`kinlint`, 7 joints", f"`python -c '{PEERS}'`", linted, target=1)
        few, many = (70, 700) if quick else (700, 7000)
        long, short = [KINLINT, self.model(many)], [KINLINT, self.model(few)]
        grown = self._compared(long, short, runs)
        yield Row(f"`kinlint`, {many} joints", f"`kinlint`, {few} joints", grown, target=12)

    def _compared(self, ours: list[str], theirs: list[str], runs: int) -> tuple[float, float]:
        one, other = interleaved([lambda: self.run(ours), lambda: self.run(theirs)], runs)
        return one, other

    def warm(self) -> None:
        """Fill the caches of byte code and of the compiled catalogue; reports are not kept."""
        (self.directory / "cache").mkdir(exist_ok=True)
        (self.directory / "cache" / "reports").touch()
        self.run([KINLINT, self.model(7)])
        self.run([PYTHON, "-c", PEERS])

    def run(self, command: list[str]) -> None:
        """Run *command* to its end. Raises `RuntimeError` if it fails other than by findings."""
        done = subprocess.run(
            command,
            cwd=self.directory,
            env=self.environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
        told = [line for line in done.stderr.splitlines() if not line.startswith(WARNING)]
        if done.returncode not in (0, 1) or told:
            raise RuntimeError(f"{' '.join(command)}: {done.stderr}")

    @property
    def environment(self) -> dict[str, str]:
        """This one's, but byte code is kept: peers that pip compiled would have a head start."""
        kept = {
            name: value
            for name, value in os.environ.items()
            if not name.startswith("KINLINT_") and name != "PYTHONDONTWRITEBYTECODE"
        }
        return kept | {
            "KINLINT_CACHE_DIR": str(self.directory / "cache"),
            "PYTHONPYCACHEPREFIX": str(self.directory / "bytecode"),
        }
