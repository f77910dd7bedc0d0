"""Makes the report of what was found: reads it, lints it, mends it if asked."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Sequence
from dataclasses import dataclass, replace

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.outputs import Outputs
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files.discovery import Found
from kinlint.formats.registry import recognise
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.text import SourceText


@dataclass(frozen=True)
class Run:
    """What to lint, how, and by which rules."""

    settings: Settings
    found: Found
    book: Rulebook
    phases: Phases

    def report(self, options: Namespace, outputs: Outputs) -> Report:
        """The report for *outputs*; with `--fix` and its like, of what is left."""
        if options.fix or options.fix_only or options.diff:
            report = self._mended(options)
        else:
            fixing = outputs.tells_fixes
            report = self._linted(options.jobs or os.cpu_count() or 1, fixing=fixing)
        return replace(report, unsafe=self.settings.unsafe_fixes)

    def _read(self) -> tuple[list[SourceText], list[SourceError]]:
        """The texts that were found, with what they were written for, and what cannot be read."""
        with self.phases.phase("imports"):
            from kinlint import lint  # noqa: F401, PLC0415  engines are slow to import
            from kinlint.cli.reading import read  # noqa: PLC0415

        with self.phases.phase("decoding"):
            sources, errors = read(self.found.inputs, self.settings)
            beside = _beside(sources, self.settings)
            return [*sources, *beside], [*self.found.errors, *errors]

    def _mended(self, options: Namespace) -> Report:
        from kinlint.cli import fixing  # noqa: PLC0415  most runs change nothing

        sources, failed = self._read()
        inputs = self.found.inputs
        least = fixing.least(self.settings)
        streamed = {one.name for one in inputs if one.path is None}
        mended = fixing.mended(
            sources, failed, self.settings, self.book, least, self.phases, streamed
        )
        if mended.restless and not options.silent:
            sys.stderr.write(f"kinlint: warning: {fixing.unending(mended.restless)}\n")
        if options.diff:
            fixing.show(mended.changed, options.color)
            return mended.report
        report = fixing.written(mended, inputs)
        fixing.pass_on(sources, mended.changed, inputs)
        return report

    def _linted(self, jobs: int, *, fixing: bool) -> Report:
        from kinlint import lint  # noqa: PLC0415  engines are slow to import

        sources, failed = self._read()
        report = None
        if jobs > 1:
            with self.phases.phase("linting"):
                report = self._divided(sources, failed, jobs, fixing=fixing)
        if report is None and fixing:
            from kinlint.fixes.rounds import linted  # noqa: PLC0415  few outputs show fixes

            report = linted(sources, failed, self.settings, self.book, self.phases).report
        if report is None:
            report = lint.run(sources, failed, self.settings, self.book, self.phases)
        if report.files:
            return report
        # Nothing was read, so nothing decides which rules speak but what holds where kinlint runs.
        asked = Policies(self.settings, self.book.rules).enabled([""])
        return replace(report, rules=tuple(rule for rule in self.book.rules if rule.code in asked))

    def _divided(
        self,
        sources: Sequence[SourceText],
        failed: Sequence[SourceError],
        jobs: int,
        *,
        fixing: bool,
    ) -> Report | None:
        """What several processes find; None where the files are one model, or one has to do it."""
        from kinlint import parallel  # noqa: PLC0415  few runs have files enough

        if not parallel.divisible(sources, self.settings):
            return None
        return parallel.run(sources, failed, self.settings, self.book, jobs, fixing=fixing)


def _beside(sources: Sequence[SourceText], settings: Settings) -> Sequence[SourceText]:
    """What the files were written for and that nobody gave."""
    if not any(
        ".srdf" in each.name or recognise(each.name, each.text) == "srdf" for each in sources
    ):
        return ()
    from kinlint.cli.companions import companions  # noqa: PLC0415  most runs have no SRDF

    return companions(sources, settings)
