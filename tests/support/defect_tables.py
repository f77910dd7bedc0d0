"""Tables of files with one defect each, and what is found in them."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from kinlint.configuration.settings import Choice, FileSettings
from kinlint.formats.registry import decode
from support.linting import lint


def rows(table: Path) -> list[list[str]]:
    """Return the rows of *table*: file, line or `-`, code or `-`, and a reason or remark."""
    return [line.split("\t") for line in table.read_text().splitlines()[1:]]


@cache
def found(path: Path, selected: tuple[str, ...] = ()) -> frozenset[tuple[int, str, str]]:
    """The line, code and severity of each finding in *path*, of rules that are on or *selected*."""
    chosen = FileSettings((Choice(extend_select=selected),))
    report = lint([decode(str(path), path.read_bytes())], default=chosen)
    assert report.errors == () or path.stem == "unclosed-element", report.errors
    return frozenset(
        (each.location.start.line, each.rule.code, each.severity.name.lower())
        for each in report.findings
    )
