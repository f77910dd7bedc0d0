"""The interface of reporters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from kinlint.report import Report
from kinlint.reporters.terminal_style import Style


class Reporter(Protocol):
    """A function that turns a report into text, piece by piece."""

    def __call__(self, report: Report, style: Style) -> Iterator[str]:
        """The pieces of the text; joined they are complete, with a line end after the last."""
        ...
