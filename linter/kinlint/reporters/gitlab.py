"""Findings for GitLab's Code Quality: a JSON array by its subset of Code Climate's format.

GitLab compares the fingerprints of two runs to tell what is new, so each is that of one finding in
one file, wherever in it that lies and whatever other files say.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterator
from typing import Any

from kinlint.addresses import is_address, split
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

UNREADABLE = "kinlint"
"""The name of the check that a file which cannot be read fails."""
_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(report: Report, style: Style) -> Iterator[str]:
    """The array: findings first, then the files that cannot be read."""
    paths, seen = Paths(report.root), Counter[str]()
    issues = [
        _issue(finding, paths.relative(finding.location.source.name))
        for finding in report.unsuppressed
    ]
    issues += [_error(error, paths.relative(error.name)) for error in report.errors]
    for issue in issues:
        seen[issue["fingerprint"]] += 1
        if (number := seen[issue["fingerprint"]]) > 1:
            issue["fingerprint"] = _hashed(issue["fingerprint"], str(number))
    yield json_text(issues, style, indent=2) + "\n"


def _issue(finding: Finding, path: str) -> dict[str, Any]:
    # The IRI of an element has the name of its file as the run called it, which may change.
    own = split(finding.iri)[1] if is_address(finding.iri) else finding.iri
    return {
        "description": fold_lines(finding.message),
        "check_name": finding.rule.code,
        "fingerprint": _hashed(path, replace(finding, iri=own).fingerprint),
        "severity": _SEVERITIES[finding.severity],
        "location": {
            "path": path,
            "lines": {"begin": finding.location.start.line, "end": finding.location.end.line},
        },
    }


def _error(error: SourceError, path: str) -> dict[str, Any]:
    return {
        "description": fold_lines(error.cause),
        "check_name": UNREADABLE,
        "fingerprint": _hashed(path, UNREADABLE, error.cause),
        "severity": _SEVERITIES[Severity.ERROR],
        "location": {"path": path, "lines": {"begin": error.line or 1}},
    }


def _hashed(*parts: str) -> str:
    return hashlib.sha256("\x1f".join(parts).encode("utf-8", "surrogatepass")).hexdigest()[:32]
