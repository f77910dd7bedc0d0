"""`kinlint targets --matrix`: the features of robots by consumers, as a table."""

from __future__ import annotations

import json
import shutil
import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TextIO

from kinlint import lint
from kinlint.cli.check_options import STDOUT
from kinlint.cli.model_inputs import find_inputs, read_inputs
from kinlint.cli.output_files import replacing
from kinlint.errors import UsageError
from kinlint.facts.written_features import HAS
from kinlint.findings.locator import Locator
from kinlint.formats.dependencies.companions import pair
from kinlint.formats.unread_text import refuse_unread
from kinlint.light_dataclasses import replace
from kinlint.pipeline.analyzer import Examination
from kinlint.reporters.feature_matrix import FeatureMatrix
from kinlint.reporters.matrix_table import table
from kinlint.reporters.reporter_registry import put
from kinlint.reporters.terminal_style import Style, detect_style
from kinlint.targets.chosen_target import Target, chosen_targets
from kinlint.targets.consumer_files import consumer_table
from kinlint.terms import iri_value
from kinlint.text import Location
from kinlint.vocabulary import FEATURE

WIDE = 120
"""Number of columns of a table that goes to a file."""


def print_matrix(options: Namespace) -> None:
    """Print the features of the robot in `options.paths` by the targets `options.names`.

    Raises `UsageError` where no robot is named, and `SourceError` for what cannot be read.
    """
    matrix = _matrix(options)
    path = None if options.output_file == STDOUT else Path(options.output_file)
    form = options.output_format or {".html": "html", ".json": "json"}.get(
        path.suffix.lower() if path else "", "text"
    )
    if path is None:
        put(_pieces(matrix, form, options.paths, sys.stdout), sys.stdout)
    else:
        with replacing(path) as stream:
            put(_pieces(matrix, form, options.paths, None), stream)


def _matrix(options: Namespace) -> FeatureMatrix:
    found, settings = find_inputs(options)
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    sources, book = read_inputs(found, settings, options)
    targets = _targets(options.names)
    # Constraints that speak of targets are checked where a run has some.
    own = replace(settings.default, targets=tuple(each.text for each in targets))
    files = {name: replace(each, targets=own.targets) for name, each in settings.files.items()}
    settings = replace(settings, drawn=False, default=own, files=files)
    examined = lint.examine(pair(sources, settings), (), settings, book)
    for error in examined.report.errors:
        raise error
    refuse_unread(examined.documents)
    written = list(_written(examined))
    known = {feature for feature, _ in written}
    told = (each for each in examined.builder.brief() if each.feature not in known)
    written += [(each.feature, each.location) for each in told if each.feature]
    formats = {
        source.name: each.format
        for each in examined.documents
        for source in (each.source, *(piece for _, piece in each.pieces))
    }
    return FeatureMatrix.of(written, targets, formats)


def _written(examined: Examination) -> Iterator[tuple[str, Location]]:
    """Yield the features that the vocabulary finds, each with a place."""
    locator = Locator(examined.documents, examined.store)
    for place, way, feature in examined.store.facts():
        if way == HAS and (found := locator.node(place)) is not None:
            yield iri_value(feature).removeprefix(FEATURE), found


def _targets(names: Sequence[str]) -> Sequence[Target]:
    """Return the targets that *names* spell; by default the newest of all consumers."""
    if names:
        return chosen_targets(names)
    consumers = consumer_table().consumers.values()
    return tuple(Target(each.name) for each in consumers if not each.members)


def _pieces(
    matrix: FeatureMatrix, form: str, paths: Sequence[str], stream: TextIO | None
) -> Iterator[str]:
    if form == "json":
        return iter([json.dumps(matrix.to_json(), indent=2, ensure_ascii=False), "\n"])
    if form == "html":
        from kinlint.reporters.html.matrix_page import matrix_page  # noqa: PLC0415

        return matrix_page(matrix, ", ".join(paths))
    if stream is None:
        return table(matrix, Style(), WIDE)
    wide = shutil.get_terminal_size((WIDE, 24)).columns if stream.isatty() else WIDE
    return table(matrix, detect_style(stream, "auto"), wide)
