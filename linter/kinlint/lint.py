"""Lints texts once: an analysis with nothing kept."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import NOTHING, Analyzer, Examination
from kinlint.report import Report
from kinlint.text import SourceText


def run(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
) -> Report:
    """Lint *sources* as one model: the report of `examine`."""
    return examine(sources, errors, settings, rulebook, phases).report


def examine(  # noqa: PLR0913
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
    *,
    repairing: bool = False,
    overlay: Mapping[Path, SourceText] = NOTHING,
) -> Examination:
    """Lint *sources* as one model, as `Analyzer.examine` does."""
    return Analyzer(settings, rulebook).examine(
        sources, errors, phases, repairing=repairing, overlay=overlay
    )
