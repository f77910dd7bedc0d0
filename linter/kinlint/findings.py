"""Turns results of an engine into findings: where they lie, what they say, what they rest on."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from kinlint.anonymous import AnonymousNodes
from kinlint.display import Display
from kinlint.document import Document
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.explanation import because, explain
from kinlint.engine.origin import is_fact, items
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.model import Finding, Location, Premise, Related, Rule
from kinlint.rulebook import Rulebook
from kinlint.terms import (
    RDF_TYPE,
    Term,
    Triple,
    iri,
    iri_value,
    is_blank,
    is_iri,
    is_literal,
    literal_value,
)
from kinlint.text import Span
from kinlint.vocabulary import FACT, SRC

PLACEHOLDER = re.compile(r"\{[?$](\w+)\}")
FACT_NODE = re.compile(r"urn:kinlint:fact:([\w-]+):(\d+)")
OWN = iri(f"{SRC}ownNamespace")
CONSTRAINT = "ConstraintComponent"
ENGINE_NAMES = frozenset({"this", "root", "path", "value", "node", "at", "message"})


@dataclass(frozen=True)
class Locator:
    """The documents of a run, and the store that knows which of them says what."""

    documents: Sequence[Document]
    store: Store

    @cached_property
    def homes(self) -> Mapping[Term, list[Document]]:
        """The documents that describe each node, those that say what it is first."""
        homes: dict[Term, list[Document]] = {}
        for document in self.documents:
            for node in document.map.nodes:
                homes.setdefault(node, []).append(document)
        shared = {node: found for node, found in homes.items() if len(found) > 1}
        if shared:
            typed = {
                (d.graph, s) for d in self.documents for s, p, _ in d.statements if p == RDF_TYPE
            }
            for node, found in shared.items():
                found.sort(key=lambda document, node=node: (document.graph, node) not in typed)  # type: ignore[misc]
        return homes

    def node(self, node: Term) -> Location | None:
        """Where *node* is described."""
        found = self.homes.get(node)
        return Location(found[0].source, found[0].map.nodes[node].best) if found else None

    def triple(
        self, subject: Term, predicate: Term | None, value: Term
    ) -> tuple[Location, Term] | None:
        """Where *value* is written as a value of *subject*, and of which predicate.

        No *predicate* means any.
        """
        for document, triple in self.store.written(subject, predicate, value):
            if (span := document.map.triples.get(triple)) is not None:
                return Location(document.source, span), triple[1]
        return None

    def of(self, result: Result, axioms: Sequence[Axiom]) -> Location:
        """The smallest place that shows *result*: a triple, its node, a mention of it, or a file.

        They are those of `?at`, if the rule says so, or else of the focus node. A triple that
        follows by *axioms* is shown by the first one written that it follows from.
        """
        at = result.bindings.get("at", result.focus)
        if result.path is not None and result.value is not None:
            triple = at, result.path, result.value
            proof = explain(self.store, axioms, triple) if self.store.is_inferred(triple) else ()
            for subject, predicate, value in (triple, *(step.triple for step in proof)):
                if (said := self.triple(subject, predicate, value)) is not None:
                    return said[0]
        place = self.node(at) or self.node(result.focus) or self._mentions.get(at)
        return place or Location(self.documents[0].source, Span(0, 0))

    @cached_property
    def _mentions(self) -> Mapping[Term, Location]:
        """The first place of each term that is a value, for what no file describes."""
        found: dict[Term, Location] = {}
        for document in self.documents:
            for (_, _, value), span in document.map.triples.items():
                found.setdefault(value, Location(document.source, span))
        return found

    @cached_property
    def _inferred(self) -> frozenset[Term]:
        """The properties, and the classes, of which something was inferred."""
        return frozenset(o if p == RDF_TYPE else p for _, p, o in self.store.inferred())

    def may_be_inferred(self, constraint: Constraint) -> bool:
        """Whether something that *constraint* matches may have been inferred."""
        if constraint not in self._judged:
            self._judged[constraint] = bool(self._inferred) and any(
                not PLAIN.fullmatch(p)
                or p in self._inferred
                or (p == RDF_TYPE and (o[0] == "?" or o in self._inferred))
                for _, p, o in (*constraint.premises, *constraint.targets)
            )
        return self._judged[constraint]

    @cached_property
    def _judged(self) -> dict[Constraint, bool]:
        return {}

    def about(self, focus: Term) -> Term:
        """The entity concerned: what a statement of the source layer speaks of, or *focus*."""
        if not is_blank(focus):
            return focus
        found = (document.about.get(focus) for document in self.documents)
        return next((node for node in found if node is not None), focus)

    def anonymous(self, node: Term, location: Location) -> Term:
        """A label for a blank node that survives edits of other nodes."""
        for document in self.documents:
            if document.source is location.source:
                return self._anonymous[document.graph].label(node)
        return node

    @cached_property
    def _anonymous(self) -> Mapping[Term, AnonymousNodes]:
        return {document.graph: AnonymousNodes(document) for document in self.documents}

    def display(self, location: Location) -> Display:
        """How the file of *location* abbreviates."""
        for document in self.documents:
            if document.source is location.source:
                return self._displays[document.graph]
        return Display()

    @cached_property
    def _displays(self) -> Mapping[Term, Display]:
        return {
            document.graph: Display(
                document.prefixes,
                tuple(literal_value(o) for _, p, o in document.statements if p == OWN),
            )
            for document in self.documents
        }


def findings(
    results: Iterable[Result], documents: Sequence[Document], store: Store, rulebook: Rulebook
) -> list[Finding]:
    """One finding for each of *results*, in their order; what says the same twice comes once."""
    locator = Locator(documents, store)
    found = [_finding(result, locator, rulebook) for result in results]
    return list({_identity(finding): finding for finding in reversed(found)}.values())[::-1]


def _identity(finding: Finding) -> tuple[object, ...]:
    where = (finding.location.source.name, finding.location.span)
    return finding.rule.code, where, finding.message, finding.focus


def _finding(result: Result, locator: Locator, rulebook: Rulebook) -> Finding:
    rule = rulebook.by_iri[result.constraint.owner]
    location = locator.of(result, rulebook.axioms)
    display = locator.display(location)
    template = result.message or next(iter(result.constraint.messages), "") or _said(result, rule)
    terms: dict[str, Term | None] = {
        **result.bindings,
        "this": result.focus,
        "path": result.path,
        "value": result.value,
    }
    names = list(dict.fromkeys(PLACEHOLDER.findall(template)))
    shown = {name: display.term(term) if (term := terms.get(name)) else "" for name in names}
    about = locator.about(result.focus)
    return Finding(
        rule=rule,
        severity=rule.severity,
        message=PLACEHOLDER.sub(lambda match: shown[match[1]], template),
        location=location,
        iri=iri_value(about) if is_iri(about) else locator.anonymous(about, location),
        focus=result.focus,
        path=result.path,
        value=result.value,
        template=template,
        arguments=tuple(shown.values()),
        related=tuple(_related(result, location, locator, display)),
        because=tuple(_because(result, locator, rulebook, display)),
    )


def _said(result: Result, rule: Rule) -> str:
    """What to say for a shape without a message."""
    broken = re.split(r"[#/]", result.constraint.component)[-1].removesuffix(CONSTRAINT)
    what = "'{?value}' of '{$this}'" if result.value not in (None, result.focus) else "'{$this}'"
    return f"{what} breaks {broken} of shape {rule.name}."


def _related(
    result: Result, location: Location, locator: Locator, display: Display
) -> Iterator[Related]:
    """The other things that a result names, where they are written and described."""
    named = {name: term for name, term in result.bindings.items() if name not in ENGINE_NAMES}
    terms = [*named.values(), *([result.value] if result.value is not None else ())]
    for term in dict.fromkeys(terms):
        said = locator.triple(result.focus, result.path if is_literal(term) else None, term)
        if said is not None and said[0] != location and said[1] != RDF_TYPE:
            yield Related(said[0], f"'{display.term(said[1])}' is given here")
        described = None if is_literal(term) or term == result.focus else locator.node(term)
        if described is not None and described != location:
            yield Related(described, f"'{display.term(locator.about(term))}' is described here")


def _because(
    result: Result, locator: Locator, rulebook: Rulebook, display: Display
) -> Iterator[Premise]:
    """The proof of a result in which something inferred or computed took part; else nothing."""
    constraint = result.constraint
    if not locator.may_be_inferred(constraint) and not any(map(is_fact, constraint.premises)):
        return
    steps = because(locator.store, rulebook.axioms, result.constraint, result)
    if not any(step.axiom for step in steps) and not any(map(is_fact, constraint.premises)):
        return
    for step in steps:
        subject, predicate, value = step.triple
        said = None if step.axiom else locator.triple(subject, predicate, value)
        if said is not None or step.axiom:
            place = said[0] if said is not None else None
            yield Premise(
                _phrase(step.triple, locator.store, display), place, step.axiom, step.depth
            )


def _phrase(triple: Triple, store: Store, display: Display) -> str:
    """*triple* in three words, with lists, facts and their nodes, which files do not name."""
    if is_blank(triple[2]) and (listed := items(store, triple[2])):
        written = ", ".join(map(display.term, listed))
        return f"{display.term(triple[0])} {display.term(triple[1])} [{written}]"
    words = display.triple(triple)
    return FACT_NODE.sub(r"\1 \2", words.replace(FACT, "")) if is_fact(triple) else words
