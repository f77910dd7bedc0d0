"""`kinlint graph`: draws the kinematic structure of robots, with what is found of each part."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, add_color, one_of
from kinlint.cli.check_options import STDOUT
from kinlint.cli.model_inputs import add_input_options, find_inputs, read_inputs
from kinlint.cli.output_files import replacing
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError, UsageError
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Found
from kinlint.report import Report
from kinlint.reporters.picture.formats import FORMATS, SUFFIXES, pieces
from kinlint.reporters.reporter_registry import put
from kinlint.reporters.terminal_style import Style, detect_style
from kinlint.rule import Severity

TURTLE, HTML = "turtle", "html"
"""The formats of the graph itself, and of the page with the pictures and the findings."""
LAYERS = ("source", "lifted", "closure", "facts")
"""Layers of the graph: what files state, and what is lifted, inferred and computed from it."""

DESCRIPTION = """\
Draw the links (boxes) and joints (ellipses) of robots; connections that close a loop are dashed.
Findings of `kinlint check` are marked on the parts that they are about. `svg` and `html` also show
the robot in three dimensions, with all joints at zero. `--output-format turtle` writes the graph
that rules see, with the place of each node."""

EPILOG = "Exit code: 0 drawn, whatever was found; 2 if a file cannot be read or has no robot."


def parser() -> Parser:
    """The parser of `kinlint graph`."""
    made = Parser(
        prog="kinlint graph",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint graph FILE... [options]",
    )
    made.add_positionals("paths", "FILE", "robot descriptions; - is standard input")
    add = made.add_argument
    add(
        "--output-format",
        type=one_of((*FORMATS, HTML, TURTLE)),
        metavar="|".join((*FORMATS, HTML, TURTLE)),
        help="format (default: by the suffix of the output file, or text)",
    )
    linting.add_output_file(made)
    add(
        "--layer",
        type=one_of(("all", *LAYERS)),
        metavar="|".join(("all", *LAYERS)),
        default="all",
        help="of turtle: statements of files, lifted, inferred or computed ones (default: all)",
    )
    add("--frames", **linting.FLAG, help="draw the frames of links too")
    add("--no-findings", **linting.FLAG, help="draw the robots without findings")
    add("--select", metavar="R", **linting.LISTS, help="mark only findings of these rules")
    add("--extend-select", metavar="R", **linting.LISTS, help="mark findings of these rules too")
    add("--ignore", metavar="R", **linting.LISTS, help="do not mark findings of these rules")
    add("--target", metavar="NAME", **linting.LISTS, help="also check for this consumer")
    add_input_options(add, "add the rule files in DIR")
    add_color(add)
    return made


def run(arguments: Sequence[str]) -> int:
    """Draw what *arguments* name; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if not options.paths and not options.stdin_filename:
        raise UsageError("name the file of a robot to draw, or - for standard input")
    output = options.output_file
    path = None if output == STDOUT else Path(output)
    form = options.output_format or _format_of(path)
    found, settings = find_inputs(options)
    _check(path, found)
    if form == TURTLE:
        from kinlint.cli.model_graph import read_graph, turtle  # noqa: PLC0415  engines are slow

        layers = LAYERS if options.layer == "all" else (options.layer,)
        text = turtle(read_graph(found, settings, options), layers)
        if path is None:
            put(text, sys.stdout)
        else:
            with replacing(path) as stream:
                put(text, stream)
        return 0
    report = _report(found, settings, options)
    if path is None:
        style = detect_style(sys.stdout, options.color)
        put(_drawn(report, form, style, frames=options.frames), sys.stdout)
    else:
        with replacing(path) as stream:
            put(_drawn(report, form, Style(), frames=options.frames), stream)
    return 0


def _drawn(report: Report, form: str, style: Style, *, frames: bool) -> Iterator[str]:
    """Return the robots of *report* in the format called *form*, piece by piece."""
    if form != HTML:
        return pieces(report, form, style, frames=frames)
    from kinlint.reporters.html.page import render  # noqa: PLC0415  pictures need no page

    return render(report, style, frames=frames)


def _format_of(path: Path | None) -> str:
    """The format that the name of a file stands for; UsageError if nobody can tell."""
    suffix = "" if path is None else path.suffix.lower()
    if suffix in {".ttl", ".html"}:
        return TURTLE if suffix == ".ttl" else HTML
    if suffix not in SUFFIXES:
        formats = "|".join(FORMATS)
        raise UsageError(
            f"-o: no format is called '{suffix}'; --output-format {formats} says which"
        )
    return SUFFIXES[suffix]


def _check(output: Path | None, found: Found) -> None:
    """Raise `UsageError` where nothing is to be read, or where it would be written over."""
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    taken = {one.path.resolve() for one in found.inputs if one.path is not None}
    if output is not None and output.resolve() in taken:
        raise UsageError(f"-o: {output} is read in this run, and would be lost")


def _report(found: Found, settings: Settings, options: Namespace) -> Report:
    """Return the report to draw. Raises `SourceError` for what cannot be read or has no robot."""
    from kinlint import lint  # noqa: PLC0415  engines are slow to import
    from kinlint.formats.dependencies.companions import pair  # noqa: PLC0415

    sources, book = read_inputs(found, settings, options)
    Policies(settings, book.rules).check_selectors()
    if options.no_findings:
        book = replace(book, rules=(), constraints=())
    report = lint.run(pair(sources, settings), (), settings, book)
    for error in report.errors:
        raise error
    if not report.structures:
        what = "it describes no link and no joint"
        if len(sources) > 1:
            raise UsageError(f"no robot to draw in {len(sources):,} files: no link and no joint")
        wrong = (one for one in report.findings if one.severity is Severity.ERROR)
        if (first := next(wrong, None)) is not None:
            what += f" ({first.rule.code}: {first.message})"
        raise SourceError(sources[0].name if sources else str(options.paths[0]), what)
    return report
