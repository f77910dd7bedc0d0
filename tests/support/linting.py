"""Lints texts as the command would, for tests."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any

from kinlint import lint as pipeline
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.finding import Finding
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import decode, read
from kinlint.report import Report
from kinlint.text import SourceText

ARM = "arm.urdf"
"""What a text is called where a test does not care."""

Text = str | bytes
Files = Text | Mapping[str, Text] | Iterable[SourceText]
"""A text, texts by the names of their files, or sources."""


@cache
def book() -> Rulebook:
    """Return the built-in rules, loaded once for all tests of a process."""
    return rulebook.load()


def source(text: Text, name: str = ARM, form: str | None = None) -> SourceText:
    """Return *text* as the file called *name*; bytes are decoded.

    *form* names the format that it is taken for, whatever its name and its text tell.
    """
    made = decode(name, text) if isinstance(text, bytes) else SourceText(name, text)
    return made if form is None else replace(made, format=BY_NAME[form])


def sources(files: Files, name: str = ARM) -> list[SourceText]:
    """Return the sources of *files*; *name* is that of a single text."""
    if isinstance(files, str | bytes):
        return [source(files, name)]
    if isinstance(files, Mapping):
        return [source(text, each) for each, text in files.items()]
    return list(files)


def document(text: Text, name: str = ARM, form: str | None = None, **options: Any) -> Document:
    """Return what `source` of *text* states, read with `ReadOptions` of *options*."""
    return read(source(text, name, form), ReadOptions(**options))


def lint(
    files: Files, name: str = ARM, *, rules: Rulebook | None = None, **settings: Any
) -> Report:
    """Return the report of *files* as one model, under `Settings` of *settings*."""
    return pipeline.run(sources(files, name), [], Settings(**settings), rules or book())


def findings(files: Files, name: str = ARM, **options: Any) -> tuple[Finding, ...]:
    """Return what `lint` finds in *files*, all of which can be read."""
    report = lint(files, name, **options)
    assert report.errors == ()
    return report.findings


def told(files: Files, name: str = ARM, **options: Any) -> list[Finding]:
    """Return `findings` of *files*, each before what follows from it."""
    return [
        each
        for finding in findings(files, name, **options)
        for each in (finding, *finding.consequences)
    ]


def codes(files: Files, name: str = ARM, **options: Any) -> list[str]:
    """Return the code of each of `findings`, in their order."""
    return [finding.rule.code for finding in findings(files, name, **options)]
