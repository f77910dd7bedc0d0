"""One line per finding, in the format that compilers print and editors parse.

`path:10:27: error: message [UNI002]`, as in the GNU coding standards, "Formatting Error Messages",
with the code behind it as clang-tidy and mypy write it. The code stays last, where problem matchers
look for it: that a fix is at hand is said before the message, as ruff says it. Columns are code
points.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.fixability import sign
from kinlint.reporters.terminal_style import INK_OF, Style


def render(report: Report, style: Style) -> Iterator[str]:
    """The lines: findings first, then the files that cannot be read."""
    for finding in report.findings:
        line, column = finding.location.start
        name = printable(finding.location.source.name, unicode=style.unicode)
        kind = style.ink(finding.severity.label, INK_OF[finding.severity])
        message = fold_lines(finding.message, unicode=style.unicode)
        if finding.suppressed is not None:
            message += " (suppressed)"
        code = style.link(finding.rule.code, finding.rule.iri)
        if mark := sign(finding, unsafe=report.unsafe):
            message = f"{mark} {message}"
        yield f"{style.ink(name, 'strong')}:{line}:{column}: {kind}: {message} [{code}]\n"
    for error in report.errors:
        place = (
            f"{printable(error.name, unicode=style.unicode)}:{error.line or 1}:{error.column or 1}"
        )
        cause = fold_lines(error.cause, unicode=style.unicode)
        yield f"{place}: {style.ink('error', 'error')}: {cause}\n"
