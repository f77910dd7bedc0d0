"""Asks a store which models rules may find anything in, so that no others are streamed.

The patterns that hold wherever a constraint is violated are SELECTs of standard SPARQL over all
graphs at once, as far as they are about what graphs state, or in a scratch graph what follows from
it, and nothing that is lifted or computed. A model that does not match them has no finding; one
that does is judged as ever.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import groupby
from typing import TypeAlias

from kinlint.catalogue.applicability import covers
from kinlint.catalogue.rulebook import Rulebook
from kinlint.endpoint.conditions import AskedTerms, Condition, of_composable, of_elements
from kinlint.endpoint.connection import Endpoint, EndpointError, QueryRefused
from kinlint.endpoint.scratch import scratch_graph
from kinlint.endpoint.stored_graphs import pages
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint
from kinlint.engine.required_terms import relevant
from kinlint.file_format import Format
from kinlint.formats.records import BY_NAME
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term

Found: TypeAlias = dict[str, frozenset[Term] | None]
"""The graphs in which something may be found, by the names of formats; None for all of them."""


@dataclass(frozen=True)
class Plan:
    """Questions to a store about the documents of one format."""

    conditions: Mapping[str, Sequence[Condition]]
    """The conditions of the constraints of rules, by code."""
    axioms: Sequence[Axiom] = ()
    """The axioms that a store has to apply before."""


@dataclass(frozen=True)
class Asking:
    """Asks a store about rules."""

    endpoint: Endpoint
    """The store."""
    book: Rulebook
    """The rules, and others."""
    codes: Collection[str]
    """The codes of those that are selected."""
    tell: Callable[[str], None] = lambda _: None
    """Called with what was found for each rule, and why a store is not asked."""
    warn: Callable[[str], None] = lambda _: None
    """Called with what goes wrong."""
    begin: Callable[[str], None] = lambda _: None
    """Called with what is asked for next: the code of a rule, or the words of an axiom."""

    def concerned(self, formats: Iterable[str], scratch: Term | None = None) -> Found:
        """Return the graphs of documents of *formats* in which anything may be found.

        With *scratch*, the name of a graph, the store infers into it what composable models imply,
        if it cannot be asked for all rules without.
        """
        plans = {form: self.plan(BY_NAME[form], scratch) for form in formats if form in BY_NAME}
        axioms = next((plan.axioms for plan in plans.values() if plan and plan.axioms), ())
        if scratch is None or not axioms:
            return self.graphs(plans)
        with scratch_graph(self.endpoint, scratch, self.warn) as graph:
            try:
                count = graph.infer(axioms, self.begin)
            except EndpointError as error:
                lost = f"the store does not infer: {error}"
            else:
                self.tell(f"{scratch}: {count} statements by {len(axioms)} axioms")
                found = self.graphs(plans, scratch)
                if graph.is_ours:
                    return found
                lost = "another run has taken it"
        self.warn(f"--scratch-graph: {lost}, so all composable models are read")
        left = {form: None if plan and plan.axioms else plan for form, plan in plans.items()}
        return self.graphs(left)

    def plan(self, form: Format, scratch: Term | None) -> Plan | None:
        """Return what the store is asked about documents of *form*; None if that would be vain."""
        of_rule = dict(self._constraints(form))
        if form.is_tree:
            tries = [self._elements]
        else:
            tries = [of_composable(self.book, given) for given in dict.fromkeys((None, scratch))]
        for terms in tries:
            found: dict[str, list[Condition]] = {}
            unasked = []
            for code, constraints in of_rule.items():
                conditions = [terms.condition(each) for each in constraints]
                found[code] = [each for each in conditions if each is not None]
                if not found[code] or len(found[code]) < len(conditions):
                    unasked.append(code or "shapes")
            if not unasked:
                needed = {t for each in of_rule.values() for one in each for t in terms.seen(one)}
                return Plan(found, relevant(self.book.axioms, frozenset(needed)))
        more = f" and {len(unasked) - 1} more" if unasked[1:] else ""
        self.tell(
            f"{unasked[0]}{more}: no pattern says where anything is found, so all models in"
            f" {form.title} are read"
        )
        return None

    @cached_property
    def _elements(self) -> AskedTerms:
        return of_elements(self.book)

    @cached_property
    def _of_rule(self) -> dict[str, list[Constraint]]:
        """The constraints of rules, by IRI, and of other shapes."""
        ordered = sorted(self.book.constraints, key=lambda one: one.owner)
        return {owner: list(each) for owner, each in groupby(ordered, lambda one: one.owner)}

    def _constraints(self, form: Format) -> Iterator[tuple[str, list[Constraint]]]:
        """Yield the selected rules that documents of *form* may violate, by code.

        None are yielded of a rule that has no constraints, and of shapes of a user's own, which
        have no code: they may find something anywhere.
        """
        for rule in self.book.rules:
            every = self._of_rule.get(rule.iri, [])
            own = [each for each in every if covers(each.formats, form)]
            if rule.code in self.codes and covers(rule.formats, form) and (own or not every):
                yield rule.code, own
        if any(owner not in self.book.by_iri for owner in self._of_rule):
            yield "", []

    def graphs(self, plans: Mapping[str, Plan | None], scratch: Term | None = None) -> Found:
        """Return the graphs, but *scratch*, of each format that match what is planned for it."""
        found = {form: set[Term]() for form, plan in plans.items() if plan is not None}
        known = dict[str, frozenset[Term]]()

        def matching(where: str) -> frozenset[Term]:
            if where not in known:
                rows = pages(self.endpoint, "DISTINCT ?g", where)
                known[where] = frozenset(row["g"] for row in rows if row["g"] != scratch)
            return known[where]

        for code in sorted({code for plan in plans.values() if plan for code in plan.conditions}):
            self.begin(code)
            conditions = {
                form: plan.conditions[code]
                for form, plan in plans.items()
                if plan and form in found and code in plan.conditions
            }
            more = set[Term]()
            for form, every in conditions.items():
                try:
                    own = {graph for each in every for graph in _matches(each, matching)}
                except EndpointError as error:
                    what = "refuses" if isinstance(error, QueryRefused) else "does not answer"
                    self.warn(
                        f"{code}: the store {what} its query, so all models in"
                        f" {BY_NAME[form].title} are read: {error}"
                    )
                    del found[form]
                else:
                    found[form] |= own
                    more |= own
            self.tell(f"{code}: {len(more)} graphs to look at")
        return {form: frozenset(found[form]) if form in found else None for form in plans}


def _matches(condition: Condition, matching: Callable[[str], frozenset[Term]]) -> frozenset[Term]:
    """Return the graphs that match one pattern of each group of *condition*."""
    groups = (frozenset[Term]().union(*map(matching, ways)) for ways in condition)
    return frozenset.intersection(*groups)
