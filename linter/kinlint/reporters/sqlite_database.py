"""Findings as a database of SQLite: a file to ask questions of, or the SQL that makes it."""

from __future__ import annotations

import shutil
import sqlite3
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import BinaryIO, Self

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.terminal_style import Style
from kinlint.text import Location

SCHEMA = """
CREATE TABLE run (version TEXT NOT NULL, root TEXT NOT NULL, catalogue TEXT NOT NULL);
CREATE TABLE file (name TEXT PRIMARY KEY) WITHOUT ROWID;
CREATE TABLE rule (code TEXT PRIMARY KEY, name TEXT NOT NULL, title TEXT NOT NULL,
    url TEXT NOT NULL, family TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE finding (id INTEGER PRIMARY KEY, file TEXT NOT NULL,
    code TEXT NOT NULL REFERENCES rule, severity TEXT NOT NULL, line INTEGER NOT NULL,
    "column" INTEGER NOT NULL,
    end_line INTEGER NOT NULL, end_column INTEGER NOT NULL, message TEXT NOT NULL, iri TEXT,
    property TEXT, reason TEXT, suppressed TEXT, fingerprint TEXT NOT NULL);
CREATE TABLE related (finding INTEGER NOT NULL REFERENCES finding, file TEXT NOT NULL,
    line INTEGER NOT NULL, "column" INTEGER NOT NULL, end_line INTEGER NOT NULL,
    end_column INTEGER NOT NULL, message TEXT NOT NULL);
CREATE TABLE unread (file TEXT NOT NULL, line INTEGER, "column" INTEGER, cause TEXT NOT NULL);
CREATE INDEX finding_by_code ON finding (code);
CREATE INDEX finding_by_file ON finding (file);
CREATE INDEX related_by_finding ON related (finding);
"""
"""The tables; lines and columns count from one, ends exclude."""
ROW = "INSERT INTO finding VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"


def render(report: Report, style: Style) -> Iterator[str]:
    """The SQL that makes the database, as `sqlite3 FILE` reads it."""
    del style
    with FindingsDatabase() as made:
        made.add(report)
        made.conclude(report)
        yield from (f"{line}\n" for line in made.lines())


class FindingsDatabase:
    """A database of findings, in a file if it may be large, else in memory."""

    def __init__(self, *, large: bool = False) -> None:
        """Begin with empty tables."""
        self._directory = tempfile.TemporaryDirectory(prefix="kinlint-") if large else None
        self._path = Path(self._directory.name, "findings.db") if self._directory else None
        self._made = sqlite3.connect(self._path or ":memory:")
        self._made.executescript(f"PRAGMA journal_mode = OFF; {SCHEMA}")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._made.close()
        if self._directory is not None:
            self._directory.cleanup()

    def add(self, report: Report) -> None:
        """Add the findings of *report*, and the files that it read."""
        put = self._made.execute
        for name in report.files:
            put("INSERT OR IGNORE INTO file VALUES (?)", (replace_surrogates(name),))
        for finding in report.findings:
            self._finding(finding)
        for error in report.errors:
            row = error.name, error.line, error.column, error.cause
            put("INSERT INTO unread VALUES (?, ?, ?, ?)", _plain(row))

    def conclude(self, report: Report) -> None:
        """Add the rules of the run, of which *report* tells all."""
        rules = {each.code: each for each in (*report.rules, *(f.rule for f in report.findings))}
        for code, each in sorted(rules.items()):
            family = Path(each.path).parent.name
            row = code, each.name, each.title, each.iri, family
            self._made.execute("INSERT OR IGNORE INTO rule VALUES (?, ?, ?, ?, ?)", _plain(row))
        run = report.version, report.root, report.catalogue
        self._made.execute("INSERT INTO run VALUES (?, ?, ?)", _plain(run))
        self._made.commit()

    def lines(self) -> Iterator[str]:
        """Yield the SQL that makes the database."""
        yield from self._made.iterdump()

    def files(self, path: Path) -> Iterator[tuple[Path, Callable[[BinaryIO], None]]]:
        """Yield *path*, and the function that writes its content."""
        yield path, self._copy

    def _copy(self, stream: BinaryIO) -> None:
        """Write the file of the database to *stream*."""
        if self._path is None:
            stream.write(self._made.serialize())
            return
        with self._path.open("rb") as made:
            shutil.copyfileobj(made, stream)

    def _finding(self, finding: Finding) -> None:
        name, *place = _where(finding.location)
        said = (
            *(name, finding.rule.code, finding.severity.label, *place, finding.message),
            *(finding.entity or None, finding.path, finding.reason or None, finding.suppressed),
            finding.fingerprint,
        )
        made = self._made.execute(ROW, _plain(said))
        for each in finding.related:
            told = made.lastrowid, *_where(each.location), each.message
            self._made.execute("INSERT INTO related VALUES (?, ?, ?, ?, ?, ?, ?)", _plain(told))


def _where(location: Location) -> tuple[str, int, int, int, int]:
    return location.source.name, *location.start, *location.end


def _plain(row: tuple[object, ...]) -> tuple[object, ...]:
    """Return *row* without lone surrogates, which SQLite does not take."""
    return tuple(replace_surrogates(each) if isinstance(each, str) else each for each in row)
