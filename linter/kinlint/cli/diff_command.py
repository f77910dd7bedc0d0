"""`kinlint diff`: compares two descriptions of robots."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Collection, Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, add_color, one_of
from kinlint.cli.check_options import STDOUT
from kinlint.cli.model_inputs import add_input_options
from kinlint.cli.output_files import replacing
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.errors import UsageError
from kinlint.reporters.reporter_registry import put
from kinlint.reporters.terminal_style import Style, detect_style
from kinlint.robot_difference import RobotDifference

if TYPE_CHECKING:
    from kinlint.cli.described_robots import Place
    from kinlint.facts.comparison.part_changes import Side

TEXT, MARKDOWN, JSON, HTML = FORMATS = ("text", "markdown", "json", "html")
EXACT, ROUNDED = TOLERANCES = ("exact", "rounded")
SUFFIXES = {".md": MARKDOWN, ".json": JSON, ".html": HTML}
"""The format by the suffix of the output file; for others it is text."""

DESCRIPTION = """\
Compare two descriptions of a robot, in any two formats, or two revisions of one: joints, axes,
placements, limits, masses, inertias and collision shapes. Parts are matched by name, or else by
structure and numbers. Links that one file merges, frames that it draws elsewhere and another root
do not count. OLD and NEW are files, both directories, whose files are compared pairwise by
name, or REVISION:PATH of the git repository here."""

EPILOG = """\
Example: kinlint diff HEAD~1:arm.urdf arm.urdf --format markdown
Exit code: 0 the same robot; 1 differences; 2 if something cannot be read."""


def parser() -> Parser:
    """The parser of `kinlint diff`."""
    made = Parser(
        prog="kinlint diff",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint diff OLD NEW [options]",
    )
    made.add_positionals("paths", "OLD NEW", "files, directories, or REVISION:PATH")
    add = made.add_argument
    add(
        "--output-format",
        type=one_of(FORMATS),
        metavar="|".join(FORMATS),
        help="format (default: by the suffix of the output file, or text)",
    )
    linting.add_output_file(made)
    add(
        "--tolerance",
        type=one_of(TOLERANCES),
        metavar="|".join(TOLERANCES),
        help="exact: every number counts (default for files of one format); rounded: 1 percent, "
        "1 mm and 2 mrad do not (default for two formats)",
    )
    add_input_options(add, "add the vocabulary of the rules in DIR")
    add_color(add)
    return made


def run(arguments: Sequence[str]) -> int:
    """Compare what *arguments* name; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if len(options.paths) != 2:  # noqa: PLR2004  old and new
        raise UsageError("name two files or directories to compare: kinlint diff OLD NEW")
    output = None if options.output_file == STDOUT else Path(options.output_file)
    from kinlint.cli.described_robots import located  # noqa: PLC0415  engines are slow to import

    with ExitStack() as stack:
        old, new = (stack.enter_context(located(each)) for each in options.paths)
        differences = list(_differences(old, new, options))
    suffix = output.suffix.lower() if output is not None else ""
    form = options.output_format or SUFFIXES.get(suffix, TEXT)
    if output is None:
        put(_written(differences, form, detect_style(sys.stdout, options.color)), sys.stdout)
    else:
        with replacing(output) as stream:
            put(_written(differences, form, Style()), stream)
    return int(any(each.differs for each in differences))


def _differences(old: Place, new: Place, options: Namespace) -> Iterator[RobotDifference]:
    """Yield the difference of each pair of files, in the order of their names."""
    from kinlint.cli.described_robots import RobotReader  # noqa: PLC0415

    readers = RobotReader(old, options), RobotReader(new, options)
    folders = [each.path.is_dir() for each in (old, new)]
    if not any(folders):
        yield _difference(readers[0].only(), readers[1].only(), options.tolerance)
        return
    if not all(folders):
        raise UsageError("compare two files or two directories, not one with the other")
    inputs = [each.inputs() for each in readers]
    for before, after in _pairs(inputs[0], inputs[1]):
        one, other = (
            reader.robot(own[name]) if name else None
            for reader, own, name in zip(readers, inputs, (before, after), strict=True)
        )
        if one is not None and other is not None:
            yield _difference(one, other, options.tolerance)
        elif one is not None or other is not None:
            yield RobotDifference(one.name if one else "", other.name if other else "")


def _pairs(old: Collection[str], new: Collection[str]) -> Iterator[tuple[str, str]]:
    """Yield the names of files that belong together; "" for none.

    Those of one name, and of the rest those that differ in their suffix alone.
    """
    left = {name for name in new if name not in old}
    stems: dict[PurePath, list[str]] = {}
    for name in sorted(left):
        stems.setdefault(_stem(name), []).append(name)
    for name in sorted(old):
        if name in new:
            yield name, name
        elif found := stems.get(_stem(name)):
            left.discard(found[0])
            yield name, found.pop(0)
        else:
            yield name, ""
    for name in sorted(left):
        yield "", name


def _stem(name: str) -> PurePath:
    path = PurePath(name)
    return path.with_name(path.name.partition(".")[0])


def _difference(old: Side, new: Side, tolerance: str | None) -> RobotDifference:
    from kinlint.facts.comparison import tolerances  # noqa: PLC0415
    from kinlint.facts.comparison.robot_changes import robot_difference  # noqa: PLC0415

    same = old.robot.form == new.robot.form
    exact = tolerance == EXACT or (tolerance is None and same)
    return robot_difference(old, new, tolerances.EXACT if exact else tolerances.EXPORTED)


def _written(differences: Sequence[RobotDifference], form: str, style: Style) -> Iterator[str]:
    """Return the report in the format called *form*, piece by piece."""
    if form == MARKDOWN:
        from kinlint.reporters.difference.difference_markdown import (  # noqa: PLC0415
            render_markdown,
        )

        return render_markdown(differences)
    if form == JSON:
        from kinlint.reporters.difference.difference_json import render_json  # noqa: PLC0415

        return render_json(differences)
    if form == HTML:
        from kinlint.reporters.difference.difference_page import render_page  # noqa: PLC0415

        return render_page(differences)
    from kinlint.reporters.difference.difference_text import render_text  # noqa: PLC0415

    return render_text(differences, style)
