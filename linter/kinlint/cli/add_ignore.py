"""`--add-ignore`: writes suppressions into the files that were named."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Iterable

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli import fix_files
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files.discovery import Found
from kinlint.fixes.offers import Sieve
from kinlint.fixes.rounds import Mended
from kinlint.ignoring.ignoring import Ignored, ignored
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.reporters.summary import counted
from kinlint.text import SourceText


def silenced(  # noqa: PLR0913, PLR0917
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
    reason = options.add_ignore or None
    outcome = ignored(
        sources, failed, settings, book, reason, wanted, phases, streamed, found.asides
    )
    if not options.silent:
        sys.stderr.writelines(_told(outcome))
    mended = Mended(outcome.report, [], outcome.changed)
    report = fix_files.written(mended, found.inputs, "silenced")
    fix_files.pass_on(sources, outcome.changed, found.inputs)
    return report


def _told(outcome: Ignored) -> Iterable[str]:
    yield f"kinlint: {counted(len(outcome.done), 'finding')} silenced\n"
    for finding, why in outcome.refused:
        source, start = finding.location.source, finding.location.start
        place = f"{source.name}:{start.line}:{start.column}"
        yield f"kinlint: warning: {finding.rule.code} at {place} is not silenced: {why}\n"
