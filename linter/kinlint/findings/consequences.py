"""Consequences: findings that follow from another one, by what its rule explains.

A rule states by queries (`kl:explains`) what one of its findings makes uncertain: nodes that lack
statements, names that nobody describes, terms that mean nothing. A finding that rests on these
vanishes once the cause is mended, so it is counted there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.finding import Finding, Related
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.sparql.given_values import is_nameable, with_values
from kinlint.terms import Term, iri, iri_value, is_iri, is_literal, literal_value
from kinlint.vocabulary import SRC

SUSPECT, THROUGH, THIS = "suspect", "through", "this"
"""Variables of the queries: what is uncertain, the property or class concerned, the cause."""
SHOWN = 3
"""The number of consequences, the worst first, whose places a cause shows."""
DECIDING = 2
"""The number of causes that can decide for a rule: the next where the first is what is judged."""

DESCRIBED = iri(f"{SRC}describedIn")
ResultsOf = Callable[[Finding], Sequence[Result]]


class Suspicion(NamedTuple):
    """A finding that makes a term uncertain."""

    cause: int
    """Position of the finding."""
    through: Collection[Term]
    """The properties and classes of which statements may be missing; none for any."""


@dataclass
class Suspects:
    """The terms and namespaces that findings make uncertain."""

    terms: dict[Term, list[Suspicion]] = field(default_factory=dict)
    """By term."""
    namespaces: dict[str, list[Suspicion]] = field(default_factory=dict)
    """By namespace, for all terms in it."""
    rules: dict[int, str] = field(default_factory=dict)
    """The rules of the causes, by their positions."""

    def add(self, suspect: Term, suspicion: Suspicion) -> None:
        """Note that *suspect*, or all of the namespace that it spells, is uncertain."""
        if is_literal(suspect):
            self.namespaces.setdefault(literal_value(suspect), []).append(suspicion)
        else:
            self.terms.setdefault(suspect, []).append(suspicion)

    def of(self, term: Term) -> Iterator[Suspicion]:
        """Yield what makes *term* uncertain."""
        yield from self.terms.get(term, ())
        if self.namespaces and is_iri(term):
            yield from self.namespaces.get(namespace(iri_value(term)), ())


class Unread(NamedTuple):
    """A file that could not be read, and what its text names."""

    names: Collection[Term]
    """The entities."""
    terms: Collection[Term]
    """The properties and classes."""


def folded(
    findings: Sequence[Finding],
    results_of: ResultsOf,
    store: Store,
    unread: Sequence[Unread] = (),
) -> tuple[list[Finding], list[list[Finding]]]:
    """Return *findings* without those that follow from others, which their causes have instead.

    Then, for each file that was not *unread*, those that follow from that.

    Takes time linear in the findings and in the rows of the queries of their rules. Suppressed
    findings stay, and what follows from a suppressed cause is left out as well: mending the cause
    is what its author decided against.
    """
    suspects = _suspects(findings, results_of, store)
    for number, file in enumerate(unread, 1):
        suspects.rules[-number] = ""
        for name in file.names:
            described = next(iter(store.values(name, DESCRIBED)), None) is not None
            suspects.add(name, Suspicion(-number, file.terms if described else ()))
    if not suspects.terms and not suspects.namespaces:
        return list(findings), [[] for _ in unread]
    causes = {
        at: found
        for at, finding in enumerate(findings)
        if finding.suppressed is None
        and (found := _cause(at, finding, results_of(finding), suspects)) is not None
    }
    consequences: dict[int, list[Finding]] = {}
    for at in causes:
        if (root := _root(at, causes, findings)) != at:
            consequences.setdefault(root, []).append(findings[at])
    gone = {id(each) for found in consequences.values() for each in found}
    left = [
        replace(finding, consequences=tuple(consequences[at])) if at in consequences else finding
        for at, finding in enumerate(findings)
        if id(finding) not in gone
    ]
    return left, [consequences.get(-number, []) for number in range(1, len(unread) + 1)]


def with_consequences_told(finding: Finding) -> Finding:
    """Return *finding* with the number of its consequences, and the worst of them as related."""
    if not finding.consequences:
        return finding
    worst = sorted(finding.consequences, key=lambda each: (-each.severity, each.sort_key))
    apart = {(each.rule.code, each.location.source.name): each for each in reversed(worst)}
    shown = sorted(apart.values(), key=lambda each: (-each.severity, each.sort_key))[:SHOWN]
    known = {finding.location, *(each.location for each in finding.related)}
    places = (each for each in shown if each.location not in known)
    return replace(
        finding,
        message=f"{finding.message} {sentence(worst)}.",
        members=finding.members or (finding,),
        consequences=tuple(worst),
        related=(
            *finding.related,
            *(Related(each.location, f"{each.rule.code}: {each.message}") for each in places),
        ),
    )


def namespace(name: str) -> str:
    """Return the namespace of the IRI *name*: all up to its last # or /, else :."""
    end = max(name.rfind("#"), name.rfind("/")) + 1
    return name[: end or name.rfind(":") + 1]


