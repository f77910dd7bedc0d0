"""Issues on Azure Pipelines: logging commands that its agent reads from standard output.

`##vso[task.logissue type=error;sourcepath=a.urdf;linenumber=1;code=UNI002;]message`: the agent ends
a property at `;` and the properties at `]`, and undoes `%AZP25` last, so percent signs are escaped
first. There are errors and warnings, and nothing less.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import STDIN_NAMES, Report
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

_TYPES = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "warning"}


def render(report: Report, style: Style) -> Iterator[str]:  # noqa: ARG001
    """A command for each finding, then for each file that cannot be read."""
    paths = Paths(report.root)
    for finding in report.unsuppressed:
        name = finding.location.source.name
        line, column = finding.location.start
        properties = {
            "type": _TYPES[finding.severity],
            "sourcepath": "" if name in STDIN_NAMES else paths.relative(name),
            "linenumber": str(line),
            "columnnumber": str(column),
            "code": finding.rule.code,
        }
        yield _command(properties, finding.message)
    for error in report.errors:
        properties = {
            "type": "error",
            "sourcepath": "" if error.name in STDIN_NAMES else paths.relative(error.name),
            "linenumber": str(error.line or ""),
            "columnnumber": str(error.column or ""),
        }
        yield _command(properties, error.cause)


def _command(properties: dict[str, str], message: str) -> str:
    said = "".join(f"{key}={_property(value)};" for key, value in properties.items() if value)
    return f"##vso[task.logissue {said}]{_data(message)}\n"


def _data(text: str) -> str:
    return text.replace("%", "%AZP25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace("]", "%5D").replace(";", "%3B")
