"""Times runs that prove fixes against runs that only report, by the work of all processors."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from benchmarks.processes import KINLINT, Workplace
from benchmarks.table import Row
from benchmarks.timing import interleaved, processor_time
from benchmarks.urdf_robot import urdf_chain

OPTIONS = ("--isolated", "--no-cache", "--jobs=1")
PLAIN = ("--quiet", "--output-format=concise")
"""A report without fixes: neither marks nor a summary tell what can be fixed."""
SHOWN, FIXED, PAGE = 1.5, 2.0, 3.0
"""How many times the work of a plain report the default output, `--fix` and a page may take."""
FINDINGS = 1_000


@dataclass(frozen=True)
class Proving:
    """Runs on the models of `place` and on the robots of `fleet`, a directory, if there is one."""

    place: Workplace
    fleet: Path | None = None

    def rows(self, runs: int, *, quick: bool = False) -> Iterator[Row]:
        """What proofs of fixes cost: in the default output, by `--fix`, and in a page."""
        for joints in (70,) if quick else (70, 700):
            name = f"{joints} spoiled joints"
            yield from self._fixing(name, Path(self.place.model(joints)), runs)
        page = self.place.directory / "page.urdf"
        page.write_text(urdf_chain(FINDINGS).replace('upper="2.5"', 'upper="-3.0"'), "utf-8")
        html = ("--quiet", "--output-format=html")
        yield self._row("HTML", f"{FINDINGS:,} findings", runs, page, PAGE, *html)
        if self.fleet is not None:
            copy = self.place.directory / "fleet"
            shutil.copytree(self.fleet, copy)
            yield from self._fixing("the public robots", copy, runs)

    def _fixing(self, name: str, model: Path, runs: int) -> Iterator[Row]:
        yield self._row("`kinlint`", name, runs, model, SHOWN)
        yield self._row("`kinlint --fix`", name, runs, model, FIXED, "--fix", *PLAIN)

    def _row(
        self, what: str, name: str, runs: int, model: Path, target: float, *options: str
    ) -> Row:
        """Compare a run with *options* on a copy of *model* with one that only reports."""
        actions = [partial(self._run, model, *given) for given in (options, PLAIN)]
        ours, theirs = interleaved(actions, runs, processor_time)
        plain = f"`kinlint {' '.join(PLAIN)}`"
        return Row(f"{what}, {name}", plain, (ours, theirs), target=target)

    def _run(self, model: Path, *options: str) -> None:
        """Run kinlint on a copy of *model*, which it may change."""
        source, copy = self.place.directory / model, self.place.directory / "copy"
        copy.mkdir()
        if source.is_dir():
            shutil.copytree(source, copy / source.name)
        else:
            shutil.copy(source, copy)
        self.place.run([KINLINT, *OPTIONS, *options, "copy"])
        shutil.rmtree(copy)
