"""Annotations on GitHub: workflow commands that its runner reads from standard output.

Escapes and limits are the runner's (actions/toolkit `command.ts`; a step keeps ten annotations
of a kind and drops the rest without a word), so the rest is counted in a last line, and told in the
summary of the step where there is one.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.report import STDIN_NAMES, Report
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

ANNOTATIONS_OF_A_KIND = 10
MESSAGE_LENGTH = 4_096
"""Number of characters of a message that the runner keeps."""
_KINDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


class Parts(NamedTuple):
    """The findings and errors of a report that are annotated, and those that are not."""

    errors: tuple[SourceError, ...]
    """Errors that are annotated."""
    findings: tuple[Finding, ...]
    """Findings that are annotated."""
    more_errors: tuple[SourceError, ...]
    """Errors that are not."""
    more_findings: tuple[Finding, ...]
    """Findings that are not."""


def render(report: Report, style: Style) -> Iterator[str]:  # noqa: ARG001
    """The commands, the worst first, and how many findings have none."""
    parts = annotated(report)
    yield from (_unreadable(error, report.root) for error in parts.errors)
    yield from (_annotation(finding, report.root) for finding in parts.findings)
    left = Counter(_KINDS[finding.severity] for finding in parts.more_findings)
    left["error"] += len(parts.more_errors)
    more = [
        f"{left[kind]:,} more {kind}{'' if left[kind] == 1 else 's'}"
        for kind in _KINDS.values()
        if left[kind]
    ]
    if more:
        summary = "they are in the summary of this step"
        where = summary if os.environ.get("GITHUB_STEP_SUMMARY") else "other formats list all"
        limit = f"GitHub shows {ANNOTATIONS_OF_A_KIND} of a kind"
        yield f"kinlint: {', '.join(more)} not annotated, since {limit}; {where}.\n"


def annotated(report: Report) -> Parts:
    """Select what GitHub shows of *report*: ten of each kind, unreadable files first."""
    most = ANNOTATIONS_OF_A_KIND
    room = Counter(dict.fromkeys(Severity, most))
    room[Severity.ERROR] -= min(len(report.errors), most)
    shown: list[Finding] = []
    left: list[Finding] = []
    for finding in sorted(report.unsuppressed, key=lambda finding: -finding.severity):
        (shown if room[finding.severity] > 0 else left).append(finding)
        room[finding.severity] -= 1
    return Parts(report.errors[:most], tuple(shown), report.errors[most:], tuple(left))


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
    if len(message) > MESSAGE_LENGTH:
        message = f"{message[: MESSAGE_LENGTH - 1]}…"
    return f"::{kind} {listed}::{_data(message)}\n"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