def sentence(worst: Sequence[Finding]) -> str:
    """Return how many findings follow, by rule, without a period."""
    codes = Counter(each.rule.code for each in worst)
    told = ", ".join(f"{count} {code}" for code, count in sorted(codes.items()))
    if len(worst) == 1:
        return f"1 other finding follows from this ({next(iter(codes))})"
    return f"{len(worst)} other findings follow from this ({told})"


def _suspects(findings: Sequence[Finding], results_of: ResultsOf, store: Store) -> Suspects:
    found = Suspects()
    by_rule: dict[str, _Explained] = {}
    for at, finding in enumerate(findings):
        if finding.rule.explains:
            for result in results_of(finding):
                found.rules[at] = finding.rule.iri
                by_rule.setdefault(finding.rule.iri, _Explained()).add(at, result)
    rules = {finding.rule.iri: finding.rule for finding in findings}
    for rule, about in by_rule.items():
        for query in rules[rule].explains:
            for row in store.rows(about.restricted(query)):
                suspect = row.get(SUSPECT)
                if suspect is not None:
                    way = row.get(THROUGH)
                    for at in about.agreeing(row):
                        found.add(suspect, Suspicion(at, () if way is None else (way,)))
    # Rows have no order: of several causes it is the one that is told first.
    for suspicions in (*found.terms.values(), *found.namespaces.values()):
        suspicions.sort(key=lambda each: findings[each.cause].sort_key)
        suspicions[:] = _deciding(suspicions, found.rules)
    return found


def _deciding(suspicions: Sequence[Suspicion], rules: Mapping[int, str]) -> Iterator[Suspicion]:
    """Yield the first *suspicions* of each rule about the same statements."""
    seen: Counter[tuple[str, Collection[Term]]] = Counter()
    for each in suspicions:
        about = rules[each.cause], each.through
        seen[about] += 1
        if seen[about] <= DECIDING:
            yield each


class _Explained:
    """The results of a rule that explains others, by the values of their variables."""

    def __init__(self) -> None:
        self._results: list[tuple[int, Mapping[str, Term | None]]] = []
        self._tables: dict[tuple[str, ...], dict[tuple[Term | None, ...], list[int]]] = {}

    def add(self, at: int, result: Result) -> None:
        """Take in *result* of the finding at the position *at*."""
        terms = {**result.bindings, "value": result.value, THIS: result.focus}
        self._results.append((at, terms))

    def restricted(self, query: str) -> str:
        """Return *query* about the targets of the findings alone, if a query can name them."""
        targets = {terms[THIS] for _, terms in self._results}
        named = [each for each in targets if each is not None and is_nameable(each)]
        return with_values(query, f"?{THIS}", named) if len(named) == len(targets) else query

    def agreeing(self, row: Mapping[str, Term]) -> Sequence[int]:
        """Return the positions of findings whose results have the values of *row*."""
        if THIS not in row:
            return ()
        names = tuple(sorted(name for name in row if name not in (SUSPECT, THROUGH)))
        if names not in self._tables:
            table = self._tables[names] = {}
            for at, terms in self._results:
                table.setdefault(tuple(map(terms.get, names)), []).append(at)
        return self._tables[names].get(tuple(row[name] for name in names), ())


def _cause(at: int, finding: Finding, results: Sequence[Result], suspects: Suspects) -> int | None:
    """Return the position of what explains one of *results*, which *finding* at *at* is made of.

    A cause of another rule goes before one of the same.
    """
    alike: int | None = None
    for result in results:
        terms = _evidence(finding, result)
        needs = result.constraint.needs or ()
        for term in terms:
            for cause, through in suspects.of(term):
                if cause == at or not _concerns(through, needs, terms):
                    continue
                if suspects.rules[cause] != finding.rule.iri:
                    return cause
                alike = cause if alike is None else alike
    return alike


def _concerns(through: Collection[Term], *looked_at: Collection[Term]) -> bool:
    """Tell whether one of *through* is *looked_at*; none is all."""
    return not through or any(each in terms for terms in looked_at for each in through)


def _evidence(finding: Finding, result: Result) -> dict[Term, None]:
    """Return the terms that *result* rests on, the most telling first."""
    value = result.value, result.path
    terms = (*value, *result.bindings.values(), result.focus)
    found = dict.fromkeys(each for each in terms if each is not None and not is_literal(each))
    if finding.iri and f"<{finding.iri}>" not in found and not finding.iri.startswith("_:"):
        found[f"<{finding.iri}>"] = None
    return found


def _root(at: int, causes: Mapping[int, int], findings: Sequence[Finding]) -> int:
    """Return the first cause behind *at*; of a circle, the finding that comes first."""
    way = {at: None}
    while (at := causes.get(at, at)) not in way:
        way[at] = None
    if at not in causes:
        return at
    circle = list(way)[list(way).index(at) :]
    return min(circle, key=lambda each: findings[each].sort_key)
