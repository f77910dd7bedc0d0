"""The output formats by name; each reporter is imported when it is asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import NamedTuple, TextIO, cast

from kinlint.errors import UsageError
from kinlint.report import Report
from kinlint.reporters import log_commands
from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.reporter import Reporter
from kinlint.reporters.summary import summary
from kinlint.reporters.terminal_style import Style, detect_style


class Format(NamedTuple):
    """An output format."""

    module: str
    """The module with its `render`."""
    machine: bool = True
    """True if machines read it: the summary goes to standard error then."""
    fixes: bool = True
    """True if it shows fixes; otherwise they are computed only where a summary counts them."""
    drawn: bool = False
    """True if it shows the structure of robots."""
    escape: str = log_commands.UNICODE
    """Escape of what would drive a terminal or a CI system."""
    commands: bool = False
    """True if it consists of commands of a CI system itself."""
    database: bool = False
    """True if a file of it is a database of SQLite, and standard output is the SQL for one."""
    early: bool = False
    """True if it has nothing but findings in their order, which can be written one by one."""


FORMATS: Mapping[str, Format] = {
    "full": Format("full", machine=False),
    "concise": Format("concise", machine=False, fixes=False, early=True),
    "grouped": Format("grouped", machine=False, fixes=False),
    "json": Format("json_array"),
    "json-lines": Format("json_lines", early=True),
    "sarif": Format("sarif.sarif_log"),
    "github": Format("github", fixes=False, commands=True),
    "gitlab": Format("gitlab", fixes=False),
    "azure": Format("azure", fixes=False, commands=True),
    "junit": Format("junit", fixes=False, escape=log_commands.ENTITY),
    "checkstyle": Format("checkstyle", fixes=False, escape=log_commands.ENTITY),
    "rdjson": Format("reviewdog.diagnostic_result"),
    "rdjsonl": Format("reviewdog.lines", early=True),
    "turtle": Format("validation_report"),
    "earl": Format("earl", fixes=False),
    "markdown": Format("markdown", fixes=False, escape=log_commands.ENTITY),
    "sqlite": Format("sqlite_database", fixes=False, database=True),
    "html": Format("html.page", drawn=True, escape=log_commands.ENTITY),
}
STATISTICS = Format("statistics", machine=False)


def reporter(name: str) -> Reporter:
    """The reporter of the format called *name*; UsageError if there is none."""
    if name not in FORMATS:
        raise UsageError(f"unknown output format '{name}'; there are {', '.join(FORMATS)}")
    return _render(FORMATS[name])


def gathers(name: str, path: Path) -> bool:
    """Tell whether a file *path* of the format *name* takes any number of findings as they come.

    Those are databases, and SARIF in parts: `*` in the name of the file stands for their number.
    """
    return FORMATS[name].database or (name == "sarif" and "*" in path.name)


def write(  # noqa: PLR0913
    report: Report,
    name: str,
    stream: TextIO,
    style: Style | None = None,
    *,
    summarise: bool = True,
    verbose: bool = False,
) -> None:
    """Write *report* to *stream* in the format called *name*.

    *style* None is what the stream can show. Formats for people end in the summary, unless
    *summarise* is false.
    """
    style = style or detect_style(stream)
    format_ = FORMATS[name]
    pieces = reporter(name)(report, style)
    if format_.machine:
        pieces = (log_commands.without_controls(piece, format_.escape) for piece in pieces)
    put(pieces, stream, None if format_.commands else format_.escape)
    if summarise and not format_.machine:
        write_summary(report, stream, style, verbose=verbose)


def write_summary(
    report: Report, stream: TextIO, style: Style | None = None, *, verbose: bool = False
) -> None:
    """Write the summary by itself: to standard error, when a machine reads standard output."""
    put(summary(report, style or detect_style(stream), verbose=verbose), stream)


def write_fixed(
    report: Report, stream: TextIO, style: Style | None = None, *, would: bool = False
) -> None:
    """Write the list of `--show-fixes`: what was fixed, or *would* be."""
    from kinlint.reporters.applied_fixes import listing  # noqa: PLC0415  few runs fix

    put(listing(report, style or detect_style(stream), would=would), stream)


def write_verdict(report: Report, stream: TextIO, *, would: bool = False) -> None:
    """Write how much was fixed, or *would* be, for a run that reports nothing else."""
    from kinlint.reporters.applied_fixes import verdict  # noqa: PLC0415  few runs fix

    put(verdict(report, would=would), stream)


def write_statistics(report: Report, stream: TextIO, style: Style | None = None) -> None:
    """Write the table of `--statistics`."""
    style = style or detect_style(stream)
    put(_render(STATISTICS)(report, style), stream)


def put(pieces: Iterable[str], stream: TextIO, escape: str | None = log_commands.UNICODE) -> None:
    """Write *pieces*, with what the stream cannot encode as escapes.

    What would be a command to a CI system is written by *escape*, if there is one.
    """
    encoding = getattr(stream, "encoding", None) or "utf-8"
    for piece in pieces if escape is None else _lines(pieces):
        text = replace_surrogates(piece)
        if escape is not None and ("::" in text or "##" in text):
            text = log_commands.without_commands(text, escape)
        if not text.isascii():
            text = text.encode(encoding, "backslashreplace").decode(encoding)
        stream.write(text)


def _lines(pieces: Iterable[str]) -> Iterator[str]:
    """Yield *pieces* put together so that each ends with a line."""
    waiting = ""
    for piece in pieces:
        if piece.endswith("\n"):
            yield waiting + piece
            waiting = ""
        else:
            waiting += piece
    yield waiting


def _render(format_: Format) -> Reporter:
    module = import_module(f"kinlint.reporters.{format_.module}")
    return cast("Reporter", module.render)
