"""`kinlint format-rules`: writes rule files in one layout."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from kinlint import resources
from kinlint.cli.argument_parser import Parser
from kinlint.cli.output_files import replacing
from kinlint.engine.compiler.shapes_graph import parse
from kinlint.errors import UsageError
from kinlint.files.pathglob import absolute
from kinlint.reporters.summary import plural


def parser() -> Parser:
    """Return the parser of `kinlint format-rules`."""
    made = Parser(
        prog="kinlint format-rules",
        description="Format rule files: sorted prefixes without unused ones, one indentation,"
        " lines of at most 100 columns. Comments and examples are kept as they are.",
    )
    made.add_positionals(
        "paths", "PATH", "rule files and directories of them (default: the built-in)"
    )
    made.add_argument(
        "--check", action="store_true", help="change no files; exit with 1 if a file would change"
    )
    return made


def run(arguments: Sequence[str]) -> int:
    """Format the files that *arguments* name; 1 if some would change and are only checked."""
    from kinlint.rule_formatting.formatter import formatted  # noqa: PLC0415  after --help

    options = parser().read(arguments)
    files = [file for path in options.paths or [resources.data("rules")] for file in _files(path)]
    if not files:
        raise UsageError(f"no rule files found in {', '.join(options.paths)}")
    changed = 0
    for file in files:
        text = parse(file).text
        wanted = formatted(text)
        if wanted == text:
            continue
        changed += 1
        sys.stdout.write(f"{'would format' if options.check else 'formatted'} {file}\n")
        if not options.check:
            with replacing(file) as stream:
                stream.write(wanted)
    verdict = f"{changed} {'would change' if options.check else 'changed'}"
    sys.stdout.write(f"{plural(len(files), 'rule file')}: {verdict}.\n")
    return 1 if changed and options.check else 0


def _files(path: str | Path) -> Iterator[Path]:
    """Yield *path* itself if it is a file, else the Turtle files below it."""
    place = absolute(path)
    if not place.exists():
        raise UsageError(f"{path}: no such file or directory")
    yield from sorted(place.rglob("*.ttl")) if place.is_dir() else [place]
