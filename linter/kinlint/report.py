"""The result of a run, as reporters get it."""

from __future__ import annotations

import os

from kinlint import __version__
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.rule import Repair, Rule, Severity
from kinlint.structure import Structure

STDIN_NAMES = frozenset({"", "-", "<stdin>"})
"""Names of a source that came from standard input without a name."""


@dataclass(frozen=True, slots=True)
class Invocation:
    """Call of kinlint, for reports that tell of it."""

    arguments: tuple[str, ...]
    """Words of the command line."""
    began: float
    """Time when the run began, in seconds since 1970-01-01 in UTC."""
    ended: float
    """Time when it ended, likewise."""
    exit_code: int
    """Exit code that the report amounts to."""


@dataclass(frozen=True)
class Report:
    """Result of a run."""

    findings: tuple[Finding, ...] = ()
    """Findings by `Finding.sort_key`; suppressed ones only if they are to be shown."""
    hidden: tuple[Finding, ...] = ()
    """Findings of a severity that the output does not show (`--show`)."""
    suppressed: tuple[Finding, ...] = ()
    """Suppressed findings that are not shown."""
    files: tuple[str, ...] = ()
    """Names of all files that were read."""
    unapplied: tuple[str, ...] = ()
    """Names of the files that no rule applied to."""
    errors: tuple[SourceError, ...] = ()
    """Files that could not be read."""
    passed_over: tuple[SourceError, ...] = ()
    """Files that were found and not taken for models, though they may have been meant as such."""
    rules: tuple[Rule, ...] = ()
    """Rules that were checked, found anything or not."""
    triples: int = 0
    """Number of asserted triples."""
    applied: int = 0
    """Number of rules that had something to check."""
    seconds: float | None = None
    """Wall-clock time; None where output must not depend on it."""
    baseline: int | None = None
    """Number of findings known before; None if nothing was compared."""
    elsewhere: int = 0
    """Number of findings in files that nobody asked about."""
    installed: int = 0
    """Number of findings in installed files that files of the run include; they are not listed."""
    fixed: tuple[Finding, ...] = ()
    """Findings that were fixed, each with the fix made."""
    fails_from: Severity | None = Severity.WARNING
    """Least severity of the findings that make the run fail; None if none does."""
    derived: bool = False
    """True if formats for people show what findings were derived from."""
    unsafe: bool | None = None
    """True if unsafe fixes are made with the safe ones; False also hides the hint at them."""
    unfixed: tuple[tuple[Finding, Repair, str], ...] = ()
    """Findings whose repair cannot be offered, each with the repair and the reason."""
    structures: tuple[Structure, ...] = ()
    """Robots that were read, if an output draws them."""
    catalogue: str = ""
    """Digest of the rules; empty if unknown."""
    recalled: int | None = None
    """Number of files whose results come from the cache; None without a cache."""
    invocation: Invocation | None = None
    """The call of kinlint, where output may depend on it."""
    embedded: bool = False
    """True if SARIF holds the texts of the files with findings."""
    version: str = __version__
    """Version of kinlint."""
    root: str = field(default_factory=os.getcwd)
    """Directory that relative file names start at."""

    def with_suppressed(self) -> Report:
        """Return this report with suppressed findings among the others."""
        both = sorted((*self.findings, *self.suppressed), key=lambda one: one.sort_key)
        return replace(self, findings=tuple(both), suppressed=())

    def with_consequences(self) -> Report:
        """Return this report with the consequences of its findings among them."""
        told = [each for one in self.findings for each in (one, *one.listed_consequences)]
        told += [each for error in self.errors for each in error.consequences]
        return replace(self, findings=tuple(sorted(told, key=lambda each: each.sort_key)))

    def shown_from(self, least: Severity) -> Report:
        """Return this report with the findings below *least* in `hidden`."""
        kept = tuple(each for each in self.findings if each.severity >= least)
        hidden = tuple(each for each in self.unsuppressed if each.severity < least)
        return replace(self, findings=kept, hidden=hidden)

    @property
    def unsuppressed(self) -> tuple[Finding, ...]:
        """The findings that nobody suppressed, should suppressed ones be among `findings`."""
        return tuple(finding for finding in self.findings if finding.suppressed is None)
