"""`kinlint test-rules`: holds rules to what their own files promise."""

from __future__ import annotations

import gc
import json
import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from kinlint import garbage
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.argument_parser import Parser
from kinlint.cli.output_files import replacing
from kinlint.cli.project_rules import project_rules
from kinlint.errors import UsageError
from kinlint.files.pathglob import absolute
from kinlint.project.layers import cache_directory
from kinlint.reporters.summary import plural
from kinlint.rule import Rule
from kinlint.rule_testing import rule_conformance
from kinlint.rule_testing.remarks import Remark


def parser() -> Parser:
    """The parser of `kinlint test-rules`."""
    made = Parser(
        prog="kinlint test-rules",
        description="Test rules: bad examples have findings exactly where they are marked, good"
        " examples have none, and the rule file is complete.",
    )
    made.add_positionals(
        "paths", "DIR", "rule files (default: those of the project, or the built-in)"
    )
    made.add_argument("--trust", action="store_true", help="use the project's own rules")
    made.add_argument("-q", "--quiet", action="store_true", help="print only failures")
    made.add_argument("--json", action="store_true", help="print JSON: an object a rule")
    made.add_argument(
        "--coverage",
        action="store_true",
        help="count the parts of each query that an example needs, and list the others",
    )
    made.add_argument(
        "--update",
        action="store_true",
        help="first write what the rules find and fix into their examples: marks of bad texts, and"
        " kl:fixed",
    )
    return made


class _Outcome(NamedTuple):
    """Result of the test of a rule."""

    rule: Rule
    """The rule."""
    failures: Sequence[str]
    """The promises that it does not keep."""
    remarks: Sequence[str]
    """Remarks on what it should have."""
    parts: Sequence[tuple[str, bool]] | None
    """Parts of its queries, and whether an example needs each; None if nobody asked."""

    def as_json(self) -> dict[str, object]:
        """Return the outcome as an object for JSON."""
        found: dict[str, object] = {
            "code": self.rule.code,
            "name": self.rule.name,
            "file": self.rule.path,
            "examples": len(self.rule.examples),
            "failures": [*self.failures],
            "remarks": [*self.remarks],
        }
        if self.parts is not None:
            untested = [each for each, needed in self.parts if not needed]
            found["coverage"] = {"parts": len(self.parts), "untested": untested}
        return found

    def lines(self, *, quiet: bool) -> Iterator[str]:
        """Yield what is told of the rule; nothing but failures if *quiet*."""
        head = f"{self.rule.code} {self.rule.name}: "
        yield from (f"{head}{each}\n" for each in self.failures)
        if quiet:
            return
        yield from (f"{head}remark: {each}\n" for each in self.remarks)
        if self.parts is not None:
            tested = sum(needed for _, needed in self.parts)
            yield f"{head}examples need {tested} of {plural(len(self.parts), 'part')} of queries\n"


def run(arguments: Sequence[str]) -> int:
    """Test the rules that *arguments* name; 0 if all keep their promises, else 1."""
    options = parser().read(arguments)
    given = [absolute(path) for path in options.paths] or project_rules(
        trust=options.trust, required=True
    )
    book, rules = _load(given, options.paths)
    if options.update:
        for path in _updated(rules, book):
            if not (options.json or options.quiet):
                sys.stdout.write(f"updated {path}\n")
        book, rules = _load(given, options.paths)
    garbage.freeze()
    outcomes = list[_Outcome]()
    for rule in rules:
        told = _outcome(rule, book, coverage=options.coverage)
        # What is read from JSON-LD counts as old, so that nothing else collects it.
        gc.collect()
        outcomes.append(told)
        if not options.json:
            sys.stdout.writelines(told.lines(quiet=options.quiet))
    garbage.unfreeze()
    if options.json:
        json.dump([each.as_json() for each in outcomes], sys.stdout, ensure_ascii=False, indent=2)
        sys.stdout.write("\n")
    elif not options.quiet:
        sys.stdout.write(_summary(outcomes))
    return 1 if any(each.failures for each in outcomes) else 0


def _load(given: Sequence[Path], words: Sequence[str]) -> tuple[Rulebook, Sequence[Rule]]:
    """Return all rules with those *given*, and the rules to test."""
    book = rulebook.load(given, (), cache_directory(os.environ))
    rules = [rule for rule in book.rules if not given or _below(Path(rule.path), given)]
    if not rules:
        raise UsageError(f"no rules found in {', '.join(words)}")
    return book, rules


def _updated(rules: Sequence[Rule], book: Rulebook) -> Iterator[Path]:
    """Write the files of *rules* of which examples change; yield them."""
    from kinlint.rule_testing.example_update import updated  # noqa: PLC0415  few runs ask for it

    files: dict[Path, list[Rule]] = {}
    for rule in rules:
        files.setdefault(Path(rule.path), []).append(rule)
    for path, own in files.items():
        text = updated(path, own, book)
        if text != path.read_text("utf-8-sig"):
            with replacing(path) as stream:
                stream.write(text)
            yield path


def _outcome(rule: Rule, book: Rulebook, *, coverage: bool) -> _Outcome:
    problems = list(rule_conformance.failures(rule, book))
    noted = [each for each in problems if isinstance(each, Remark)]
    failed = [each for each in problems if not isinstance(each, Remark)]
    parts = list(rule_conformance.query_parts(rule, book)) if coverage else None
    return _Outcome(rule, failed, noted, parts)


def _summary(outcomes: Sequence[_Outcome]) -> str:
    """Return how many rules were tested, and how many fail."""
    failed = sum(bool(each.failures) for each in outcomes)
    remarks = sum(len(each.remarks) for each in outcomes)
    examples = sum(len(each.rule.examples) for each in outcomes)
    verdict = f"{failed} of them fail" if failed else "all keep their promises"
    verdict += f" ({plural(remarks, 'remark')})" if remarks else ""
    told = f"{plural(len(outcomes), 'rule')} with {plural(examples, 'example')}"
    return f"{told}: {verdict}.\n"


def _below(path: Path, given: Sequence[Path]) -> bool:
    return any(absolute(path).is_relative_to(each) for each in given)
