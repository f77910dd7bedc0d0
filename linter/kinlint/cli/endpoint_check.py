"""`kinlint check --endpoint`: lints the models of a triple store, one batch at a time."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from datetime import UTC, datetime
from pathlib import Path
from time import perf_counter

from kinlint.catalogue import rulebook
from kinlint.cli.gathered_outputs import GatheredOutputs
from kinlint.cli.lint_run import (
    THRESHOLD,
    exit_code,
    process_count,
    threshold,
)
from kinlint.cli.overrides import configs, overrides
from kinlint.cli.progress import ProgressBar
from kinlint.cli.report_destinations import check_destinations, destinations
from kinlint.cli.report_outputs import Outputs
from kinlint.configuration.selection import Policies
from kinlint.endpoint.connection import Endpoint
from kinlint.endpoint.judging import Judge, StoredModel, judge_all, together
from kinlint.endpoint.pushing import Asking, Found
from kinlint.endpoint.stored_graphs import StoredGraph, graph_name, models
from kinlint.errors import UsageError
from kinlint.files.pathglob import absolute
from kinlint.light_dataclasses import replace
from kinlint.parallel.early_findings import counted
from kinlint.project.discovery import Input
from kinlint.project.layers import Layers, cache_directory
from kinlint.report import Report
from kinlint.rule import Rule
from kinlint.terms import Term

OF_FILES = (
    *("fix", "fix_only", "diff", "add_ignore", "watch", "in_project", "new_from_rev"),
    *("new_from_merge_base", "baseline", "write_baseline", "prune_baseline", "report_bug"),
    *("profile", "show_files", "stdin_filename", "show_settings"),
)
"""Options that are about files."""


def check_store(options: Namespace) -> int:
    """Lint the models of the store that *options* name; the exit code."""
    _check(options)
    started = perf_counter()
    store = Endpoint.from_options(options, os.environ)
    names = [graph_name(each, "--graph") for each in options.graph or ()]
    scratch = options.scratch_graph and graph_name(options.scratch_graph, "--scratch-graph")
    found = models(store, names, _since(options.since))
    layers = Layers(configs(options), overrides(options))
    files = [Input(each.file, absolute(each.file)) for one in found for each in one if each.file]
    here = Path.cwd()
    inputs = [each for each in files if each.path and each.path.is_relative_to(here)]
    settings = layers.settings(
        inputs,
        rules=tuple(absolute(path) for path in options.rules or ()),
        shapes=tuple(absolute(path) for path in options.shapes or ()),
        ignore_suppressions=options.ignore_suppressions,
        verbose=bool(options.verbose),
    )
    project = layers.config_for(here)
    fail_on = project.fail_on or THRESHOLD
    outputs = destinations(options, project, fail_on)
    check_destinations(outputs, (*settings.rules, *settings.shapes))
    cache = cache_directory(os.environ, options.cache_dir)
    book = rulebook.load(settings.rules, settings.shapes, cache)
    Policies(settings, book.rules).check_selectors()
    judge = Judge(store, replace(settings, drawn=outputs.shows_structure), book, frozenset(names))
    asked = Policies(settings, book.rules).enabled([each.name for each in inputs] or [""])
    graphs = _concerned(Asking(store, book, asked), found, scratch, outputs, options)
    rules = tuple(each for each in book.rules if each.code in asked)
    left, idle = _divided(found, graphs, rules)
    with ExitStack() as ending:
        bar = ProgressBar(len(left), wanted=outputs.watched, color=options.color)
        ending.enter_context(bar)
        reports = judge_all(judge, left, process_count(options), lambda done: bar.advance(2 * done))
        streams, made = outputs.streams, None
        if streams and outputs.copies:
            made = ending.enter_context(GatheredOutputs(outputs.copies, large=True))
        told = list(_told(reports, options, outputs, bar, made))
        report = replace(
            together([*(report for report, _ in told), idle], perf_counter() - started),
            unsafe=False,
            catalogue=book.digest,
            fails_from=None if options.exit_zero else threshold(fail_on),
        )
        if made is not None:
            made.conclude(report)
            outputs = replace(outputs, copies=())
    written = {name for _, early in told for name in early}
    outputs.emit(report, sys.stdout, written)
    return exit_code(report)


def _concerned(
    asking: Asking,
    found: Sequence[StoredModel],
    scratch: Term | None,
    outputs: Outputs,
    options: Namespace,
) -> Found:
    """Return the graphs in which rules may find anything, with progress by rule."""
    formats = {graph.format for one in found for graph in one[:1] if _is_alone(one)}
    with ProgressBar(len(asking.codes), wanted=outputs.watched, color=options.color) as bar:
        told = replace(
            asking,
            tell=_say if options.verbose else asking.tell,
            warn=_say,
            begin=lambda what: bar.advance(2, f"Asking the store for {what}"),
        )
        return told.concerned(sorted(formats), scratch)


def _divided(
    found: Sequence[StoredModel], graphs: Found, rules: tuple[Rule, ...]
) -> tuple[Sequence[StoredModel], Report]:
    """Return the models in which something may be found, and the report of the others."""
    sure, left = list[StoredGraph](), list[StoredModel]()
    for one in found:
        concerned = graphs.get(one[0].format) if _is_alone(one) else None
        if concerned is None or one[0].name in concerned:
            left.append(one)
        else:
            sure.append(one[0])
    if not sure:
        return found, Report()
    files = tuple(each.file for each in sure if each.file)
    return left, Report(files=files, rules=rules, applied=len(rules))


def _is_alone(model: StoredModel) -> bool:
    """Tell whether all that a model states is what one graph states.

    That is not so of models that are several graphs, or that kinlint did not load.
    """
    return len(model) == 1 and model[0].whole


def _say(line: str) -> None:
    sys.stderr.write(f"kinlint: {line}\n")


def _check(options: Namespace) -> None:
    """Raise `UsageError` for options that mean nothing for a store."""
    if options.paths:
        raise UsageError(f"--endpoint or files, such as '{options.paths[0]}', not both")
    for name in OF_FILES:
        if getattr(options, name, None) not in (None, False):
            raise UsageError(f"--{name.replace('_', '-')} is for files, not for --endpoint")


def _since(said: str | None) -> str | None:
    """Return the revision, or the time in UTC, that is *said*. Raises `UsageError` for others.

    A time without a zone is a local one, as git has it; a date is its beginning.
    """
    if said is None or said.isdecimal():
        return said
    try:
        return datetime.fromisoformat(said).astimezone(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
    except (ValueError, OverflowError):
        kinds = "a revision or a time such as 2026-01-31T12:00:00Z"
        raise UsageError(f"--since: expected {kinds}, got '{said}'") from None


def _told(
    reports: Iterator[Report],
    options: Namespace,
    outputs: Outputs,
    bar: ProgressBar,
    made: GatheredOutputs | None,
) -> Iterator[tuple[Report, Sequence[str]]]:
    """Yield *reports*, each with the files whose findings are written, to what *made* gathers, too.

    Of those, only what a summary counts is kept, so that the memory of a run does not grow with
    the texts.
    """
    for report in reports:
        if options.show_suppressed:
            both = sorted((*report.findings, *report.suppressed), key=lambda one: one.sort_key)
            report = replace(report, findings=tuple(both), suppressed=())  # noqa: PLW2901
        if options.show_consequences:
            report = report.with_consequences()  # noqa: PLW2901
        if not outputs.streams:
            yield report, ()
            continue
        if made is not None:
            made.add(report)
        if report.findings and not outputs.silent:
            bar.step_aside(lambda each: outputs.begin(each, sys.stdout), report)
        yield counted(report), [each.location.source.name for each in report.findings]
