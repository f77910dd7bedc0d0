"""Options for the formats and destinations of reports, refused before any work if unusable."""

from __future__ import annotations

import os
from argparse import SUPPRESS, Namespace
from collections.abc import Iterable, Iterator
from pathlib import Path

from kinlint.cli.argument_parser import Parser, add_color, non_empty, one_of
from kinlint.cli.report_outputs import Outputs
from kinlint.configuration.config_file import Config
from kinlint.configuration.keys import OUTPUT_FORMATS, SEVERITIES, THRESHOLDS
from kinlint.configuration.value_kinds import ALIASES, unknown_message
from kinlint.errors import UsageError
from kinlint.rule import Severity

STDOUT = "-"


def add_output_options(made: Parser) -> None:
    """Add to *made* the options for what is printed and written."""
    add = made.add_argument_group("Output").add_argument
    add(
        "--output",
        metavar="FORMAT[=FILE]",
        action="append",
        type=non_empty,
        help=f"print this format, or write it to FILE (repeatable): {', '.join(OUTPUT_FORMATS)}",
    )
    add(
        "--output-format",
        type=one_of(OUTPUT_FORMATS),
        metavar="FORMAT",
        help="format of the main report (default: full)",
    )
    add(
        "-o",
        "--output-file",
        type=non_empty,
        metavar="FILE",
        help="write to FILE instead of standard output",
    )
    add(
        "--sarif-invocation",
        action="store_true",
        help="record the command line, times, directory and exit code in SARIF",
    )
    add(
        "--sarif-embed",
        action="store_true",
        help="embed the files with findings in SARIF",
    )
    for name in OUTPUT_FORMATS:
        add(f"--{name}-output", type=non_empty, metavar="FILE", help=SUPPRESS)
    add(
        "--statistics",
        action="store_true",
        help="count findings by rule instead of listing them; with -v also print times",
    )
    add(
        "--profile",
        action="store_true",
        help="list the anti-patterns that the format of each file implies and exit",
    )
    add(
        "--show",
        type=one_of(SEVERITIES, ALIASES),
        metavar="|".join(SEVERITIES),
        help="least severity that full, concise and grouped show (default: warning)",
    )
    add(
        "--fail-on",
        type=one_of(THRESHOLDS, ALIASES),
        metavar="|".join(THRESHOLDS),
        help="least severity that makes the exit code 1 (default: warning)",
    )
    add("-e", "--exit-zero", action="store_true", help="exit with 0 even if there are findings")
    add("-q", "--quiet", action="store_true", help="print no summary")
    add("-s", "--silent", action="store_true", help="print nothing but errors")
    add(
        "-v",
        "--verbose",
        action="count",
        default=0,
        help="print what was read and how, and derivations; -vv with --statistics: time by rule",
    )
    add_color(add)


def destinations(options: Namespace, project: Config, fail_on: str) -> Outputs:
    """Return the outputs that options ask for, else the environment, else *project*.

    Those for people show infos only on request, or where infos fail the run by *fail_on*.
    """
    said = os.environ.get("KINLINT_OUTPUT_FORMAT")
    if said and (problem := unknown_message(said, OUTPUT_FORMATS)):
        raise UsageError(f"KINLINT_OUTPUT_FORMAT: {problem}")
    main, copies = _outputs(options)
    path = options.output_file or os.environ.get("KINLINT_OUTPUT_FILE") or STDOUT
    return Outputs(
        main=main or said or project.output_format or "full",
        path=None if path == STDOUT else Path(path),
        copies=copies,
        show=Severity[(project.show or ("info" if fail_on == "info" else "warning")).upper()],
        color=options.color,
        statistics=options.statistics,
        quiet=options.quiet,
        silent=options.silent,
        verbose=bool(options.verbose),
        show_fixes=options.show_fixes,
        only_fixes=options.fix_only or options.diff,
        would=options.diff,
    )


def check_destinations(outputs: Outputs, read: Iterable[Path]) -> None:
    """Raise `UsageError` if two of *outputs* are one file, or one is a file that is *read*.

    Also if its directory is not there. Devices, such as `/dev/null`, take everything.
    """
    taken = {os.path.realpath(path): "is read in this run, and would be lost" for path in read}
    main = [("--output-file", outputs.path)] if outputs.path is not None else []
    for option, path in (*main, *((f"--{name}-output", path) for name, path in outputs.copies)):
        real = Path(os.path.realpath(path))
        if path.exists() and not path.is_file() and not path.is_dir():
            continue
        if (reason := taken.get(str(real))) is not None:
            raise UsageError(f"{option}: {path} {reason}")
        if real.is_dir():
            raise UsageError(f"{option}: cannot write {path}: Is a directory")
        if not real.parent.is_dir():
            raise UsageError(f"{option}: cannot write {path}: there is no directory {path.parent}")
        taken[str(real)] = "is written by another option, too"


def _outputs(options: Namespace) -> tuple[str | None, tuple[tuple[str, Path], ...]]:
    """Return the format of standard output that *options* name, and further formats with files."""
    main = [options.output_format] if options.output_format else []
    copies = list(_copies(options))
    for each in options.output or ():
        name, equals, file = each.partition("=")
        if problem := unknown_message(name, OUTPUT_FORMATS):
            raise UsageError(f"--output: {problem}")
        if equals and not file:
            raise UsageError(f"--output {each}: expected FORMAT or FORMAT=FILE")
        if file in ("", STDOUT):
            main.append(name)
        else:
            copies.append((name, Path(file)))
    if len(set(main)) > 1:
        raise UsageError(f"one format for standard output, not {' and '.join(dict.fromkeys(main))}")
    return next(iter(main), None), tuple(copies)


def _copies(options: Namespace) -> Iterator[tuple[str, Path]]:
    for name in OUTPUT_FORMATS:
        file = getattr(options, f"{name.replace('-', '_')}_output")
        if file == STDOUT:
            raise UsageError(
                f"--{name}-output: '-' is not a file; for standard output, --output-format {name}"
            )
        if file:
            yield name, Path(file)
