"""Models that a command reads as `kinlint check` does: the options, the files and their texts."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import non_empty
from kinlint.cli.check_options import STDOUT
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.xacro_arguments import check_arguments
from kinlint.configuration.settings import Settings
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Found, Search
from kinlint.project.layers import Layers, cache_directory
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.cli.progress import ProgressBar

PASSED = ("select", "extend_select", "ignore", "target", "rules", "config", "package", "xacro_arg")
"""Options that mean what they mean to `kinlint check`."""


def add_input_options(add: Callable[..., object], rules: str) -> None:
    """Add, by *add*, the options for what is read; *rules* is the help of `--rules`."""
    add("--rules", metavar="DIR", **linting.TEXTS, help=rules)
    add(
        "--config",
        metavar="PATH|KEY=VALUE",
        **linting.TEXTS,
        help="use this configuration file, or set a key",
    )
    add("--isolated", **linting.FLAG, help="ignore configuration files")
    linting.add_reading_options(add)
    add("--stdin-filename", type=non_empty, metavar="F", help="file name to use for standard input")
    add("--cache-dir", type=non_empty, metavar="DIR", help="cache directory")


def find_inputs(options: Namespace) -> tuple[Found, Settings]:
    """The files that *options* name, and how `kinlint check` would lint them."""
    said = [
        f"--{name.replace('_', '-')}={each}"
        for name in PASSED
        for each in getattr(options, name, None) or ()
    ]
    paths = options.paths or [STDOUT]
    same = linting.parser().read([*said, *["--isolated"] * options.isolated, "--", *paths])
    layers = Layers(configs(same), overrides(same))
    name = options.stdin_filename
    stdin = shown(absolute(name), name) if name else "<stdin>"
    search = Search(layers.exclusions, stdin=stdin, gitignored=layers.respects_gitignore)
    found = search.find(paths)
    settings = layers.settings(
        found.inputs,
        found.directories,
        rules=tuple(absolute(path) for path in options.rules or ()),
    )
    return found, replace(settings, drawn=True)


def read_inputs(
    found: Found, settings: Settings, options: Namespace, bar: ProgressBar | None = None
) -> tuple[Sequence[SourceText], Rulebook]:
    """Return the texts of *found*, counted by *bar*, and the rules.

    Raises `SourceError` for what cannot be read.
    """
    from kinlint.project.reading import read_models  # noqa: PLC0415  help does without

    inputs = found.inputs if bar is None else bar.reading(found.inputs)
    sources, errors = read_models(inputs, settings)
    for error in (*found.errors, *errors):
        raise error
    check_arguments(options, sources, settings)
    cache = cache_directory(os.environ, options.cache_dir)
    return sources, rulebook.load(settings.rules, settings.shapes, cache)
