"""Turns results of an engine into findings: where they lie, what they say, what they rest on."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import takewhile
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import Document
from kinlint.engine.computed_from import is_fact, items
from kinlint.engine.constraint import Constraint
from kinlint.engine.explanation import Step, because
from kinlint.engine.provenance import Provenance
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.finding import Finding, Premise, Related
from kinlint.findings.brief_finding import brief_finding, placeholder_terms, reason_for
from kinlint.findings.locator import Locator
from kinlint.findings.wording import Wording
from kinlint.light_dataclasses import replace
from kinlint.message_template import filled
from kinlint.terms import (
    RDF_TYPE,
    Triple,
    iri,
    is_blank,
    is_iri,
    is_literal,
)
from kinlint.text import Location
from kinlint.vocabulary import SRC

Proofs: TypeAlias = Callable[[Constraint, Result], Sequence[Step]]

JOINED_TO = iri(f"{SRC}joinedTo")
ENGINE_NAMES = frozenset({"this", "root", "path", "value", "node", "at", "spot", "message"})


def findings(
    results: Iterable[Result], documents: Sequence[Document], store: Store, rulebook: Rulebook
) -> list[Finding]:
    """Return a finding for each of *results*, in their order; duplicates come once."""
    builder = FindingBuilder(results, documents, store, rulebook)
    return list(map(builder.detailed, builder.brief()))


class FindingBuilder:
    """Builder of findings from results of an engine: first in brief, then in detail where needed.

    *proofs* tells what a result rests on; by default it is found out on demand.
    """

    def __init__(
        self,
        results: Iterable[Result],
        documents: Sequence[Document],
        store: Store,
        rulebook: Rulebook,
        proofs: Proofs | None = None,
    ) -> None:
        self.rulebook = rulebook
        self._proofs = proofs or partial(because, store, rulebook.axioms)
        self._locator = Locator(documents, store)
        self._judges = {
            document.source.name: (robot, document.source.pairing)
            for document in documents
            if document.format.speaks_of is not None
            for _, predicate, robot in document.statements
            if predicate == JOINED_TO
        }
        """The robots by which documents are judged that only speak of one, and why."""
        self._told: dict[tuple[object, ...], tuple[Finding, list[Result]]] = {}
        for result in results:
            finding = brief_finding(result, self._locator, rulebook)
            self._told.setdefault(finding.identity, (finding, []))[1].append(result)

    @property
    def store(self) -> Store:
        """The statements that the results are about."""
        return self._locator.store

    @property
    def provenance(self) -> Provenance:
        """The origins of what was lifted in the store."""
        return self._locator.provenance

    def brief(self) -> list[Finding]:
        """Return a finding for each result without duplicates, `related` and `because`."""
        return [finding for finding, _ in self._told.values()]

    def results(self, finding: Finding) -> Sequence[Result]:
        """Return the results that *finding* was made of; duplicates are several."""
        told = self._told.get(finding.identity)
        return told[1] if told is not None else ()

    def filled(self, template: str, finding: Finding) -> str:
        """Return *template* with the values of *finding* for its placeholders, in words."""
        told = (each for one in (finding, *finding.members) for each in self.results(one))
        terms = dict(placeholder_terms(first)) if (first := next(told, None)) is not None else {}
        wording = Wording(self._locator, finding.location, finding.focus)
        return filled(template, wording.words(template, terms))

    def detailed(self, finding: Finding) -> Finding:
        """*finding*, if it is one of these, with what else it speaks of and what it rests on."""
        if (told := self._told.get(finding.identity)) is None:
            return finding
        result, location = told[1][0], finding.location
        wording = Wording(self._locator, location, finding.focus)
        return replace(
            finding,
            reason=reason_for(result, finding, self._locator),
            related=tuple(self._related(result, location, wording)),
            because=tuple(_because(result, self._locator, self._proofs, wording)),
        )

    def _related(self, result: Result, location: Location, wording: Wording) -> Iterator[Related]:
        """Yield the other places that *result* is about, each of them once.

        Those are what the value that shows it was computed from in addition, and where the other
        things that it names are written and described.
        """
        seen = {location}
        for place, message in self._places(result, wording):
            if place not in seen:
                seen.add(place)
                yield Related(place, message)

    def _places(self, result: Result, wording: Wording) -> Iterator[tuple[Location, str]]:
        locator = self._locator
        for place, triple in locator.result_sources(result, self.rulebook.axioms)[1:]:
            yield place, f"{wording.source(triple)} is given here"
        named = {name: term for name, term in result.bindings.items() if name not in ENGINE_NAMES}
        matched = {o[1:]: p for s, p, o in result.constraint.premises if s == "?this"}
        ways = {term: matched[name] for name, term in named.items() if name in matched}
        terms = [*named.values(), *([result.value] if result.value is not None else ())]
        for term in dict.fromkeys(terms):
            path = None if is_iri(term) else result.path if term == result.value else ways.get(term)
            sought = path is not None or not is_literal(term)
            for place, triple in locator.sources(result.focus, path, term) if sought else ():
                if triple[1] != RDF_TYPE:
                    yield place, f"{wording.source(triple)} is given here"
            described = None if is_literal(term) or term == result.focus else locator.node(term)
            if described is not None:
                yield described, f"{wording.word(locator.described(term))} is described here"
        yield from self._judge(wording.location.source.name)

    def _judge(self, name: str) -> Iterator[tuple[Location, str]]:
        """Yield the robot by which the document called *name* is judged, if it speaks of one."""
        robot, pairing = self._judges.get(name, (None, None))
        place = None if robot is None else self._locator.node(robot)
        if place is not None:
            reason = f", because {pairing.reason}" if pairing is not None else ""
            yield place, f"names are looked up in this robot{reason}"


def _because(
    result: Result, locator: Locator, proofs: Proofs, wording: Wording
) -> Iterator[Premise]:
    """Yield the proof of a result that rests on something inferred or computed."""
    constraint = result.constraint
    if not locator.may_be_inferred(constraint) and not any(map(is_fact, constraint.premises)):
        return
    steps = proofs(result.constraint, result)
    if not any(step.axiom for step in steps) and not any(map(is_fact, constraint.premises)):
        return
    found: list[Premise] = []
    for step in steps:
        place = None if step.axiom else locator.premise(step.triple)
        if place is not None or step.axiom:
            statement = _statement(step.triple, locator.store, wording)
            if not statement and not wording.in_xml:
                continue
            found.append(Premise(statement, place, step.axiom, step.depth))
            others = () if step.axiom else locator.sources(*step.triple)[1:]
            found += [
                Premise(wording.quotation(each), each.location, depth=step.depth + 1)
                for each in others
            ]
    yield from _without_internal(found) if wording.in_xml else found


def _without_internal(premises: Sequence[Premise]) -> Iterator[Premise]:
    """Yield the *premises* that say something of their own; what they rest on moves up.

    Empty ones are only in the graph. A number that is computed from itself is only shown as it is
    written, and everything once.
    """
    hidden: list[int] = []
    told: set[str] = set()
    for index, premise in enumerate(premises):
        hidden = [depth for depth in hidden if depth < premise.depth]
        below = takewhile(partial(_deeper, premise), premises[index + 1 :])
        if not premise.statement or any(each.statement == premise.statement for each in below):
            hidden.append(premise.depth)
        elif premise.statement not in told:
            told.add(premise.statement)
            yield replace(premise, depth=premise.depth - len(hidden))


def _statement(triple: Triple, store: Store, wording: Wording) -> str:
    """Return *triple* in the words of its file, a list by its items."""
    if is_blank(triple[2]) and (listed := items(store, triple[2])):
        display = wording.display
        written = ", ".join(map(display.term, listed))
        return f"{display.term(triple[0])} {display.term(triple[1])} [{written}]"
    return wording.statement(triple)


def _deeper(premise: Premise, other: Premise) -> bool:
    """Tell whether *other* is below *premise* in a proof."""
    return other.depth > premise.depth
