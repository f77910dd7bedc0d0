"""`kinlint rules`: lists rules, one a line."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence

from kinlint.catalogue import rulebook
from kinlint.catalogue.applicability import covers
from kinlint.cli.argument_parser import Parser, one_of
from kinlint.cli.project_rules import project_rules
from kinlint.configuration.keys import SEVERITIES
from kinlint.configuration.selectors import Catalogue
from kinlint.configuration.value_kinds import ALIASES
from kinlint.files.pathglob import absolute
from kinlint.formats.records import BY_NAME
from kinlint.project.layers import cache_directory
from kinlint.reporters.reporter_registry import put
from kinlint.rule import Rule

NAMES = tuple(BY_NAME)


def parser() -> Parser:
    """The parser of `kinlint rules`."""
    made = Parser(
        prog="kinlint rules",
        description="List rules, one a line: code, severity, name, title.",
        usage="kinlint rules [R...] [--format F] [--family R] [--severity S] [--rules DIR]",
    )
    made.add_positionals("names", "R", "code, name, family or anti-pattern; by default all")
    made.add_argument(
        "--format", type=one_of(NAMES), metavar="F", help=f"rules for {', '.join(NAMES)}"
    )
    made.add_argument("--family", metavar="R", help="a family: topology, or TOP")
    made.add_argument(
        "--severity",
        type=one_of(SEVERITIES, ALIASES),
        metavar="S",
        help=f"rules of this severity: {', '.join(SEVERITIES)}",
    )
    made.add_argument("--rules", metavar="DIR", action="append", help="add the rules in DIR")
    made.add_argument("--trust", action="store_true", help="add the project's own rules")
    return made


def run(arguments: Sequence[str]) -> int:
    """Print the rules that *arguments* ask for; the exit code."""
    options = parser().read(arguments)
    extra = [absolute(path) for path in options.rules or ()]
    extra += [path for path in project_rules(trust=options.trust) if path not in extra]
    known = Catalogue(rulebook.load(extra, (), cache_directory(os.environ)).rules)
    codes = frozenset[str]().union(*(known.find(each)[1] for each in options.names or ["ALL"]))
    if options.family:
        codes &= known.find(options.family)[1]
    chosen = [
        rule
        for rule in sorted(known.rules, key=lambda each: each.code)
        if rule.code in codes
        and options.severity in (None, rule.severity.label)
        and (options.format is None or covers(rule.formats, BY_NAME[options.format]))
    ]
    put(lines(chosen), sys.stdout)
    return 0


def lines(rules: Sequence[Rule]) -> Iterator[str]:
    """Yield a line for each of *rules*."""
    widths = [
        max((len(each) for each in column), default=0)
        for column in zip(*map(_cells, rules), strict=True)
    ]
    for rule in rules:
        cells = (f"{cell:<{width}}" for cell, width in zip(_cells(rule), widths, strict=True))
        yield f"{'  '.join(cells)}".rstrip() + "\n"


def _cells(rule: Rule) -> tuple[str, ...]:
    """Return code, severity, name and title of *rule*; optional and preview rules say so."""
    aside = " (preview)" if rule.preview else " (optional)" if rule.optional else ""
    return rule.code, rule.severity.label, rule.name, rule.title + aside
