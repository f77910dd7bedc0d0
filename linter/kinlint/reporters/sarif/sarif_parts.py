"""SARIF in parts: several logs, written as findings come, since one of all may be too large.

GitHub takes logs of at most 25,000 results and 10 MB, compressed, and shows 5,000 of them.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import BinaryIO, Self

from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.log_commands import UNICODE, without_controls
from kinlint.reporters.sarif.sarif_log import render
from kinlint.reporters.terminal_style import Style

MOST = 5000
"""Most results of a log."""


class SarifParts:
    """Logs with the findings of a run, in their order; the last one has what could not be read."""

    def __init__(self) -> None:
        """Begin without any."""
        self._directory = tempfile.TemporaryDirectory(prefix="kinlint-")
        self._waiting: list[Finding] = []
        self._made: list[Path] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._directory.cleanup()

    def add(self, report: Report) -> None:
        """Add the findings of *report*."""
        self._waiting += report.findings
        while len(self._waiting) > MOST:
            self._write(replace(report, errors=()), self._waiting[:MOST])
            del self._waiting[:MOST]

    def conclude(self, report: Report) -> None:
        """Write the last log, with the errors of *report*."""
        self._write(report, self._waiting)

    def files(self, path: Path) -> Iterator[tuple[Path, Callable[[BinaryIO], None]]]:
        """Yield the file of each part, by *path* with its number, and a function that writes it."""
        for number, made in enumerate(self._made, start=1):
            yield path.with_name(path.name.replace("*", f"{number:04}")), partial(_copy, made)

    def _write(self, report: Report, findings: Sequence[Finding]) -> None:
        made = Path(self._directory.name, str(len(self._made)))
        pieces = render(replace(report, findings=tuple(findings)), Style())
        with made.open("w", encoding="utf-8", newline="\n") as stream:
            stream.writelines(without_controls(piece, UNICODE) for piece in pieces)
        self._made.append(made)


def _copy(made: Path, stream: BinaryIO) -> None:
    with made.open("rb") as opened:
        shutil.copyfileobj(opened, stream)
