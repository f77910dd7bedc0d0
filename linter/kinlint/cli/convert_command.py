"""`kinlint convert`: writes a robot in an XML format as a composable model."""

from __future__ import annotations

import re
import sys
from argparse import ArgumentTypeError, Namespace
from collections.abc import Sequence
from pathlib import Path

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, one_of
from kinlint.cli.check_options import STDOUT
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.report_outputs import replacing
from kinlint.configuration.settings import Settings
from kinlint.errors import UsageError
from kinlint.formats import records
from kinlint.project.discovery import Found, Search
from kinlint.project.layers import Layers

WRITTEN = tuple(each for each in records.FORMATS if each.convertible)
FORMATS = tuple(each.name for each in WRITTEN)
SUFFIXES = {suffix: each.name for each in WRITTEN for suffix in each.suffixes}
_NAMESPACE = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:[^\s<>\"{}|\\^`]*[#/:]")

DESCRIPTION = """\
Write a robot as composable JSON-LD: what its URDF, xacro or SDF says, and an SRDF given with it,
with all frames, units and axes that the format leaves to its documentation. What has no place in
the composable metamodels is told on standard error."""


def parser() -> Parser:
    """The parser of `kinlint convert`."""
    made = Parser(
        prog="kinlint convert", description=DESCRIPTION, usage="kinlint convert FILE... [options]"
    )
    made.add_positionals("paths", "FILE", "the robot; several files are one model")
    add = made.add_argument
    linting.add_output_file(made)
    add(
        "--to",
        type=one_of(FORMATS),
        metavar="|".join(FORMATS),
        help="the format (default: by the end of the name of the output file, or jsonld)",
    )
    add(
        "--namespace",
        type=_namespace,
        metavar="IRI",
        help="where the names of its parts live (default: https://example.org/ROBOT#)",
    )
    linting.add_reading_options(add)
    add("-q", "--quiet", **linting.FLAG, help="do not tell what is left out")
    return made


def run(arguments: Sequence[str]) -> int:
    """Convert what *arguments* name; the exit code."""
    options = parser().read(arguments)
    if not options.paths:
        raise UsageError("name the file of a robot to convert, or - for standard input")
    form = options.to or SUFFIXES.get(Path(options.output_file).suffix.lower(), FORMATS[0])
    found, settings = _found(options)
    _check(options.output_file, found)

    from kinlint.conversion.composition import compose  # noqa: PLC0415
    from kinlint.conversion.output import WRITERS  # noqa: PLC0415
    from kinlint.formats.dependencies.joined_documents import join_companions  # noqa: PLC0415
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415
    from kinlint.formats.registry import read  # noqa: PLC0415
    from kinlint.project.reading import read_models  # noqa: PLC0415  engines are slow to import

    sources, errors = read_models(found.inputs, settings)
    for error in (*found.errors, *errors):
        raise error
    reading = ReadOptions.from_settings(settings)
    documents = join_companions([read(source, reading) for source in sources], settings.partner)
    model = compose(documents, options.namespace)
    text = WRITERS[form](model)
    if options.output_file == STDOUT:
        sys.stdout.write(text)
    else:
        with replacing(Path(options.output_file)) as stream:
            stream.write(text)
    if not options.quiet:
        sys.stderr.writelines(f"kinlint: left out: {loss}\n" for loss in model.losses)
    return 0


def _found(options: Namespace) -> tuple[Found, Settings]:
    """The files that *options* name, and how `kinlint check` would read them."""
    said = [f"--package={each}" for each in options.package or ()]
    said += [f"--xacro-arg={each}" for each in options.xacro_arg or ()]
    same = linting.parser().read([*said, "--", *options.paths])
    layers = Layers(configs(same), overrides(same))
    found = Search(layers.exclusions).find(options.paths)
    return found, layers.settings(found.inputs)


def _check(output: str, found: Found) -> None:
    """Raise `UsageError` where nothing is to be read, or where it would be written over."""
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    taken = {one.path.resolve() for one in found.inputs if one.path is not None}
    if output != STDOUT and Path(output).resolve() in taken:
        raise UsageError(f"-o: {output} is read in this run, and would be lost")


def _namespace(text: str) -> str:
    if not _NAMESPACE.fullmatch(text):
        raise ArgumentTypeError(f"expected an IRI that ends with # or /, got '{text}'")
    return text
