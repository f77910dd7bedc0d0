"""`--fix`, `--fix-only` and `--diff`: mends the files that were named."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from kinlint.configuration.settings import Settings
from kinlint.edits import Unsayable
from kinlint.errors import SourceError
from kinlint.files.discovery import Input
from kinlint.files.pathglob import absolute
from kinlint.files.replacement import replacement
from kinlint.fixes.rounds import Mended, mended
from kinlint.formats.decoding import decode, encode
from kinlint.model import Applicability, Finding
from kinlint.report import Report
from kinlint.reporters.diff import unified
from kinlint.reporters.style import When, style_of
from kinlint.text import SourceText

__all__ = ["least", "mended", "pass_on", "show", "written"]

Change = tuple[SourceText, SourceText]
BOM = "\ufeff"
"""What stands before some texts, and so in the patch of their first line."""


def least(settings: Settings) -> Applicability:
    """How far a fix must be trusted to be made."""
    return Applicability.UNSAFE if settings.unsafe_fixes else Applicability.SAFE


def written(outcome: Mended, inputs: Iterable[Input]) -> Report:
    """Write the texts of *outcome* to the files of *inputs*; the report of what is left.

    So it goes with those that they include. A file that changed meanwhile, or cannot be written,
    stays as it is, and the report has it as an error.
    """
    paths = {one.name: one.path for one in inputs}
    failed = []
    for before, after in outcome.changed:
        try:
            _write(before, after, paths.get(before.name, absolute(before.name)))
        except (OSError, SourceError, Unsayable) as error:
            cause = error.strerror if isinstance(error, OSError) else getattr(error, "cause", "")
            failed.append(SourceError(before.name, f"not fixed: {cause or error}"))
    report = outcome.report
    lost = {error.name for error in failed}
    kept = tuple(one for one in report.fixed if lost.isdisjoint(_files(one)))
    return replace(report, errors=(*report.errors, *failed), fixed=kept)


def _files(finding: Finding) -> Iterable[str]:
    """Where *finding* lies, and where its fixes change something."""
    changed = (edit.location.source.name for fix in finding.fixes for edit in fix.edits)
    return (finding.location.source.name, *changed)


def show(changed: Iterable[Change], color: When) -> None:
    """Write to standard output what *changed* in each file."""
    style = style_of(sys.stdout, color)
    for before, after in changed:
        old, new = (BOM * (one.bom and not style.color) + one.text for one in (before, after))
        sys.stdout.writelines(unified(before.name, old, new, style))


def pass_on(
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


def _write(before: SourceText, after: SourceText, path: Path | None) -> None:
    """Write *after* to the file at *path*, provided that *before* is what it holds."""
    if path is None:
        return
    data = encode(after)
    now = decode(before.name, path.read_bytes())
    if (now.text, now.bom) != (before.text, before.bom):
        raise SourceError(before.name, "the file has changed since it was read")
    with replacement(path) as stream:
        stream.write(data)
