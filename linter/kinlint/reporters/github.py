"""Annotations on GitHub: workflow commands that its runner reads from standard output.

Escapes and limits are the runner's (actions/toolkit `command.ts`; a step keeps ten annotations
of a kind and drops the rest without a word), so the rest is counted in a last line.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from kinlint.errors import SourceError
from kinlint.model import Finding, Severity
from kinlint.report import STDIN_NAMES, Report
from kinlint.reporters.style import Style

ANNOTATIONS_OF_A_KIND = 10
MESSAGE_LENGTH = 4_000
_KINDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def render(report: Report, style: Style) -> Iterator[str]:  # noqa: ARG001
    """The commands, the worst first, and how many findings have none."""
    commands: dict[str, list[str]] = {kind: [] for kind in _KINDS.values()}
    for error in report.errors:
        commands["error"].append(_unreadable(error, report.root))
    for finding in sorted(report.open, key=lambda finding: -finding.severity):
        commands[_KINDS[finding.severity]].append(_annotation(finding, report.root))
    left = []
    for kind, lines in commands.items():
        yield from lines[:ANNOTATIONS_OF_A_KIND]
        if more := len(lines[ANNOTATIONS_OF_A_KIND:]):
            left.append(f"{more:,} more {kind}{'' if more == 1 else 's'}")
    if left:
        yield (
            f"kinlint: {', '.join(left)} not annotated; "
            f"GitHub shows {ANNOTATIONS_OF_A_KIND} of a kind.\n"
        )


def _annotation(finding: Finding, root: str) -> str:
    start, end = finding.location.start, finding.location.end
    properties = {
        "title": f"kinlint ({finding.rule.code})",
        **_file(finding.location.source.name, root),
        "line": str(start.line),
        "endLine": str(end.line),
    }
    if start.line == end.line:
        properties |= {"col": str(start.column), "endColumn": str(end.column)}
    return _command(_KINDS[finding.severity], properties, finding.message)


def _unreadable(error: SourceError, root: str) -> str:
    properties = {"title": "kinlint", **_file(error.name, root)}
    if error.line is not None:
        properties["line"] = str(error.line)
        if error.column is not None:
            properties["col"] = str(error.column)
    return _command("error", properties, error.cause)


def _file(name: str, root: str) -> dict[str, str]:
    """The absolute path, since the runner does not know in which directory kinlint ran.

    Standard input without a name is no file.
    """
    if name in STDIN_NAMES:
        return {}
    return {"file": os.path.normpath(os.path.join(root, name))}  # noqa: PTH118


def _command(kind: str, properties: dict[str, str], message: str) -> str:
    listed = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
    return f"::{kind} {listed}::{_data(message[:MESSAGE_LENGTH])}\n"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
