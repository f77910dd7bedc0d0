"""`kinlint convert`: writes a robot in an XML format as a composable model."""

from __future__ import annotations

import re
import sys
from argparse import ArgumentTypeError, Namespace
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, one_of
from kinlint.cli.check_options import STDOUT
from kinlint.cli.output_files import replacing
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.xacro_arguments import check_arguments, take_arguments
from kinlint.configuration.settings import Settings
from kinlint.conversion.rotations import ROTATIONS
from kinlint.errors import UsageError
from kinlint.formats import records
from kinlint.project.discovery import Found, Search
from kinlint.project.layers import Layers

WRITTEN = tuple(each for each in records.FORMATS if each.convertible)
FORMATS = tuple(each.name for each in WRITTEN)
SUFFIXES = {suffix: each.name for each in WRITTEN for suffix in each.suffixes}
FIRST_SUFFIX = {each.name: each.suffixes[0] for each in WRITTEN}
"""The end of the names of files of each format, where no name is given."""
_NAMESPACE = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:[^\s<>\"{}|\\^`]*[#/:]")

DESCRIPTION = """\
Convert a URDF, xacro, SDF, MJCF, USD or COLLADA file, and an SRDF given with it, to composable
JSON-LD. Frames, units and axes that the format leaves to its documentation are written out.
Elements that the composable metamodels cannot express are listed on standard error. If the output
is a directory (its name ends with / or has no suffix), skeleton, spatial relations, coordinates,
kinematic chain, dynamics, actuation and shapes are separate files in it."""


def parser() -> Parser:
    """The parser of `kinlint convert`."""
    made = Parser(
        prog="kinlint convert", description=DESCRIPTION, usage="kinlint convert FILE... [options]"
    )
    made.add_positionals("paths", "FILE", "robot description; several files are one model")
    add = made.add_argument
    linting.add_output_file(
        made, "FILE|DIR", "write to FILE, or one file per domain of the model to DIR"
    )
    add(
        "--to",
        type=one_of(FORMATS),
        metavar="|".join(FORMATS),
        help="format (default: by the suffix of the output file, or jsonld)",
    )
    add(
        "--rotation",
        type=one_of(ROTATIONS),
        metavar="|".join(ROTATIONS),
        default=ROTATIONS[0],
        help=f"representation of rotations (default: {ROTATIONS[0]})",
    )
    add(
        "--namespace",
        type=_namespace,
        metavar="IRI",
        help="namespace of the names in the model (default: https://example.org/ROBOT#)",
    )
    linting.add_reading_options(add)
    add("-q", "--quiet", **linting.FLAG, help="do not list what cannot be expressed")
    return made


def run(arguments: Sequence[str]) -> int:
    """Convert what *arguments* name; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if not options.paths:
        raise UsageError("name the file of a robot to convert, or - for standard input")
    output = options.output_file
    form = options.to or _format_of(output)
    found, settings = _found(options)
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    _check([Path(output)] if output != STDOUT else [], found)

    from kinlint.conversion.composition import compose  # noqa: PLC0415
    from kinlint.conversion.domain_files import split_by_domain  # noqa: PLC0415
    from kinlint.conversion.output import WRITERS  # noqa: PLC0415
    from kinlint.formats.dependencies.joined_documents import join_companions  # noqa: PLC0415
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415
    from kinlint.formats.registry import read  # noqa: PLC0415
    from kinlint.project.reading import read_models  # noqa: PLC0415  engines are slow to import

    sources, errors = read_models(found.inputs, settings)
    for error in (*found.errors, *errors):
        raise error
    check_arguments(options, sources, settings)
    reading = ReadOptions.from_settings(settings)
    documents = join_companions([read(source, reading) for source in sources], settings.partner)
    model = compose(documents, options.namespace, options.rotation)
    write = WRITERS[form]
    if output == STDOUT:
        sys.stdout.write(write(model))
    elif _is_directory(output):
        parts = split_by_domain(model)
        texts = {
            Path(output, name + FIRST_SUFFIX[form]): write(part) for name, part in parts.items()
        }
        _check(texts, found)
        _make_directory(Path(output))
        _write(texts)
    else:
        _write({Path(output): write(model)})
    if not options.quiet:
        sys.stderr.writelines(f"kinlint: left out: {loss}\n" for loss in model.losses)
    return 0


def _format_of(output: str) -> str:
    """Return the format in which *output* is written. Raises `UsageError` for another's suffix."""
    suffix = Path(output).suffix.lower()
    if output == STDOUT or suffix == ".json" or _is_directory(output):
        return FORMATS[0]
    if suffix not in SUFFIXES:
        known = ", ".join(f"{FIRST_SUFFIX[each]} ({each})" for each in FORMATS)
        raise UsageError(f"-o {output}: a model is written as {known}; --to says which")
    return SUFFIXES[suffix]


def _is_directory(output: str) -> bool:
    """Tell whether *output* names a directory, there or to be made."""
    path = Path(output)
    return path.is_dir() or (not path.exists() and (output.endswith("/") or not path.suffix))


def _make_directory(path: Path) -> None:
    """Make the directory at *path* if it is not there."""
    try:
        path.mkdir(exist_ok=True)
    except OSError as error:
        raise UsageError(f"cannot make directory {path}: {error.strerror or error}") from None


def _write(texts: Mapping[Path, str]) -> None:
    """Write *texts* to their files."""
    for path, text in texts.items():
        with replacing(path) as stream:
            stream.write(text)


def _found(options: Namespace) -> tuple[Found, Settings]:
    """The files that *options* name, and how `kinlint check` would read them."""
    said = [f"--package={each}" for each in options.package or ()]
    said += [f"--xacro-arg={each}" for each in options.xacro_arg or ()]
    same = linting.parser().read([*said, "--", *options.paths])
    layers = Layers(configs(same), overrides(same))
    found = Search(layers.exclusions, gitignored=layers.respects_gitignore).find(options.paths)
    return found, layers.settings(found.inputs, found.directories)


def _check(outputs: Iterable[Path], found: Found) -> None:
    """Raise `UsageError` where one of *outputs* would take the place of what is read."""
    taken = {one.path.resolve() for one in found.inputs if one.path is not None}
    for path in outputs:
        if path.resolve() in taken:
            raise UsageError(f"-o: {path} is read in this run, and would be lost")


def _namespace(text: str) -> str:
    if not _NAMESPACE.fullmatch(text):
        raise ArgumentTypeError(f"expected an IRI that ends with # or /, got '{text}'")
    return text
