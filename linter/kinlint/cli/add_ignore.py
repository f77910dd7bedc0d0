"""`--add-ignore`: writes suppressions into the files that were named."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Iterable
from functools import partial

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli import fix_files
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.fixes.offers import Sieve
from kinlint.fixes.rounds import RoundsResult, fix_in_rounds
from kinlint.ignoring.suppression_generator import SuppressionGenerator
from kinlint.light_dataclasses import replace
from kinlint.phases import Phases
from kinlint.project.discovery import Found
from kinlint.report import Report
from kinlint.reporters.summary import plural
from kinlint.rule import Applicability
from kinlint.text import SourceText


def add_ignores(  # noqa: PLR0913, PLR0917
    options: Namespace,
    sources: list[SourceText],
    failed: list[SourceError],
    found: Found,
    settings: Settings,
    book: Rulebook,
    wanted: Sieve,
    phases: Phases,
) -> Report:
    """Silence what is *wanted* of the findings in *sources*; the report of what is left.

    What cannot be silenced is told on standard error.
    """
    streamed = {one.name for one in found.inputs if one.path is None}
    outcome = fix_in_rounds(
        sources, failed, settings, book, Applicability.SAFE, phases, streamed, found.asides, wanted,
        generator=partial(SuppressionGenerator, reason=options.add_ignore or None),
    )  # fmt: skip
    if not options.silent:
        sys.stderr.writelines(_outcome_lines(outcome))
    report = replace(outcome.report, fixed=(), unfixed=())
    report = fix_files.write_fixes(replace(outcome, report=report), found.inputs, "silenced")
    fix_files.write_streamed(sources, outcome.changed, found.inputs)
    return report


def _outcome_lines(outcome: RoundsResult) -> Iterable[str]:
    yield f"kinlint: {plural(len(outcome.report.fixed), 'finding')} silenced\n"
    refused = [(finding, why) for finding, _, why in outcome.left.generator.refused]
    refused += [
        (each.finding, verdict.why)
        for each, verdict in outcome.left.verdicts.items()
        if verdict.applicability is not Applicability.SAFE
    ]
    for finding, why in sorted(refused, key=lambda one: one[0].sort_key):
        source, start = finding.location.source, finding.location.start
        place = f"{source.name}:{start.line}:{start.column}"
        yield f"kinlint: warning: {finding.rule.code} at {place} is not silenced: {why}\n"
