"""`kinlint rule`: explains rules from their own files."""

from __future__ import annotations

import json
import os
import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path
from textwrap import fill

from kinlint.catalogue import rulebook
from kinlint.catalogue.shacl_export import shacl
from kinlint.cli.argument_parser import Parser, add_color, one_of
from kinlint.cli.project_rules import project_rules
from kinlint.configuration.selectors import Catalogue
from kinlint.errors import UsageError
from kinlint.files.atomic_write import replacement
from kinlint.files.pathglob import absolute
from kinlint.findings.message_of_result import SHAPE
from kinlint.project.layers import cache_directory
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.reporter_registry import put
from kinlint.reporters.rule_page import markdown, rule_object, text
from kinlint.reporters.rule_pages import catalogue, pages
from kinlint.reporters.terminal_style import detect_style
from kinlint.resources import data
from kinlint.rule import PROGRAMS, Rule

FORMATS = ("text", "markdown", "json", "turtle")


def parser() -> Parser:
    """The parser of `kinlint rule`."""
    made = Parser(prog="kinlint rule", description="Explain rules: what they find, and why.")
    made.add_positionals("names", "R", "code, name, family (topology, TOP) or anti-pattern (AP3)")
    made.add_argument("--all", action="store_true", help="every rule")
    made.add_argument("--full", action="store_true", help="text with every example, query and fact")
    made.add_argument(
        "--output-format", type=one_of(FORMATS), default="text", metavar="|".join(FORMATS)
    )
    made.add_argument(
        "--output-directory",
        metavar="DIR",
        help="write all as Markdown: an index, and a page for each family",
    )
    made.add_argument("--rules", metavar="DIR", action="append", help="add the rules in DIR")
    made.add_argument(
        "--shapes", metavar="FILE", action="append", help="add the SHACL shapes in FILE: SHACL001"
    )
    made.add_argument("--trust", action="store_true", help="add the project's own rules")
    add_color(made.add_argument)
    return made


def run(arguments: Sequence[str]) -> int:
    """Print the pages that *arguments* ask for; the exit code."""
    options = parser().read(arguments)
    if not options.names and not options.all:
        raise UsageError("name a rule, such as UNI002; kinlint rules lists them")
    extra = [absolute(path) for path in options.rules or ()]
    extra += [path for path in project_rules(trust=options.trust) if path not in extra]
    if any(each.startswith(PROGRAMS) for each in options.names):
        extra.append(data("shapes") / "generation" / "rules")
    shapes = [absolute(path) for path in options.shapes or ()]
    book = rulebook.load(extra, shapes, cache_directory(os.environ))
    known = Catalogue(book.rules)
    unknown = next((each for each in options.names if each.startswith(SHAPE)), "")
    if unknown and unknown not in known.exact:
        raise UsageError(f"{unknown} is a SHACL shape that a run was given: add --shapes FILE")
    if options.all and options.names:
        raise UsageError(f"--all is every rule, '{options.names[0]}' among them: give one of both")
    wanted = options.names or ["ALL"]
    codes = frozenset[str]().union(*(known.find(each)[1] for each in wanted))
    rules = [rule for rule in book.rules if rule.code in codes]
    if options.output_directory is not None:
        if options.output_format in ("json", "turtle"):
            form = options.output_format
            raise UsageError(
                f"--output-directory writes Markdown: leave --output-format {form} out"
            )
        return _write(rules, absolute(options.output_directory))
    single = len(wanted) == 1 and wanted[0] in known.exact
    if options.all and options.output_format == "markdown":
        put(catalogue(rules), sys.stdout)
    elif options.output_format == "json":
        pages = [rule_object(rule) for rule in rules]
        written = json.dumps(pages[0] if single else pages, indent=2, ensure_ascii=False)
        put(iter([written, "\n"]), sys.stdout)
    elif options.output_format == "turtle":
        put(iter([shacl(Path(rule.path) for rule in rules)]), sys.stdout)
    else:
        put(_pages(rules, options), sys.stdout)
    return 0


def _write(rules: Sequence[Rule], directory: Path) -> int:
    """Write the pages of *rules* below *directory*."""
    for name, page in pages(rules).items():
        path = directory / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            with replacement(path) as stream:
                stream.write(page.encode())
        except OSError as error:
            raise UsageError(f"{path}: {error.strerror}") from error
    return 0


def _pages(rules: Sequence[Rule], options: Namespace) -> Iterator[str]:
    form = options.output_format
    style = detect_style(sys.stdout, options.color)
    for each in ANTIPATTERNS:
        if each.id in map(str.upper, options.names):
            said = f"{each.id} {each.name.lower()}. {each.description}"
            yield f"{fill(said, 80)}\n\n" if form == "text" else f"{said}\n\n"
    for number, rule in enumerate(rules):
        if number:
            yield "\n" if form == "markdown" else "\n" + "-" * 80 + "\n\n"
        if form == "markdown":
            yield markdown(rule)
        else:
            yield from text(rule, style, full=options.full)
    if form == "text" and len(rules) == 1 and not options.full:
        yield f"\nAll examples, queries and facts: kinlint rule {rules[0].code} --full\n"
