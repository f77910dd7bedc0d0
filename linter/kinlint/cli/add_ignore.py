"""`--add-ignore`: writes suppressions into the files that were named."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Iterator, Sequence
from functools import partial

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli import fix_files
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.fixes.offers import Sieve
from kinlint.fixes.rounds import RoundsResult, fix_in_rounds
from kinlint.ignoring.suppression_generator import SUPPRESSION, SuppressionGenerator
from kinlint.light_dataclasses import replace
from kinlint.parallel.timed_fixes import FixedTexts
from kinlint.phases import Phases
from kinlint.project.discovery import Input
from kinlint.report import Report
from kinlint.reporters.summary import plural
from kinlint.rule import Applicability
from kinlint.text import SourceText


def silence_in_rounds(  # noqa: PLR0913  as fix_in_rounds
    sources: Sequence[SourceText],
    failed: Sequence[SourceError],
    settings: Settings,
    book: Rulebook,
    *,
    reason: str | None,
    streamed: Collection[str],
    kept: Collection[str],
    wanted: Sieve,
    phases: Phases | None = None,
) -> RoundsResult:
    """Silence what is *wanted* of the findings in *sources*; the report has what cannot be."""
    outcome = fix_in_rounds(
        sources, failed, settings, book, Applicability.SAFE, phases, streamed, kept, wanted,
        generator=partial(SuppressionGenerator, reason=reason),
    )  # fmt: skip
    unfixed = tuple((finding, SUPPRESSION, why) for finding, why in _refused(outcome))
    return replace(outcome, report=replace(outcome.report, unfixed=unfixed))


def write_ignores(
    outcome: fix_files.Changes,
    inputs: Sequence[Input],
    sources: Sequence[SourceText],
    *,
    silent: bool,
) -> Report:
    """Write the silenced texts of *outcome*; the report of what is left.

    What cannot be silenced is told on standard error.
    """
    if not silent:
        sys.stderr.writelines(_outcome_lines(outcome.report))
    told = replace(outcome.report, fixed=(), unfixed=())
    changes = FixedTexts(told, outcome.changed, ())
    report = fix_files.write_fixes(changes, inputs, "silenced")
    fix_files.write_streamed(sources, outcome.changed, inputs)
    return report


def _refused(outcome: RoundsResult) -> Iterator[tuple[Finding, str]]:
    yield from ((finding, why) for finding, _, why in outcome.left.generator.refused)
    for each, verdict in outcome.left.verdicts.items():
        if verdict.applicability is not Applicability.SAFE:
            yield each.finding, verdict.why


def _outcome_lines(report: Report) -> Iterable[str]:
    yield f"kinlint: {plural(len(report.fixed), 'finding')} silenced\n"
    for finding, _, why in sorted(report.unfixed, key=lambda one: one[0].sort_key):
        source, start = finding.location.source, finding.location.start
        place = f"{source.name}:{start.line}:{start.column}"
        yield f"kinlint: warning: {finding.rule.code} at {place} is not silenced: {why}\n"
