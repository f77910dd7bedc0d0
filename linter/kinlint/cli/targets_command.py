"""`kinlint targets`: lists consumers of robot descriptions, and what they make of features."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from typing import Any

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, one_of
from kinlint.cli.model_inputs import add_input_options
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.errors import UsageError
from kinlint.reporters.reporter_registry import put
from kinlint.targets.chosen_target import checked_target, chosen_targets
from kinlint.targets.consumer import Consumer, ConsumerTable
from kinlint.targets.consumer_files import consumer_table

FORMATS = ("text", "json", "html")


def parser() -> Parser:
    """The parser of `kinlint targets`."""
    made = Parser(
        prog="kinlint targets",
        description="List the consumers that --target accepts, or show how some of them treat"
        " features of robot descriptions: in which versions, and by which source.",
        usage="kinlint targets [NAME[@VERSION]...] [--matrix FILE]... [--output-format F]",
    )
    made.add_positionals("names", "NAME[@VERSION]", "consumer to show; by default, all")
    add = made.add_argument
    add(
        "--matrix",
        metavar="FILE",
        dest="paths",
        **linting.TEXTS,
        help="print a table of the features of the robot in FILE by consumers",
    )
    add("--output-format", type=one_of(FORMATS), metavar="|".join(FORMATS), help="format")
    linting.add_output_file(made)
    add_input_options(add, "add the rule files in DIR")
    return made


def run(arguments: Sequence[str]) -> int:
    """Print what *arguments* ask for; the exit code."""
    options = parser().read(arguments)
    options.paths = options.paths or []
    take_arguments(options)
    table = consumer_table()
    for name in options.names:
        checked_target(name, table.consumers)
    if options.paths:
        from kinlint.cli.target_matrix import print_matrix  # noqa: PLC0415  engines are slow

        print_matrix(options)
    elif options.output_format == "html":
        raise UsageError("--output-format html shows a matrix: add --matrix FILE")
    elif options.output_format == "json":
        wanted = [target.name for target in chosen_targets(options.names or table.consumers)]
        told = [consumer_object(table.consumers[name]) for name in wanted]
        put(iter([json.dumps(told, indent=2, ensure_ascii=False), "\n"]), sys.stdout)
    elif options.names:
        put(_pages(table, options.names), sys.stdout)
    else:
        put(_listed(table), sys.stdout)
    return 0


def consumer_object(consumer: Consumer) -> dict[str, Any]:
    """Return what is known of *consumer* as an object for JSON."""
    return {
        "name": consumer.name,
        "label": consumer.label,
        "comment": consumer.comment,
        "formats": list(consumer.formats),
        "releases": list(consumer.releases),
        "members": list(consumer.members),
        "parsers": [
            {
                "consumer": each.consumer,
                "version": each.version or None,
                "since": each.versions.since or None,
                "until": each.versions.until or None,
            }
            for each in consumer.parsers
        ],
        "links": list(consumer.links),
        "features": [{"feature": each.feature, **each.to_json()} for each in consumer.cells],
    }


def _listed(table: ConsumerTable) -> Iterator[str]:
    """Yield a line for each consumer: name, versions that behave differently, and what it is."""
    width = max(map(len, table.consumers))
    for name, consumer in table.consumers.items():
        told = consumer.comment.partition(". ")[0].removesuffix(".")
        versions = sorted({v for cell in consumer.cells for v in cell.versions if v}, key=_number)
        changes = f" Differs from {', '.join(versions)} on." if versions else ""
        yield f"{name:<{width}}  {told}.{changes}\n"


def _number(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def _pages(table: ConsumerTable, names: Sequence[str]) -> Iterator[str]:
    for number, target in enumerate(chosen_targets(names)):
        if number:
            yield "\n"
        yield from page(table, table.consumers[target.name], target.version)


def page(
    table: ConsumerTable, consumer: Consumer, version: tuple[int, ...] | None
) -> Iterator[str]:
    """Yield the lines of what *consumer* makes of features; of one *version*, if that is given."""
    yield f"{consumer.label}: {consumer.comment}\n"
    if consumer.releases:
        yield f"  measured or described: {', '.join(consumer.releases)}\n"
    for each in consumer.parsers:
        release = f" {each.version}" if each.version else ""
        label = table.consumers[each.consumer].label
        yield f"  reads by {label}{release}{each.versions.words}: kinlint targets {each.consumer}\n"
    yield from (f"  {link}\n" for link in consumer.links)
    cells = [c for c in consumer.cells if version is None or c.versions.has(version)]
    for name, feature in table.features.items():
        own = [cell for cell in cells if cell.feature == name]
        if own:
            yield f"\n{name}: {feature.label}\n"
        for cell in own:
            label = cell.behaviour.label
            told = "" if cell.clause in {label, cell.behaviour.outcome} else f": {cell.clause}"
            yield f"  {label}{cell.versions.words}{told}\n"
            if cell.measured:
                yield f"    measured with {', '.join(cell.measured)}\n"
            yield from (f"    {source}\n" for source in cell.sources)
            if cell.comment:
                yield f"    {cell.comment}\n"
