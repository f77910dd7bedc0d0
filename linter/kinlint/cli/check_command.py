"""`kinlint check`: finds, reads, lints and reports."""

from __future__ import annotations

import os
import sys
import time
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint import __version__
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.check_options import parser
from kinlint.cli.commands import hint
from kinlint.cli.lint_run import (
    ABNORMAL,
    CLEAN,
    FOUND,
    THRESHOLD,
    LintRun,
    exit_code,
    profiled,
    threshold,
)
from kinlint.cli.option_conflicts import check_together, check_urls
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.report_destinations import check_destinations, destinations
from kinlint.cli.report_outputs import Outputs
from kinlint.configuration.project_trust import untrusted_message
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError, UsageError
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.light_dataclasses import replace
from kinlint.phases import Phases
from kinlint.project.discovery import Found, Search
from kinlint.project.layers import Layers, cache_directory
from kinlint.report import Invocation, Report
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.cli.early_output import EarlyOutput
    from kinlint.cli.new_findings import KnownFindings

PACKAGED = ("package://", "$(find")
"""Texts by which a file names a package."""
COMPARING = (
    "baseline",
    "write_baseline",
    "prune_baseline",
    "new_from_rev",
    "new_from_merge_base",
)
"""The options that ask for what is new."""


def run(arguments: Sequence[str]) -> int:
    """Lint what *arguments* name; the exit code."""
    options = parser().read(arguments)
    if any(":=" in path for path in options.paths):
        from kinlint.cli.xacro_arguments import take_arguments  # noqa: PLC0415  few runs give any

        take_arguments(options)
    if options.version:
        sys.stdout.write(f"kinlint {__version__}\n")
        return CLEAN
    check_together(options)
    if options.endpoint is not None:
        from kinlint.cli.endpoint_check import check_store  # noqa: PLC0415  few runs ask a store

        return check_store(options)
    if options.watch:
        from kinlint.cli.watch import watch  # noqa: PLC0415  few runs stay

        return watch(options, check_once)
    return check_once(options)


def check_once(options: Namespace, settled: Callable[[Settings], None] | None = None) -> int:
    """Lint what *options* name, once; the exit code. *settled* is told by which settings."""
    began, layers = time.time(), Layers(configs(options), overrides(options))
    found = _find(options, layers)
    if options.show_files or options.profile:
        _warn(found)
        return _show_files(found) if options.show_files else _show_inherent(options, layers, found)
    settings = _settings(options, layers, found)
    _tell(() if options.silent else map(untrusted_message, layers.untrusted(found.inputs)))
    project = layers.project_config(found.inputs)
    fail_on = project.fail_on or THRESHOLD
    outputs = destinations(options, project, fail_on)
    settings = replace(settings, drawn=outputs.shows_structure)
    if settled is not None:
        settled(settings)
    known = [path for path in (options.baseline, project.baseline) if path]
    read = (*_paths(found), *settings.rules, *settings.shapes, *map(Path, known))
    check_destinations(outputs, read)
    phases = Phases()
    with phases.phase("rules"):
        book = rulebook.load(
            settings.rules, settings.shapes, cache_directory(os.environ, options.cache_dir)
        )
    Policies(settings, book.rules).check_selectors()
    if options.show_settings:
        more = {"output-format": outputs.main, "show": outputs.show.label, "fail-on": fail_on}
        more |= {"baseline": shown(Path(known[0]))} if known else {}
        return _show_settings(settings, more, found, book)
    if options.verbose:
        from kinlint.cli import verbose  # noqa: PLC0415  few runs ask for it

        _tell(verbose.lines_before(settings, book, map(layers.origin, found.inputs)))
    knowledge = _knowledge(options, layers, found, settings, book)
    wanted = None if knowledge is None else knowledge.new
    plain = wanted is None and settled is None
    early = _early_output(options, outputs, settings, found) if plain else None
    run = LintRun(settings, found, book, phases, outputs.watched, options.color, early=early)
    with phases.counting_parts(wanted=profiled(options)):
        report = run.report(options, outputs, wanted)
    report = report if knowledge is None else knowledge.apply_to(report)
    report, warnings = _names_checked(options, run.read, settings, report)
    if options.verbose:
        from kinlint.cli import verbose  # noqa: PLC0415  few runs ask for it

        _tell(verbose.lines_of_files(run.read, run.paired, settings))
        _tell(verbose.lines_after(report, settings, book))
    if not options.silent:
        _warn(found, report.passed_over)
    report, told = _told(options, report, fail_on, began)
    with phases.phase("reporting"):
        left = outputs if early is None else early.conclude(told)
        out = sys.stderr if _prints_text(options, found) else sys.stdout
        left.emit(told, out, early.written if early is not None else ())
    if options.statistics and options.verbose:
        _tell_times(phases, book)
    _tell(f"warning: {each}" for each in warnings if not (options.quiet or options.silent))
    if report.fixed and (options.diff or options.exit_non_zero_on_fix) and not report.errors:
        return FOUND
    return exit_code(replace(report, findings=()) if outputs.only_fixes else report)


def _early_output(
    options: Namespace, outputs: Outputs, settings: Settings, found: Found
) -> EarlyOutput | None:
    """Return the output that begins before the end; None where findings are not told as found."""
    more = options.show_suppressed or options.show_consequences or options.in_project
    if more or _fixing(options) or not outputs.begins_early:
        return None
    from kinlint.cli.early_output import EarlyOutput  # noqa: PLC0415  not in every format

    names = {one.name for one in found.inputs}
    return EarlyOutput(outputs, names, unsafe=settings.unsafe_fixes)


def _fixing(options: Namespace) -> bool:
    """Tell whether *options* ask to change files."""
    return options.fix or options.fix_only or options.add_ignore is not None


