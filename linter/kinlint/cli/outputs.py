"""Where a report goes: one format to standard output or a file, others to files of their own."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from kinlint.errors import UsageError
from kinlint.report import Report
from kinlint.reporters.columns import shown
from kinlint.reporters.registry import FORMATS, write, write_statistics, write_summary
from kinlint.reporters.style import When, style_of


@dataclass(frozen=True, slots=True)
class Outputs:
    """What to write: `main` to `path`, or to standard output; `copies` by format to files."""

    main: str
    path: Path | None = None
    copies: tuple[tuple[str, Path], ...] = ()
    color: When = "auto"
    statistics: bool = False
    quiet: bool = False
    silent: bool = False
    verbose: bool = False

    def emit(self, report: Report) -> None:
        """Write *report* everywhere; what a machine format leaves unsaid goes to stderr.

        A file that cannot be written raises `UsageError` when the others are.
        """
        failures: list[UsageError] = []
        for name, path in self.copies:
            try:
                with replacing(path) as stream:
                    self._write(report, name, stream)
            except UsageError as error:
                failures.append(error)
        if self.path is not None:
            with replacing(self.path) as stream:
                self._main(report, stream)
        elif not self.silent:
            self._main(report, sys.stdout)
        self._aside(report)
        if failures:
            raise failures[0]

    def _main(self, report: Report, stream: TextIO) -> None:
        if self.statistics and not self._machine:
            self._statistics(report, stream)
        else:
            self._write(report, self.main, stream)

    def _aside(self, report: Report) -> None:
        """What standard error is told: all that standard output leaves unsaid."""
        if self.path is not None or self.silent or self._machine or self.statistics:
            for error in report.errors:
                sys.stderr.write(f"kinlint: error: {shown(str(error))}\n")
        if self.silent or not self._machine:
            return
        if self.statistics:
            self._statistics(report, sys.stderr)
        elif not self.quiet:
            write_summary(report, sys.stderr, verbose=self.verbose)

    def _statistics(self, report: Report, stream: TextIO) -> None:
        style = style_of(stream, self._color(stream))
        write_statistics(report, stream, style)
        if not self.quiet:
            write_summary(report, stream, style, verbose=self.verbose)

    def _write(self, report: Report, name: str, stream: TextIO) -> None:
        write(
            report,
            name,
            stream,
            style_of(stream, self._color(stream)),
            summarise=not (self.quiet or self.silent),
            verbose=self.verbose,
        )

    def _color(self, stream: TextIO) -> When:
        return self.color if stream in (sys.stdout, sys.stderr) else "auto"

    @property
    def _machine(self) -> bool:
        return FORMATS[self.main].machine


@contextmanager
def replacing(path: Path) -> Iterator[TextIO]:
    """A stream whose text replaces the file at *path* once it is complete, or not at all.

    Links stay links, and an existing file keeps its mode. What is no regular file, such as
    `/dev/stdout`, is written to as it is. Raises `UsageError` if that cannot be.
    """
    target = Path(os.path.realpath(path))
    try:
        if target.exists() and not target.is_file():
            with target.open("w", encoding="utf-8", newline="\n") as stream:
                yield stream
            return
        mode = target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_umask()
        handle, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
        temporary = Path(name)
        try:
            with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
                yield stream
                stream.flush()
                os.fsync(stream.fileno())
            temporary.chmod(mode)
            temporary.replace(target)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from None


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
