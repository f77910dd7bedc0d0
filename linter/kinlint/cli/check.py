"""`kinlint check`: finds, reads, lints and reports."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from kinlint import __version__, rulebook
from kinlint.cli.commands import hint
from kinlint.cli.options import parser
from kinlint.cli.outputs import Outputs
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.parser import HelpShown
from kinlint.cli.settings import Layers, cache_directory
from kinlint.config import Settings
from kinlint.config_file import Config
from kinlint.config_keys import OUTPUT_FORMATS, unknown
from kinlint.discovery import Found, Search, shown
from kinlint.errors import SourceError, UsageError
from kinlint.model import Severity
from kinlint.pathglob import absolute
from kinlint.report import Report
from kinlint.rulebook import Rulebook
from kinlint.selection import Policies

CLEAN, FOUND, ABNORMAL = 0, 1, 2
THRESHOLD = "warning"


def run(arguments: Sequence[str]) -> int:
    """Lint what *arguments* name; the exit code."""
    try:
        options = parser().read(arguments)
    except HelpShown:
        return CLEAN
    if options.version:
        sys.stdout.write(f"kinlint {__version__}\n")
        return CLEAN
    layers = Layers(configs(options), overrides(options))
    found = _find(options, layers)
    if options.show_files:
        _warn(found)
        return _show_files(found)
    settings = _settings(options, layers, found)
    project = layers.project(found.inputs)
    fail_on = project.fail_on or THRESHOLD
    outputs = _outputs(options, project)
    book = rulebook.load(settings.rules, settings.shapes, settings.cache)
    Policies(settings, book.rules).check()
    if options.show_settings:
        more = {"output-format": outputs.main, "fail-on": fail_on}
        return _show_settings(settings, more, found, book)
    if options.verbose:
        _tell(settings, book)
    report = _lint(settings, found, book)
    if not options.silent:
        _warn(found)
    if options.show_suppressed:
        both = sorted((*report.findings, *report.suppressed), key=lambda one: one.sort_key)
        report = replace(report, findings=tuple(both), suppressed=())
    outputs.emit(report)
    return exit_code(report, fail_on, exit_zero=options.exit_zero)


def exit_code(report: Report, fail_on: str, *, exit_zero: bool = False) -> int:
    """0, 1 or 2: whether something could not be read, or is at least as bad as *fail_on*."""
    if report.errors:
        return ABNORMAL
    if exit_zero or fail_on == "none":
        return CLEAN
    least = Severity[fail_on.upper()]
    return FOUND if any(one.severity >= least for one in report.open) else CLEAN


def _find(options: Namespace, layers: Layers) -> Found:
    stdin = options.stdin_filename
    search = Search(
        layers.excluding,
        force=options.force_exclude,
        stdin=shown(absolute(stdin), stdin) if stdin else "<stdin>",
    )
    paths = options.paths or (["-"] if stdin else ["."])
    found = search.find(paths)
    for number, error in enumerate(found.errors):
        if error.name in paths and "did you mean" not in error.cause:
            found.errors[number] = SourceError(error.name, error.cause + hint(error.name))
    return found


def _warn(found: Found) -> None:
    for given in found.barren:
        sys.stderr.write(f"kinlint: warning: no robot models found in '{given}'\n")


def _settings(options: Namespace, layers: Layers, found: Found) -> Settings:
    cache = None if options.no_cache else options.cache_dir or cache_directory(os.environ)
    return layers.settings(
        found.inputs,
        rules=tuple(absolute(path) for path in options.rules or ()),
        shapes=tuple(absolute(path) for path in options.shapes or ()),
        cache=None if cache is None else Path(cache),
        ignore_suppressions=options.ignore_suppressions,
        verbose=options.verbose,
    )


def _outputs(options: Namespace, project: Config) -> Outputs:
    said = os.environ.get("KINLINT_OUTPUT_FORMAT")
    if said and (problem := unknown(said, OUTPUT_FORMATS)):
        raise UsageError(f"KINLINT_OUTPUT_FORMAT: {problem}")
    path = options.output_file or os.environ.get("KINLINT_OUTPUT_FILE")
    copies = (
        (name, getattr(options, f"{name.replace('-', '_')}_output")) for name in OUTPUT_FORMATS
    )
    return Outputs(
        main=options.output_format or said or project.output_format or "full",
        path=Path(path) if path else None,
        copies=tuple((name, Path(file)) for name, file in copies if file),
        color=options.color,
        statistics=options.statistics,
        quiet=options.quiet,
        silent=options.silent,
        verbose=options.verbose,
    )


def _lint(settings: Settings, found: Found, book: Rulebook) -> Report:
    from kinlint import lint  # noqa: PLC0415  engines are slow to import
    from kinlint.cli.reading import read  # noqa: PLC0415

    sources, errors = read(found.inputs, settings)
    return lint.run(sources, [*found.errors, *errors], settings, book)


def _tell(settings: Settings, book: Rulebook) -> None:
    """Say how the run goes about it: by which configuration, engine and contexts."""
    every = [settings.default, *settings.files.values()]
    origins = dict.fromkeys(choice.origin for each in every for choice in each.choices)
    cache = f"kept in {settings.cache}" if settings.cache else "compiled anew"
    lines = [
        f"rules chosen by {', '.join(origins) or 'nobody: all of them'}",
        f"contexts of release {settings.contexts}, engine {settings.engine}, rules {cache}",
    ]
    if settings.engine == "oxigraph":
        lines += [
            f"pySHACL judges a constraint of {each.owner}: {each.deferred}"
            for each in book.constraints
            if each.deferred is not None
        ]
    sys.stderr.writelines(f"kinlint: {line}\n" for line in lines)


def _show_files(found: Found) -> int:
    for one in found.inputs:
        sys.stdout.write(f"{one.name}\n")
    for error in found.errors:
        sys.stderr.write(f"kinlint: error: {error}\n")
    return ABNORMAL if found.errors else CLEAN


def _show_settings(settings: Settings, run: Mapping[str, str], found: Found, book: Rulebook) -> int:
    from kinlint.cli.show import pages  # noqa: PLC0415

    sys.stdout.writelines(pages(settings, run, book.rules, found.inputs))
    return CLEAN