def _prints_text(options: Namespace, found: Found) -> bool:
    """Tell whether standard output has a patch, or the text of a model."""
    streamed = any(one.path is None for one in found.inputs)
    return options.diff or (_fixing(options) and streamed)


def _told(options: Namespace, report: Report, fail_on: str, began: float) -> tuple[Report, Report]:
    """Return *report* as it is counted and as it is told; the run began at *began*."""
    report = replace(report, fails_from=None if options.exit_zero else threshold(fail_on))
    report = report.with_suppressed() if options.show_suppressed else report
    if options.sarif_invocation or options.sarif_embed:
        call = Invocation(tuple(sys.argv[1:]), began, time.time(), exit_code(report))
        report = replace(
            report,
            invocation=call if options.sarif_invocation else None,
            embedded=options.sarif_embed,
        )
    return report, report.with_consequences() if options.show_consequences else report


def _find(options: Namespace, layers: Layers) -> Found:
    stdin = options.stdin_filename
    search = Search(
        layers.exclusions,
        force=options.force_exclude,
        stdin=shown(absolute(stdin), stdin) if stdin else "<stdin>",
        gitignored=layers.respects_gitignore,
    )
    paths = options.paths or (["-"] if stdin else ["."])
    _no_command(paths[0])
    found = search.find(paths)
    if options.only_format:
        from kinlint.project.format_filter import of_formats  # noqa: PLC0415  few runs ask for it

        found = of_formats(found, options.only_format)
    check_urls(options, found)
    if not options.in_project or options.show_files or options.profile:
        return found
    from kinlint.cli.project_mode import merge_with_project  # noqa: PLC0415  few runs look beyond what is named

    return merge_with_project(found, search.find(["."]))


def _no_command(word: str) -> None:
    """Raise `UsageError` if *word* is no path but may be the slip of a command."""
    if not os.path.lexists(word) and (meant := hint(word)):
        raise UsageError(f"'{word}' is neither a command nor a path{meant}")


def _paths(found: Found) -> Iterator[Path]:
    return (one.path for one in found.inputs if one.path is not None)


def _warn(found: Found, passed_over: Iterable[SourceError] = ()) -> None:
    for given in found.barren:
        sys.stderr.write(f"kinlint: warning: no robot models found in '{given}'\n")
    for each in passed_over:
        sys.stderr.write(f"kinlint: warning: {each.name} was not checked: {each.cause}\n")


def _names_checked(
    options: Namespace, sources: Sequence[SourceText], settings: Settings, report: Report
) -> tuple[Report, Sequence[str]]:
    if options.xacro_arg or any(word in each.text for each in sources for word in PACKAGED):
        from kinlint.cli.names_not_found import checked  # noqa: PLC0415  few runs name any

        return checked(options, sources, settings, report)
    return report, ()


def _settings(options: Namespace, layers: Layers, found: Found) -> Settings:
    return layers.settings(
        found.inputs,
        found.directories,
        rules=tuple(absolute(path) for path in options.rules or ()),
        shapes=tuple(absolute(path) for path in options.shapes or ()),
        cache=None if options.no_cache else cache_directory(os.environ, options.cache_dir),
        ignore_suppressions=options.ignore_suppressions,
        verbose=bool(options.verbose),
    )


def _knowledge(
    options: Namespace, layers: Layers, found: Found, settings: Settings, book: Rulebook
) -> KnownFindings | None:
    """Return the findings known before this run, if an option asks for new ones only."""
    project = layers.project_config(found.inputs)
    if project.baseline is None and not any(getattr(options, name) for name in COMPARING):
        return None
    from kinlint.cli.new_findings import KnownFindings, find_baseline  # noqa: PLC0415  most runs tell all

    baseline, before = find_baseline(options, project), None
    if options.new_from_rev or options.new_from_merge_base:
        from kinlint.cli.new_from_revision import FindingsAtRevision, find_revision  # noqa: PLC0415

        def settings_of(then: Found) -> Settings:
            return _settings(options, layers, then)

        revision = find_revision(options, found.inputs)
        before = FindingsAtRevision(revision, found, layers, book, settings_of).ledger(options)
    return KnownFindings(settings, book.rules, baseline, before, options)


def _tell_times(phases: Phases, book: Rulebook) -> None:
    """Write to standard error what took which time; rules by their codes."""
    from kinlint.reporters import time_profile  # noqa: PLC0415  few runs ask for it

    codes = {iri: rule.code for iri, rule in book.by_iri.items()}
    parts = {(kind, codes.get(name, name)): took for (kind, name), took in phases.parts.items()}
    sys.stderr.writelines(time_profile.render(phases.seconds))
    sys.stderr.writelines(time_profile.render_parts(parts))


def _tell(lines: Iterable[str]) -> None:
    sys.stderr.writelines(f"kinlint: {line}\n" for line in lines)


def _show_files(found: Found) -> int:
    for one in found.inputs:
        sys.stdout.write(f"{one.name}\n")
    _tell(f"error: {each}" for each in found.errors)
    return ABNORMAL if found.errors else CLEAN


def _show_inherent(options: Namespace, layers: Layers, found: Found) -> int:
    from kinlint.cli.profile_page import page  # noqa: PLC0415  front ends are slow to import

    errors: list[SourceError] = []
    sys.stdout.writelines(page(found, _settings(options, layers, found), errors))
    _tell(f"error: {each}" for each in errors)
    return ABNORMAL if errors else CLEAN


def _show_settings(settings: Settings, run: Mapping[str, str], found: Found, book: Rulebook) -> int:
    from kinlint.cli.show_settings import pages  # noqa: PLC0415

    sys.stdout.writelines(pages(settings, run, book.rules, found.inputs))
    return CLEAN
