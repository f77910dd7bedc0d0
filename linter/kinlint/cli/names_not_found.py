"""Packages and xacro arguments that a run names and that are not there."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Sequence

from kinlint.cli.installed_findings import missing_packages
from kinlint.cli.xacro_arguments import arguments_not_taken
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.text import SourceText


def checked(
    options: Namespace, sources: Sequence[SourceText], settings: Settings, report: Report
) -> tuple[Report, Sequence[str]]:
    """Return *report*, and warnings about packages and xacro arguments that a run names in vain.

    A slip of an argument that the xacro files among *sources* take is an error of the report.
    """
    packages_of = ReadOptions.from_settings(settings).packages_of
    lines = missing_packages(sources, packages_of)
    arguments = arguments_not_taken(options, sources, settings)
    errors = [SourceError(text, line) for text, line in arguments.slips.items()]
    return replace(report, errors=(*report.errors, *errors)), (*lines, *arguments.others)
