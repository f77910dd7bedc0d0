"""`--fix`, `--fix-only` and `--diff`: fixes the files that were named."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Protocol

from kinlint.configuration.settings import Settings
from kinlint.edits import NotExpressible
from kinlint.errors import SourceError
from kinlint.files.atomic_write import replacement
from kinlint.files.environment import WRITING
from kinlint.files.pathglob import absolute
from kinlint.finding import Finding
from kinlint.fixes.offers import accept_all
from kinlint.fixes.rounds import fix_in_rounds
from kinlint.formats.decoding import decode, encode
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Input
from kinlint.report import Report
from kinlint.reporters.diff import unified_diff
from kinlint.reporters.terminal_style import When, detect_style
from kinlint.rule import Applicability
from kinlint.text import SourceText

__all__ = [
    "accept_all",
    "fix_in_rounds",
    "least_applicability",
    "print_diffs",
    "write_fixes",
    "write_streamed",
]

Change = tuple[SourceText, SourceText]
BOM = "\ufeff"
"""Byte order mark, which belongs to the first line of a patch."""


def least_applicability(settings: Settings) -> Applicability:
    """Return the least applicability of fixes that are made."""
    return Applicability.UNSAFE if settings.unsafe_fixes else Applicability.SAFE


class Changes(Protocol):
    """Outcome of changing texts."""

    @property
    def report(self) -> Report:
        """The report on the changed texts."""
        ...

    @property
    def changed(self) -> Sequence[Change]:
        """The texts that changed, before and after."""
        ...

    @property
    def restless(self) -> Sequence[str]:
        """The rules, by their codes, whose fixes undo or feed each other, and are not made."""
        ...


def write_fixes(outcome: Changes, inputs: Iterable[Input], done: str = "fixed") -> Report:
    """Write the texts of *outcome* to the files of *inputs*; the report of what is left.

    So it goes with those that they include. A file that changed meanwhile, or cannot be written,
    stays as it is, and the report has it as an error, which says that it is not *done*.
    """
    paths = {one.name: one.path for one in inputs}
    there = {
        before.name: paths.get(before.name, absolute(before.name)) for before, _ in outcome.changed
    }
    failed: dict[str, str] = {}
    for writing in (False, True):
        for before, after in outcome.changed:
            path = there[before.name]
            if path is None or before.name in failed:
                continue
            try:
                data = _checked(before, after, path)
                if writing:
                    with replacement(path) as stream:
                        stream.write(data)
            except (OSError, SourceError, NotExpressible) as error:
                failed[before.name] = _cause(error)
                failed |= _partners(before.name, outcome.report.fixed, failed)
    errors = [SourceError(name, f"not {done}: {cause}") for name, cause in failed.items()]
    report = outcome.report
    kept = tuple(one for one in report.fixed if failed.keys().isdisjoint(_files(one)))
    return replace(report, errors=(*report.errors, *errors), fixed=kept)


def _cause(error: Exception) -> str:
    told = error.strerror if isinstance(error, OSError) else getattr(error, "cause", "")
    return str(told or error)


def _partners(name: str, fixed: Iterable[Finding], failed: Mapping[str, str]) -> dict[str, str]:
    """The files, apart from those that *failed*, that are fixed together with that of *name*."""
    together = [set(files) for one in fixed if len(files := set(_files(one, edited=True))) > 1]
    found, left = {name}, True
    while left:
        left = any(found & files and not files <= found for files in together)
        found |= {each for files in together if found & files for each in files}
    cause = f"it changes together with {name}, which cannot be written"
    return {each: cause for each in sorted(found) if each not in failed}


def _files(finding: Finding, *, edited: bool = False) -> Iterable[str]:
    """Yield the files that the fixes of *finding* edit and, unless only *edited*, its own."""
    changed = (edit.location.source.name for fix in finding.fixes for edit in fix.edits)
    return changed if edited else (finding.location.source.name, *changed)


def print_diffs(changed: Iterable[Change], color: When) -> None:
    """Write to standard output what *changed* in each file."""
    style = detect_style(sys.stdout, color)
    for before, after in changed:
        old, new = (BOM * (one.bom and not style.color) + one.text for one in (before, after))
        sys.stdout.writelines(unified_diff(before.name, old, new, style))


def write_streamed(
    sources: Iterable[SourceText], changed: Iterable[Change], inputs: Iterable[Input]
) -> None:
    """Write the text that came from standard input to standard output, as it is now.

    What no text can be turned back to, comes out as the bytes that came.
    """
    streamed = {one.name for one in inputs if one.path is None}
    texts = {before.name: after for before, after in changed}
    for source in sources:
        if source.name in streamed:
            text = texts.get(source.name, source)
            sys.stdout.buffer.write(text.original or encode(text))


def _checked(before: SourceText, after: SourceText, path: Path) -> bytes:
    """The bytes of *after* for the file at *path*, provided that *before* is what it holds.

    Raises an error if they may not be written there.
    """
    data = encode(after)
    now = decode(before.name, path.read_bytes())
    if (now.text, now.bom) != (before.text, before.bom):
        raise SourceError(before.name, "the file has changed since it was read")
    if not path.stat().st_mode & WRITING:
        raise SourceError(before.name, "the file is read-only")
    return data
