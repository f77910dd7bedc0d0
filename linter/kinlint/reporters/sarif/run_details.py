"""The call of kinlint and the texts of the files, which a SARIF log has on request only."""

from __future__ import annotations

import base64
import shlex
import uuid
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from kinlint.report import Invocation, Report
from kinlint.reporters.sarif.artifact_location import Artifacts


def called(invocation: Invocation, root: str) -> dict[str, Any]:
    """Return what an `invocation` object says of a call of kinlint in the directory *root*."""
    return {
        "commandLine": shlex.join(("kinlint", *invocation.arguments)),
        "arguments": list(invocation.arguments),
        "startTimeUtc": _time(invocation.began),
        "endTimeUtc": _time(invocation.ended),
        "exitCode": invocation.exit_code,
        "workingDirectory": {"uri": Path(root).as_uri() + "/"},
    }


def identity() -> dict[str, str]:
    """Return the `automationDetails` of a run, with an identifier that no other run has."""
    return {"guid": str(uuid.uuid4())}


def embedded(report: Report, artifacts: Artifacts) -> Iterator[dict[str, Any]]:
    """Yield an `artifact` for each file with findings, with its content."""
    sources = {one.location.source.name: one.location.source for one in report.findings}
    for name, source in sorted(sources.items()):
        made: dict[str, Any] = {"location": artifacts.location(name)}
        if source.encoding:
            made |= {"contents": {"text": source.text}, "encoding": source.encoding}
        else:
            made["contents"] = {"binary": base64.b64encode(source.original).decode("ascii")}
        yield made


def _time(seconds: float) -> str:
    return datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%dT%H:%M:%S.%fZ")
