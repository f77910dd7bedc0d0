"""Times how a process starts: of small files and of reports that are recalled, in CPU time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from benchmarks.processes import KINLINT, PYTHON, Workplace
from benchmarks.table import Row
from benchmarks.timing import interleaved, processor_time
from benchmarks.urdf_robot import urdf_chain

JOINTS = 7
PASS = (PYTHON, "-c", "pass")
JSON_LD, URDF, RECALLED = 10.0, 8.0, 4.0
"""How many times the work of `python -c pass` each run may take."""


@dataclass(frozen=True)
class Starting:
    """Runs on small models in `place`, whose cache has compiled rules and nothing else."""

    place: Workplace

    def rows(self, runs: int) -> Iterator[Row]:
        """What a run on a clean file of 7 joints costs, and the same run again."""
        urdf = Path(self.place.directory, "small.urdf")
        urdf.write_text(urdf_chain(JOINTS), "utf-8")
        models = ((self.place.model(JOINTS, spoiled=False), JSON_LD), (urdf.name, URDF))
        for model, target in models:
            yield self._row(f"`kinlint`, {JOINTS} joints, {model}", (KINLINT, model), runs, target)
        for model, _ in models:
            command = (KINLINT, "--cache-dir", "recalling", model)
            self.place.run(list(command))
            name = f"`kinlint`, {JOINTS} joints, {model}, recalled"
            yield self._row(name, command, runs, RECALLED)

    def _row(self, name: str, command: tuple[str, ...], runs: int, target: float) -> Row:
        self.place.run(list(command))
        actions = [partial(self.place.run, list(each)) for each in (command, PASS)]
        ours, theirs = interleaved(actions, runs, processor_time)
        return Row(name, "`python -c pass`, CPU", (ours, theirs), target=target)
