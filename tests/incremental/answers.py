"""What must be equal of two examinations of the same texts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any

from kinlint import lint
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.pipeline.analyzer import Analyzer, Examination
from kinlint.report import Report
from kinlint.text import SourceText


def answer(examination: Examination) -> dict[str, Any]:
    """All that the report of *examination* says, but the time."""
    report = replace(examination.report, seconds=None)
    said = {field.name: getattr(report, field.name) for field in fields(Report)}
    return said | {"errors": list(map(str, report.errors))}


def agree(
    incremental: Analyzer,
    sources: Sequence[SourceText],
    settings: Settings,
    rulebook: Rulebook,
    *,
    repairing: bool = False,
) -> None:
    """Hold the next answer of *incremental* to that of an examination from the beginning."""
    found = incremental.examine(sources, repairing=repairing)
    meant = lint.examine(sources, [], settings, rulebook, repairing=repairing)
    assert answer(found) == answer(meant)
