"""Lints a share of the models of a run, and tells what was found in each."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.errors import InternalError, KinlintError, SourceError
from kinlint.files.tracked_io import Record, recorded
from kinlint.finding import Finding, FindingKey
from kinlint.light_dataclasses import dataclass, replace
from kinlint.parallel.partition import Model
from kinlint.parallel.unread import provided
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.rule import Rule, Severity
from kinlint.terms import iri_value
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.files.url_root import Root
    from kinlint.fixes.rounds import RoundsResult
    from kinlint.pipeline.given_documents import GivenDocuments


@dataclass(frozen=True)
class Job:
    """Work of one process."""

    settings: Settings
    """The settings of the run."""
    book: Rulebook
    """Its rules."""
    fixing: bool = False
    """True if reports contain fixes."""
    wanted: frozenset[FindingKey] | None = None
    """The findings that fixes are proven of; None for all."""
    least: Severity = Severity.INFO
    """Least severity of findings that fixes are proven of."""
    given: GivenDocuments | None = None
    """Documents of the texts, if these were read before."""
    roots: tuple[Root, ...] = ()
    """Places of the files that are named by URL."""
    rounds: Callable[..., RoundsResult] | None = None
    """Function that fixes the texts of a model, round by round; None if they stay as they are."""

    def select(self, findings: Sequence[Finding]) -> Sequence[Finding]:
        """Return those of *findings* that fixes are proven of."""
        shown = (one for one in findings if one.severity >= self.least)
        return [one for one in shown if self.wanted is None or one.key in self.wanted]


class Outcome(NamedTuple):
    """The report of a model, and what was looked up for it."""

    report: Report
    """Report on the model."""
    record: Record
    """Files and directories that were looked up for it."""
    changed: tuple[tuple[SourceText, SourceText], ...] = ()
    """The texts that were fixed, before and after."""
    restless: tuple[str, ...] = ()
    """The rules, by their codes, whose fixes undo or feed each other."""


def lint_shard(
    share: Sequence[Model], errors: Sequence[SourceError], job: Job, phases: Phases | None = None
) -> list[Outcome]:
    """The outcome for each model of *share*; *errors* that were known before are left out."""
    try:
        read = provided(share, job.roots)
    except SourceError as error:
        if len(share) > 1:
            return _one_by_one(share, errors, job, phases)
        return [Outcome(Report(errors=(error,)), Record())]
    return _lint(read, errors, job, phases)


def _lint(
    share: Sequence[Model], errors: Sequence[SourceError], job: Job, phases: Phases | None
) -> list[Outcome]:
    try:
        with recorded() as record:
            if job.rounds is not None:
                return [_fixed(each, errors, job, record) for each in share]
            report, documents = _examined(share, errors, job, phases)
    except (KinlintError, MemoryError):
        raise
    except Exception as error:
        if os.environ.get("KINLINT_TRACEBACK") == "1":
            raise
        if len(share) > 1:
            return _one_by_one(share, errors, job, phases)
        failed = (InternalError.from_exception(source.name, error) for source in share[0])
        return [Outcome(Report(errors=tuple(failed)), record)]
    report = replace(report, errors=report.errors[len(errors) :])
    if len(share) == 1:
        return [Outcome(report, record)]
    parts = _parts(share, report, documents, job)
    if parts is None:
        return _one_by_one(share, errors, job, phases)
    return [Outcome(part, record) for part in parts]


def _fixed(model: Model, errors: Sequence[SourceError], job: Job, record: Record) -> Outcome:
    """Return the outcome of fixing *model*."""
    assert job.rounds is not None
    made = job.rounds(model, errors, job.settings, job.book)
    report = replace(made.report, errors=made.report.errors[len(errors) :])
    return Outcome(report, record, tuple(made.changed), tuple(made.restless))


def _one_by_one(
    share: Sequence[Model], errors: Sequence[SourceError], job: Job, phases: Phases | None
) -> list[Outcome]:
    return [outcome for each in share for outcome in lint_shard([each], errors, job, phases)]


def _examined(
    share: Sequence[Model], errors: Sequence[SourceError], job: Job, phases: Phases | None
) -> tuple[Report, Sequence[Document]]:
    sources, phases = [source for model in share for source in model], phases or Phases()
    with phases.phase("imports"):
        from kinlint.pipeline.analyzer import Analyzer  # noqa: PLC0415  engines are slow to import

    analyzer = Analyzer(job.settings, job.book, trying=job.fixing, given=job.given)
    examination = analyzer.examine(sources, errors, phases, repairing=job.fixing)
    report, documents = examination.report, examination.documents
    if not job.fixing or not any(one.rule.repairs for one in job.select(report.findings)):
        return report, documents
    with phases.phase("imports"):
        from kinlint.fixes.rounds import offers  # noqa: PLC0415  clean models have nothing to fix

    proven = offers(examination, analyzer, sources, job.settings, job.book, phases, job.select)
    return proven.report, documents


def _parts(
    share: Sequence[Model], report: Report, documents: Sequence[Document], job: Job
) -> list[Report] | None:
    """Split *report* by the models of *share*; None if a finding lies in no file of theirs."""
    home = {source.name: number for number, model in enumerate(share) for source in model}
    said = {each.source.name: len(each.statements) for each in documents}
    homes = _homes(documents, home)
    try:
        found = _sorted(report.findings, homes, len(share))
        silenced = _sorted(report.suppressed, homes, len(share))
        errors = [[e for e in report.errors if home[e.name] == n] for n in range(len(share))]
    except KeyError:
        return None
    asked = _Asked(documents, job)
    parts = []
    for number in range(len(share)):
        files = tuple(name for name in report.files if home[name] == number)
        parts.append(
            replace(
                report,
                findings=found[number],
                suppressed=silenced[number],
                files=files,
                unapplied=tuple(name for name in report.unapplied if home[name] == number),
                errors=tuple(errors[number]),
                rules=asked.rules(files, report.rules),
                triples=sum(said[name] for name in files),
                unfixed=tuple(
                    one for one in report.unfixed if home[one[0].location.source.name] == number
                ),
            )
        )
    return parts


def _homes(documents: Sequence[Document], home: Mapping[str, int]) -> Mapping[str, int]:
    """Return the numbers of models by the IRIs and texts of their documents.

    *home* has them by the names of their files. A text that several models include has none.
    """
    owners: dict[str, set[int]] = {}
    for document in documents:
        if (number := home.get(document.source.name)) is not None:
            for name in (iri_value(document.graph), *(each.name for each in document.sources)):
                owners.setdefault(name, set()).add(number)
    return {**{name: min(each) for name, each in owners.items() if len(each) == 1}, **home}


def _sorted(
    findings: Sequence[Finding], homes: Mapping[str, int], count: int
) -> list[tuple[Finding, ...]]:
    """*findings* by the model that they are about; raises KeyError if that is unknown."""
    from kinlint.findings.grouping import model_of  # noqa: PLC0415  a recalled report is sorted

    sorted_: list[list[Finding]] = [[] for _ in range(count)]
    for finding in findings:
        number = homes.get(model_of(finding))
        sorted_[homes[finding.location.source.name] if number is None else number].append(finding)
    return list(map(tuple, sorted_))


class _Asked:
    """Tells which rules that were enabled for all files are enabled for some."""

    def __init__(self, documents: Sequence[Document], job: Job) -> None:
        from kinlint.catalogue.applicability import formats  # noqa: PLC0415  loads the engine

        self._policies = Policies(job.settings, job.book.rules, formats(documents))

    def rules(self, files: Sequence[str], all_: Sequence[Rule]) -> tuple[Rule, ...]:
        enabled = self._policies.enabled(files)
        return tuple(rule for rule in all_ if rule.code in enabled)
