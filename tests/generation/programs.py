"""Programs as `kinlint generate` makes them, in this process, and what runs them."""

from __future__ import annotations

import json
import types
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from support.linting import sources

from kinlint.catalogue import rulebook
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.facts.part_names import PartNames
from kinlint.finding import Finding
from kinlint.findings.locator import Locator
from kinlint.generation.program import abilities, framed, rewritten_for, rule_files
from kinlint.generation.rendering import render
from kinlint.pipeline.analyzer import Analyzer
from kinlint.rule import PROGRAMS, Severity


@cache
def book(library: str, kept: Path) -> rulebook.Rulebook:
    """The rules for programs of *library*, compiled once."""
    return rulebook.load([rule_files()], [abilities(library)], kept)


def program(
    files: Mapping[str, str | bytes], library: str, kept: Path, *, general: bool = True
) -> tuple[list[Finding], Mapping[str, str]]:
    """The errors in *files*, and without any the files of a program; rules are *kept*.

    Unless *general*, only those count that are of the library's concern.
    """
    choices = () if general else (Choice(select=(PROGRAMS,)),)
    settings = Settings(default=FileSettings(choices=choices))
    found = Analyzer(settings, book(library, kept), repeated=True).examine(sources(files))
    errors = [each for each in found.report.unsuppressed if each.severity >= Severity.ERROR]
    if errors or found.report.errors:
        return errors, {}
    names = PartNames(Locator(found.documents, found.store)).names
    return [], render(framed(rewritten_for(library, found.store, names)), library)


def module(text: str) -> Any:
    """The program *text* as a module."""
    made = types.ModuleType("generated")
    exec(compile(text, "robot.py", "exec"), made.__dict__)  # noqa: S102
    return made


def texts(paths: Iterable[Path]) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in paths}


def lines(output: str) -> list[Any]:
    return [json.loads(line) for line in output.rstrip("\n").split("\n")]
