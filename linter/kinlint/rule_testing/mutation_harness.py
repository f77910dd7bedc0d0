"""Mutation of rules: whatever a query asks for, some example must show that it matters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from kinlint.catalogue.explanation_queries import EXPLAINS
from kinlint.catalogue.rulebook import PREFIXES, Rulebook
from kinlint.document import Document
from kinlint.engine.compiler.declared_prefixes import declared
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.compiler.shapes_graph import ShapesGraph
from kinlint.engine.compiler.shapes_graph import read as read_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.findings.brief_finding import brief_finding, reason_for
from kinlint.findings.duplicates import identity
from kinlint.findings.locator import Locator
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.light_dataclasses import dataclass
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.rule import Rule
from kinlint.rule_testing.mutants import mutants
from kinlint.rule_testing.unmatched_pattern import readable
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens
from kinlint.terms import literal_value
from kinlint.text import SourceText

Told = tuple[tuple[object, ...], str, str | None, str | None, str]
"""Identity, subject, property, value and reason of a finding in an example."""


@dataclass(frozen=True)
class MutationHarness:
    """The examples of a rule, read and closed, ready for any version of it."""

    rule: Rule
    """The rule."""
    rulebook: Rulebook
    """All rules, with the vocabulary."""
    examples: tuple[Locator, ...]
    """The locator of each example, on the store in which its documents are closed."""

    @classmethod
    def for_rule(
        cls, rule: Rule, rulebook: Rulebook, texts: Iterable[Sequence[SourceText]]
    ) -> MutationHarness:
        """Return the harness for the examples *texts* of *rule*."""
        return cls(rule, rulebook, tuple(Locator(*closed(text, rulebook)) for text in texts))

    def outcomes(self, constraints: tuple[Constraint, ...]) -> list[set[Told]]:
        """Return the findings of *constraints* in each example."""
        return [set(self._told(locator, constraints)) for locator in self.examples]

    def changes(self, constraints: tuple[Constraint, ...], outcomes: list[set[Told]]) -> bool:
        """Return whether *constraints* find anything else than *outcomes* in the examples.

        The first finding that is not among them ends the comparison: a mutant may have thousands.
        """
        for locator, known in zip(self.examples, outcomes, strict=True):
            found = set()
            for told in self._told(locator, constraints):
                if told not in known:
                    return True
                found.add(told)
            if found != known:
                return True
        return False

    def _told(self, locator: Locator, constraints: tuple[Constraint, ...]) -> Iterator[Told]:
        for result in check(locator.store, constraints):
            each = brief_finding(result, locator, self.rulebook)
            reason = reason_for(result, each, locator)
            yield identity(each), each.iri, each.path, each.value, reason


def closed(texts: Sequence[SourceText], rulebook: Rulebook) -> tuple[Sequence[Document], Store]:
    """Return the documents of *texts*, and a store of what rules of *rulebook* see."""
    options = ReadOptions()
    documents = join_companions([read(text, options) for text in texts])
    inputs = Inputs(documents, documents, options.packages_of)
    run = Run(rulebook.vocabulary)
    return documents, run_stages("facts", run, inputs, Demand.for_everything(rulebook))


def unneeded_parts(harness: MutationHarness) -> Iterator[str]:
    """Yield the parts of a rule's queries that could be deleted without any example noticing.

    None for a rule that only the reference engine can judge.
    """
    rule = harness.rule
    text = Path(rule.path).read_text("utf-8-sig")
    prefixes = next(file for file in harness.rulebook.shapes if file.name == PREFIXES)
    graph = read_shapes([prefixes, (rule.path, text)])

    def compiled(version: str) -> tuple[Constraint, ...]:
        found = compile_shapes([prefixes, (rule.path, version)])
        return tuple(each for each in found if each.owner == rule.iri)

    constraints = compiled(text)
    if any(each.deferred is not None for each in constraints):
        return
    whole = harness.outcomes(constraints)
    for query, known in _queries(graph):
        select = parse(tokens(query, known))
        for deleted, mutant in mutants(select):
            try:
                mutated = compiled(_replaced(text, query, render(mutant)))
                matters = harness.changes(mutated, whole)
            except RuleInvalid:
                matters = True
            if not matters:
                yield f"no example shows why the query needs {readable(deleted, known)}"


def _queries(graph: ShapesGraph) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield the queries of constraints, each with its prefixes."""
    apart = {each for one in graph.subjects() for each in graph.values(one, EXPLAINS)}
    for subject in graph.subjects():
        if subject in apart:
            continue
        for query in graph.values(subject, sh("select")):
            yield literal_value(query), declared(graph, subject)


def _replaced(text: str, query: str, by: str) -> str:
    """Return the rule file *text* with *query* in it replaced."""
    written = query if query in text else query.replace("\\", "\\\\")
    return text.replace(written, by.replace("\\", "\\\\"))
