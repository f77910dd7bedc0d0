"""The outcome of a run: everything a reporter may know."""

from __future__ import annotations

import os
from dataclasses import dataclass, field

from kinlint import __version__
from kinlint.errors import SourceError
from kinlint.model import Finding, Repair, Rule
from kinlint.structure import Structure

STDIN_NAMES = frozenset({"", "-", "<stdin>"})
"""How a source is called that came from standard input and was given no name."""


@dataclass(frozen=True)
class Report:
    """What a run read, applied and found.

    `findings` come sorted by `Finding.sort_key`; suppressed ones are among them only if they
    are to be shown, and then not in `suppressed`. `files` are the names of all files that were
    read, `unapplied` those of them that no rule applied to. `rules` are the rules that were
    asked, found anything or not; `applied` counts those that had something to judge. `seconds`
    is wall-clock time, None where output must not depend on it. Relative file names start
    at `root`. `fixed` is what the run mended, each with the fix that was made, and `unsafe` whether
    unsafe fixes are made when safe ones are, or (False) the summary does not even hint at them.
    `elsewhere` counts what was found in files that nobody asked about.
    `baseline` counts what was known before, None where nothing was compared to.
    `unfixed` are findings whose repairs cannot be offered, each with the repair and the reason.
    `structures` are the robots that were read, if an output draws them. `catalogue` stands for the
    rules, by a hash; it is empty where nobody says which they were.
    `recalled` counts the files whose part of the report was known from an earlier run, None where
    nothing is kept.
    """

    findings: tuple[Finding, ...] = ()
    suppressed: tuple[Finding, ...] = ()
    files: tuple[str, ...] = ()
    unapplied: tuple[str, ...] = ()
    errors: tuple[SourceError, ...] = ()
    rules: tuple[Rule, ...] = ()
    triples: int = 0
    applied: int = 0
    seconds: float | None = None
    baseline: int | None = None
    elsewhere: int = 0
    fixed: tuple[Finding, ...] = ()
    unsafe: bool | None = None
    unfixed: tuple[tuple[Finding, Repair, str], ...] = ()
    structures: tuple[Structure, ...] = ()
    catalogue: str = ""
    recalled: int | None = None
    version: str = __version__
    root: str = field(default_factory=os.getcwd)

    @property
    def open(self) -> tuple[Finding, ...]:
        """The findings that nobody suppressed, should suppressed ones be among `findings`."""
        return tuple(finding for finding in self.findings if finding.suppressed is None)
