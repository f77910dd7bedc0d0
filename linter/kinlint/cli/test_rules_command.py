"""`kinlint test-rules`: holds rules to what their own files promise."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from kinlint import garbage
from kinlint.catalogue import rulebook
from kinlint.cli.argument_parser import Parser
from kinlint.cli.project_rules import project_rules
from kinlint.errors import UsageError
from kinlint.files.pathglob import absolute
from kinlint.project.layers import cache_directory
from kinlint.reporters.summary import plural
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
    return made


def run(arguments: Sequence[str]) -> int:
    """Test the rules that *arguments* name; 0 if all keep their promises, else 1."""
    options = parser().read(arguments)
    given = [absolute(path) for path in options.paths] or project_rules(
        trust=options.trust, required=True
    )
    book = rulebook.load(given, (), cache_directory(os.environ))
    rules = [rule for rule in book.rules if not given or _below(Path(rule.path), given)]
    if not rules:
        raise UsageError(f"no rules found in {', '.join(options.paths)}")
    garbage.freeze()
    failed = remarks = 0
    for rule in rules:
        problems = list(rule_conformance.failures(rule, book))
        # What is read from JSON-LD counts as old, so that nothing else collects it.
        gc.collect()
        noted = [each for each in problems if isinstance(each, Remark)]
        failed += len(problems) > len(noted)
        remarks += len(noted)
        for problem in problems:
            mark = "remark: " if problem in noted else ""
            if not (mark and options.quiet):
                sys.stdout.write(f"{rule.code} {rule.name}: {mark}{problem}\n")
    garbage.unfreeze()
    if not options.quiet:
        examples = sum(len(rule.examples) for rule in rules)
        verdict = f"{failed} of them fail" if failed else "all keep their promises"
        verdict += f" ({plural(remarks, 'remark')})" if remarks else ""
        told = f"{plural(len(rules), 'rule')} with {plural(examples, 'example')}"
        sys.stdout.write(f"{told}: {verdict}.\n")
    return 1 if failed else 0


def _below(path: Path, given: Sequence[Path]) -> bool:
    return any(absolute(path).is_relative_to(each) for each in given)
