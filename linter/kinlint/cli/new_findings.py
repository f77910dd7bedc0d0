"""Compares findings with those known before: reports new ones, and keeps the baseline."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from pathlib import Path

from kinlint.baseline.baseline_file import DEFAULT, Baseline, read_baseline, write_baseline
from kinlint.baseline.entry_identity import Entry, Names, entry_of
from kinlint.baseline.ledger import Ledger
from kinlint.baseline.stale import stale_entries, stale_findings
from kinlint.configuration.config_file import Config
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.errors import UsageError
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real, shown
from kinlint.finding import Finding
from kinlint.formats.records import by_suffix
from kinlint.light_dataclasses import dataclass, replace
from kinlint.report import Report
from kinlint.reporters.summary import plural
from kinlint.rule import Rule
from kinlint.text import SourceText


@dataclass(frozen=True)
class KnownFindings:
    """Findings known before a run."""

    settings: Settings
    """The settings of the run."""
    rules: Sequence[Rule]
    """The rules of the run."""
    baseline: Baseline | None
    """The baseline file, if there is one."""
    before: Ledger | None
    """The findings at the revision that the run is compared to, if there is one."""
    options: Namespace
    """The command line, which says whether the baseline is written or pruned."""

    def new(self, findings: Sequence[Finding]) -> Sequence[Finding]:
        """Return the *findings* that were not known."""
        if self.baseline is not None and not self.options.write_baseline:
            findings = ledger(self.baseline).new(findings)
        return findings if self.before is None else self.before.new(findings)

    def apply_to(self, report: Report) -> Report:
        """Return *report* with new findings only, and the number of the others.

        Entries of the baseline without a finding are reported, or removed.
        """
        findings, aged = list(report.findings), list[Finding]()
        if self.baseline is not None:
            findings, left = ledger(self.baseline).compared(report.findings)
            old = stale_entries(left, report, ledger(self.baseline), self._searched(self.baseline))
            if self.options.write_baseline:
                self._write(self.baseline, report, left, old)
                findings = []
            elif self.options.prune_baseline:
                self._prune(self.baseline, left, old)
            elif not self.settings.partial:
                aged = list(stale_findings(old, self.baseline, report.rules))
        if self.before is not None:
            findings = self.before.new(findings)
        number = len(report.findings) - len(findings)
        judged = Policies(self.settings, self.rules).apply_severities(aged)
        both = sorted((*findings, *judged), key=lambda one: one.sort_key)
        return replace(report, findings=tuple(both), baseline=number)

    def _searched(self, baseline: Baseline) -> Callable[[str], bool]:
        """Tells whether the run would have found a file at a path, as *baseline* writes it."""
        if self.options.in_project:
            return lambda _path: False
        root = real(baseline.path).parent
        tops = {real(absolute(each)) for each in self.options.paths or ["."]}
        return lambda path: not tops.isdisjoint(real(root / path).parents)

    def _write(
        self, baseline: Baseline, report: Report, left: Sequence[Entry], old: Sequence[Entry]
    ) -> None:
        if report.errors:
            told = plural(len(report.errors), "file")
            raise UsageError(f"{shown(baseline.path)}: not written: {told} could not be read")
        names, kept = ledger(baseline).names, self._lasting(left, old)
        found = [entry_of(each, names) for each in report.findings]
        before = baseline.composed if kept else ()
        composed = {
            *(each for each in before if not ledger(baseline).gone(each)),
            *map(names.relative_path, filter(_is_composed, report.files)),
        }
        write_baseline(baseline.path, [*found, *kept], composed)
        self._say(f"{plural(len(report.findings), 'finding')} written to {shown(baseline.path)}")

    def _prune(self, baseline: Baseline, left: Sequence[Entry], old: Sequence[Entry]) -> None:
        lost = len(left) - len(kept := self._lasting(left, old, prune=True))
        forgotten = set(map(id, left)) - set(map(id, kept))
        if lost:
            left = [one for one in baseline.entries if id(one) not in forgotten]
            write_baseline(baseline.path, left, baseline.composed)
        entries = "entry" if lost == 1 else "entries"
        self._say(f"{lost:,} stale {entries} dropped from {shown(baseline.path)}")

    def _lasting(
        self, left: Sequence[Entry], old: Sequence[Entry], *, prune: bool = False
    ) -> list[Entry]:
        """The entries *left* that are not *old*, nor, to *prune* them, of files that are gone."""
        dropped = set(map(id, old))
        if prune or self.options.prune_baseline:
            assert self.baseline is not None
            gone = ledger(self.baseline).gone
            dropped |= {id(one) for one in left if gone(one.path)}
        return [one for one in left if id(one) not in dropped]

    def _say(self, text: str) -> None:
        if not self.options.silent:
            sys.stderr.write(f"kinlint: {text}\n")


def ledger(baseline: Baseline) -> Ledger:
    """Return the ledger of *baseline*, whose paths are relative to its directory."""
    root = real(baseline.path).parent
    return Ledger(
        baseline.entries, Names(root), lambda path: not (root / path).exists(), baseline.composed
    )


def _is_composed(name: str) -> bool:
    """Tell whether files like the one called *name* compose models with others."""
    form = by_suffix(name)
    return form is None or not form.is_tree


def find_baseline(options: Namespace, project: Config) -> Baseline | None:
    """The baseline that *options* or *project* name, or that is to be written.

    Raises UsageError if it cannot be read.
    """
    origin, path = _named(options, project)
    if path is None:
        return None
    if options.write_baseline and not path.exists():
        return Baseline(path, SourceText(shown(path), ""))
    return read_baseline(path, origin)


def _named(options: Namespace, project: Config) -> tuple[str, Path | None]:
    if options.baseline:
        return "--baseline", absolute(options.baseline)
    if project.baseline is not None:
        return f"{project.origin}: baseline", project.baseline
    if options.write_baseline or options.prune_baseline:
        option = "--write-baseline" if options.write_baseline else "--prune-baseline"
        return option, absolute(DEFAULT)
    return "", None
