"""Mutation of rules: whatever a query asks for, some example must show that it matters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path

from kinlint.catalogue.explanation_queries import EXPLAINS
from kinlint.catalogue.rulebook import PREFIXES, Rulebook
from kinlint.document import Document
from kinlint.engine.compiler.declared_prefixes import declared
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_compiler import compile_graph
from kinlint.engine.compiler.shapes_graph import ShapesGraph
from kinlint.engine.compiler.shapes_graph import read as read_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.findings.brief_finding import brief_finding, reason_for
from kinlint.findings.locator import Locator
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.light_dataclasses import dataclass, replace
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.rule import Rule
from kinlint.rule_testing.mutants import mutants
from kinlint.rule_testing.unmatched_pattern import readable
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens
from kinlint.terms import Term, Triple, literal, literal_value
from kinlint.text import SourceText

SELECT = sh("select")
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

    def changes(
        self,
        constraints: tuple[Constraint, ...],
        others: list[set[Told]],
        outcomes: list[set[Told]],
    ) -> bool:
        """Return whether *constraints*, with what *others* find, find anything but *outcomes*.

        The first finding that is not among them ends the comparison: a mutant may have thousands.
        """
        for locator, beside, known in zip(self.examples, others, outcomes, strict=True):
            found = set(beside)
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
            yield each.identity, each.iri, each.path, each.value, reason


def closed(texts: Sequence[SourceText], rulebook: Rulebook) -> tuple[Sequence[Document], Store]:
    """Return the documents of *texts*, and a store of what rules of *rulebook* see."""
    options = ReadOptions()
    documents = join_companions([read(text, options) for text in texts])
    inputs = Inputs(documents, documents, options.packages_of)
    run = Run(rulebook.vocabulary)
    return documents, run_stages("facts", run, inputs, Demand.for_everything(rulebook))


def parts_needed(harness: MutationHarness) -> Iterator[tuple[str, bool]]:
    """Yield the parts of a rule's queries, and whether any example notices that one is deleted.

    None for a rule that only the reference engine can judge.
    """
    rule = harness.rule
    prefixes = next(file for file in harness.rulebook.shapes if file.name == PREFIXES)
    common, own = read_shapes([prefixes, Path(rule.path)]).files

    def compiled(triples: Iterable[Triple]) -> tuple[Constraint, ...]:
        found = compile_graph(ShapesGraph((common, replace(own, triples=tuple(triples)))))
        return tuple(each for each in found if each.owner == rule.iri)

    constraints = compiled(own.triples)
    if any(each.deferred is not None for each in constraints):
        return
    whole = harness.outcomes(constraints)
    graph = ShapesGraph((common, own))
    queries = _queries(graph)
    for node, query in queries.items():
        others = harness.outcomes(compiled(_without({node}, own.triples)))
        alone = [*_without(queries.keys() - {node}, own.triples)]
        known = declared(graph, node)
        for deleted, mutant in mutants(parse(tokens(literal_value(query), known))):
            changed = {(node, SELECT, query): (node, SELECT, literal(render(mutant)))}
            try:
                mutated = compiled(changed.get(each, each) for each in alone)
                matters = harness.changes(mutated, others, whole)
            except RuleInvalid:
                matters = True
            yield readable(deleted, known), matters


def _queries(graph: ShapesGraph) -> dict[Term, Term]:
    """Return the queries of constraints, each by its constraint."""
    apart = {each for one in graph.subjects() for each in graph.values(one, EXPLAINS)}
    return {
        node: query
        for node in graph.subjects()
        if node not in apart
        for query in graph.values(node, SELECT)
    }


def _without(nodes: AbstractSet[Term], triples: Iterable[Triple]) -> Iterator[Triple]:
    """Yield the *triples* but for those of the constraints *nodes*."""
    return (each for each in triples if nodes.isdisjoint({each[0], each[2]}))
