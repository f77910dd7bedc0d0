"""Lints files as parts of their project: reads all its models, and reports what lies in the files.

What is found in a file then depends on the project alone, and not on which others were named with
it: hooks that get the files of a commit in portions find what one run finds.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from importlib import import_module
from typing import TYPE_CHECKING

from kinlint.configuration.settings import Settings
from kinlint.files.pathname import shown
from kinlint.finding import Finding
from kinlint.formats.records import JSON, TOLD
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Found, Input, may_be_jsonld
from kinlint.report import Report
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.fixes.offers import Sieve

UNREADABLE = "<!DOCTYPE"
"""Text that no XML reader accepts.

A file with it may affect findings in any other file of the run.
"""


def merge_with_project(given: Found, project: Found) -> Found:
    """All of *project*, in its order, then what else is *given*; what is not given is aside.

    A `.json` file that a search passes over is passed over here, too.
    """
    meant = {_identity(one): one for one in given.inputs}
    known = {error.name for error in given.errors}
    inputs, errors, asides = list[Input](), list(given.errors), set[str]()
    for one in project.inputs:
        own = meant.pop(_identity(one), None)
        inputs.append(one if own is None else replace(own, named=one.named))
        asides |= {one.name} if own is None else set()
    for error in project.errors:
        if error.name not in known:
            errors.append(error)
            asides.add(error.name)
    inputs += [one for one in meant.values() if not _passed_over(one)]
    named = {_identity(one) for one in given.inputs}
    turtle = [path for path in project.turtle if os.path.realpath(path) not in named]
    asides.update(map(shown, turtle))
    directories = [*given.directories, *project.directories]
    return Found(inputs, errors, given.barren, turtle, frozenset(asides), directories)


def affecting_sources(
    sources: Sequence[SourceText], asides: Collection[str], settings: Settings
) -> list[SourceText]:
    """Return the *sources* that may affect findings in one that is not among *asides*."""
    if all(source.name in asides for source in sources):
        return []
    from kinlint.formats.dependencies.file_groups import group_sources  # noqa: PLC0415
    from kinlint.parallel.partition import is_divisible  # noqa: PLC0415  loads every reader

    if not is_divisible(sources, settings) or any(UNREADABLE in each.text for each in sources):
        return list(sources)
    groups = (
        group for group in group_sources(sources) if any(one.name not in asides for one in group)
    )
    names = {source.name for group in groups for source in group}
    return [source for source in sources if source.name in names]


def exclude_asides(wanted: Sieve | None, asides: frozenset[str]) -> Sieve:
    """Return *wanted*, restricted to findings in files that are not among *asides*."""

    def sieve(findings: Sequence[Finding]) -> Sequence[Finding]:
        own = [one for one in findings if one.location.source.name not in asides]
        return own if wanted is None else wanted(own)

    return sieve


def without_asides(report: Report, asides: frozenset[str], wanted: Sieve | None) -> Report:
    """Return *report* without findings in files among *asides*; the *wanted* ones are counted."""

    def kept(findings: Sequence[Finding]) -> tuple[Finding, ...]:
        return tuple(one for one in findings if one.location.source.name not in asides)

    others = [one for one in report.findings if one.location.source.name in asides]
    return replace(
        report,
        findings=kept(report.findings),
        suppressed=kept(report.suppressed),
        files=tuple(name for name in report.files if name not in asides),
        unapplied=tuple(name for name in report.unapplied if name not in asides),
        errors=tuple(error for error in report.errors if error.name not in asides),
        unfixed=tuple(each for each in report.unfixed if kept(each[:1])),
        structures=tuple(one for one in report.structures if not asides.issuperset(one.files)),
        elsewhere=len(others if wanted is None else wanted(others)),
    )


def _identity(one: Input) -> str:
    return os.path.realpath(one.path or one.name)


def _passed_over(one: Input) -> bool:
    """Tell whether *one* is JSON of another kind, or of a kind that an extra reads that is missing.

    A hook gets all files of a commit, meshes too, and has only the packages that it is given.
    """
    path = one.path
    if path is None:
        return False
    told = TOLD.get(path.suffix.lower())
    if told is not None:
        passes: bool = import_module(str(told.robot_files)).needs_extra(path)
        return passes
    return path.suffix.lower() == JSON and not may_be_jsonld(path)
