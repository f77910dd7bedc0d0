"""Files that take findings as they come, and are complete at the end: databases, parts of SARIF."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Self

from kinlint.cli.output_files import replacing_bytes
from kinlint.report import Report
from kinlint.reporters.reporter_registry import FORMATS

if TYPE_CHECKING:
    from kinlint.reporters.sarif.sarif_parts import SarifParts
    from kinlint.reporters.sqlite_database import FindingsDatabase


class GatheredOutputs:
    """Such files, by their formats and paths."""

    def __init__(self, copies: Sequence[tuple[str, Path]], *, large: bool) -> None:
        """Begin with nothing in them; *large* is true if findings may not fit in memory."""
        self._ending = ExitStack()
        self._made = [(path, _begun(name, large=large)) for name, path in copies]
        for _, each in self._made:
            self._ending.enter_context(each)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._ending.close()

    def add(self, report: Report) -> None:
        """Add the findings of *report*, a part of the run's."""
        for _, each in self._made:
            each.add(report)

    def conclude(self, report: Report) -> None:
        """Write the files of the run, which *report* sums up. Raises `UsageError`."""
        for path, each in self._made:
            each.conclude(report)
            for file, copy in each.files(path):
                with replacing_bytes(file) as stream:
                    copy(stream)


def _begun(name: str, *, large: bool) -> SarifParts | FindingsDatabase:
    if FORMATS[name].database:
        from kinlint.reporters.sqlite_database import FindingsDatabase  # noqa: PLC0415  few runs

        return FindingsDatabase(large=large)
    from kinlint.reporters.sarif.sarif_parts import SarifParts  # noqa: PLC0415  few runs

    return SarifParts()
