"""Asks a store which models rules may find anything in, so that no others are streamed.

The patterns that hold wherever a constraint is violated are a SELECT of standard SPARQL over all
graphs at once, as far as they are about what graphs state, or what composable models imply, and
nothing that is lifted or computed. A model that matches none of them has no finding; one that does
is judged as ever.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import groupby
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import FROM
from kinlint.endpoint.connection import Endpoint, QueryRefused
from kinlint.endpoint.scratch import inferred
from kinlint.endpoint.stored_graphs import pages
from kinlint.engine.axioms import Axiom
from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.lifting import lifts
from kinlint.engine.required_terms import made
from kinlint.engine.store import Store
from kinlint.facts.fact_kinds import KINDS
from kinlint.formats.records import TREES
from kinlint.light_dataclasses import dataclass
from kinlint.missing_files import STATED
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.vocabulary import ATTRIBUTE, SRC

WRITTEN = tuple(
    f"<{each}" for each in (SRC, ATTRIBUTE, *(t.namespace for t in TREES if t.namespace))
)
"""Beginnings of the terms that readers state, and nothing else but what is left out below."""


_Conditions: TypeAlias = Sequence[Sequence[str]]
"""Graph patterns of the constraints of a rule; a graph matches all of one that it violates."""


@dataclass(frozen=True)
class Candidates:
    """The graphs in which rules may find anything."""

    any: frozenset[Term] | None
    """Graphs of documents in whatever format; None for all."""
    composable: frozenset[Term] | None
    """Graphs of composable models, of which nothing is lifted; None for all."""


@dataclass(frozen=True)
class _Terms:
    """The terms of patterns that a store can be asked for."""

    begin: tuple[str, ...]
    """Their beginnings."""
    derived: Collection[Term]
    """Terms of statements that are in no graph of the store."""
    inferred: Collection[Term] = ()
    """Terms of statements that may be in the scratch graph."""
    scratch: Term | None = None
    """The name of that graph, if there is one."""

    def wheres(self, patterns: Sequence[Triple]) -> list[str]:
        """Return graph patterns, all of which `?g` matches where it has *patterns*.

        Those of what is inferred are apart: joined, their unions are more than stores can hold.
        """
        if self.scratch is None:
            return [f"GRAPH ?g {{ {' '.join(f'{_text(each)} .' for each in _joined(patterns))} }}"]
        return [self._where(each) for each in patterns]

    def _where(self, pattern: Triple) -> str:
        """Return what matches *pattern* in `?g`, or in what it implies about a node of `?g`."""
        here = f"GRAPH ?g {{ {_text(pattern)} }}"
        if _term(pattern) not in self.inferred:
            return here
        made = f"GRAPH {self.scratch} {{ {_text(pattern)} }}"
        ways = f"{pattern[0]} ?by ?to", f"?of ?by {pattern[0]}"
        whose = (f"{{ {made} GRAPH ?g {{ {each} }} }}" for each in ways)
        return f"{{ {here} }} UNION {' UNION '.join(whose)}"


def concerned(
    endpoint: Endpoint,
    book: Rulebook,
    codes: Collection[str],
    tell: Callable[[str], None],
    scratch: Term | None = None,
) -> Candidates:
    """Return the graphs in which the rules with *codes* may find anything.

    *tell* is told what was found for each rule, and which query is refused. With *scratch*, the
    name of a graph, the store infers into it what composable models imply, if that is of use.
    """
    written = _Terms(WRITTEN, made(book.axioms) | lifts(set(TREES)) | STATED | {FROM})
    known = dict(_queries(book, codes, written))
    found = _asked(endpoint, known, tell) if None not in known.values() else None
    if scratch is None or found is not None:
        return Candidates(found, found)
    given = _computed(book)
    axioms = [each for each in book.axioms if _head(each) not in given]
    terms = _Terms(("<",), given, made(axioms), scratch)
    more = {code: known[code] or each for code, each in _queries(book, codes, terms)}
    if None in more.values():
        left = ", ".join(sorted(code for code, each in more.items() if each is None))
        tell(f"nothing is inferred in the store: it cannot be asked for {left}")
        return Candidates(None, None)
    with inferred(endpoint, scratch, axioms):
        return Candidates(None, _asked(endpoint, more, tell, scratch))


def _asked(
    endpoint: Endpoint,
    queries: Mapping[str, _Conditions | None],
    tell: Callable[[str], None],
    aside: Term | None = None,
) -> frozenset[Term] | None:
    """Return the graphs, but *aside*, that match *queries* by rule; None if the store refuses."""
    matching = dict[str, set[Term]]()
    found = set[Term]()
    for code, conditions in queries.items():
        graphs = set[Term]()
        for wheres in conditions or ():
            try:
                for each in wheres:
                    if each not in matching:
                        rows = pages(endpoint, "DISTINCT ?g", each)
                        matching[each] = {row["g"] for row in rows if row["g"] != aside}
            except QueryRefused as error:
                tell(f"{code}: the store refuses its query, so all models are read: {error}")
                return None
            graphs |= set.intersection(*(matching[each] for each in wheres))
        tell(f"{code}: {len(graphs)} graphs to look at")
        found |= graphs
    return frozenset(found)


def _computed(book: Rulebook) -> frozenset[Term]:
    """Return the terms of what is computed, stands in the vocabulary, or follows from either."""
    store = Store()
    store.load_vocabulary(book.vocabulary)
    rows = store.oxigraph.query(
        f"SELECT DISTINCT ?t {{ GRAPH ?g {{ {{ ?s ?t ?o }} UNION {{ ?s {RDF_TYPE} ?t }} }} }}"
    )
    found = {str(row["t"]) for row in rows} | STATED | {FROM}  # type: ignore[union-attr]
    found.discard(RDF_TYPE)
    for kind in KINDS:
        found.update((*kind.needs, *kind.details))
    while (
        more := {_head(each) for each in book.axioms if not found.isdisjoint(map(_term, each.body))}
        - found
    ):
        found |= more
    return frozenset(found)


def _term(pattern: Triple) -> Term:
    _, predicate, value = pattern
    return value if predicate == RDF_TYPE else predicate


def _text(pattern: Triple) -> str:
    return " ".join(pattern)


def _head(axiom: Axiom) -> Term:
    return _term(axiom.head)


def _queries(
    book: Rulebook, codes: Collection[str], terms: _Terms
) -> Iterator[tuple[str, _Conditions | None]]:
    """Yield the patterns for each rule by its code; None if it may find something in any model."""
    of_rule = {
        owner: list(each)
        for owner, each in groupby(
            sorted(book.constraints, key=lambda one: one.owner), lambda one: one.owner
        )
    }
    for rule in book.rules:
        if rule.code in codes:
            wheres = [condition(each, terms) for each in of_rule.get(rule.iri, ())]
            told = [each for each in wheres if each is not None]
            yield rule.code, told if wheres and len(told) == len(wheres) else None
    if any(owner not in book.by_iri for owner in of_rule):  # shapes of a user's own
        yield "", None


def condition(constraint: Constraint, terms: _Terms) -> Sequence[str] | None:
    """Return what all a graph matches in which *constraint* is violated; None if it is anything."""
    if constraint.deferred is not None:
        return None
    patterns = list(_patterns(constraint.premises, terms))
    return terms.wheres(patterns) if patterns else None


def _patterns(premises: Sequence[Triple], terms: _Terms) -> Iterator[Triple]:
    """Yield those of *premises* that are of *terms*; other values are any.

    A class that none is inferred to have is that of the node itself, not one below it.
    """
    below = {kind: value for kind, path, value in premises if path == f"{SUBCLASS}*"}
    for number, (subject, predicate, given) in enumerate(premises):
        value = below.get(given, given) if predicate == RDF_TYPE else given
        term = value if predicate == RDF_TYPE else predicate
        if (
            not PLAIN.fullmatch(predicate)
            or not term.startswith(terms.begin)
            or term in terms.derived
        ):
            continue
        named = is_iri(value) and value.startswith(terms.begin)
        known = named or value.startswith("?")
        node = subject if subject.startswith("?") else f"?node_{number}"
        yield node, predicate, value if known else f"?value_{number}"


def _joined(patterns: Sequence[Triple]) -> list[Triple]:
    """Return those of *patterns* that variables join to the first: the others would multiply."""
    found, left = list(patterns[:1]), list(patterns[1:])
    seen = {each for pattern in found for each in pattern}
    while more := [each for each in left if not seen.isdisjoint((each[0], each[2]))]:
        found += more
        seen |= {each for pattern in more for each in (pattern[0], pattern[2])}
        left = [each for each in left if each not in more]
    return found
