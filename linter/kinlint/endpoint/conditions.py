"""Conditions of constraints: what a graph of a store matches wherever one is violated in it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import FROM
from kinlint.engine.axioms import Axiom
from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.lifting import lifts
from kinlint.engine.pruning import COMPUTED
from kinlint.engine.required_terms import made, term_of
from kinlint.engine.store import Store
from kinlint.formats.records import TREES
from kinlint.light_dataclasses import dataclass
from kinlint.missing_files import STATED
from kinlint.terms import RDF_TYPE, Term, Triple, iri, is_iri
from kinlint.vocabulary import ATTRIBUTE, SRC, STORE

Condition: TypeAlias = Sequence[Sequence[str]]
"""Graph patterns with `?g`: a graph matches one of each group."""
WRITTEN = tuple(
    f"<{each}" for each in (SRC, ATTRIBUTE, *(t.namespace for t in TREES if t.namespace))
)
"""Beginnings of the terms that readers of elements state."""
CLASSES = f"GRAPH ?g {{ ?below {SUBCLASS} ?above }}"
"""Matches a graph with classes of its own, which may be below those that constraints ask for."""
HOME = iri(f"{STORE}in")
"""Property of a node about which something is inferred: the graph that states what it rests on."""


@dataclass(frozen=True)
class AskedTerms:
    """The terms that a store can be asked for, in documents of some formats."""

    begin: tuple[str, ...]
    """Their beginnings."""
    derived: Collection[Term]
    """Terms of statements that are in no graph of the store, or need not be in that of a model."""
    inferred: Collection[Term] = ()
    """Terms of statements that may be in the scratch graph alone."""
    scratch: Term = ""
    """The name of the scratch graph; empty without one."""

    def condition(self, constraint: Constraint) -> Condition | None:
        """Return what a graph matches in which *constraint* is violated; None if it is anything."""
        if constraint.deferred is not None:
            return None
        patterns = list(self._patterns(constraint.premises))
        stated = _joined([each for each in patterns if term_of(each) not in self.inferred])
        groups = [[f"GRAPH ?g {{ {_text(stated)} }}"]] if stated else []
        groups += [self._ways(each) for each in patterns if term_of(each) in self.inferred]
        found = groups or self._chosen(constraint.targets)
        if found and any(SUBCLASS in p or p == RDF_TYPE for _, p, _ in _all(constraint)):
            return [[*ways, CLASSES] for ways in found]
        return found or None

    def seen(self, constraint: Constraint) -> Iterator[Term]:
        """Yield the terms of *constraint* that the scratch graph is asked for."""
        for each in self._patterns(_all(constraint)):
            if (term := term_of(each)) in self.inferred:
                yield term

    def _ways(self, pattern: Triple) -> list[str]:
        """Return what matches *pattern* in `?g`, or what is inferred from it."""
        if term_of(pattern) not in self.inferred:
            return [f"GRAPH ?g {{ {_text([pattern])} }}"]
        home = pattern[0], HOME, "?g"
        return [
            f"GRAPH ?g {{ {_text([pattern])} }}",
            f"GRAPH {self.scratch} {{ {_text([pattern, home])} }}",
        ]

    def _chosen(self, targets: Sequence[Triple]) -> Condition:
        """Return what is matched where one of *targets* chooses a node; nothing if that is any."""
        patterns = [next(self._patterns([each]), None) for each in targets]
        known = [each for each in patterns if each is not None]
        if len(known) < len(patterns):
            return []
        return [[way for each in known for way in self._ways(each)]] if known else []

    def _patterns(self, premises: Sequence[Triple]) -> Iterator[Triple]:
        """Yield those of *premises* that can be asked for; other values are any.

        A class that none is inferred to have is that of the node itself, not one below it.
        """
        below = {kind: value for kind, path, value in premises if path == f"{SUBCLASS}*"}
        for number, (subject, predicate, given) in enumerate(premises):
            value = below.get(given, given) if predicate == RDF_TYPE else given
            term = value if predicate == RDF_TYPE else predicate
            if not PLAIN.fullmatch(predicate) or not self._askable(term):
                continue
            named = is_iri(value) and value.startswith(self.begin)
            node = subject if subject.startswith("?") else f"?node_{number}"
            yield node, predicate, value if named or value[0] == "?" else f"?value_{number}"

    def _askable(self, term: Term) -> bool:
        known = is_iri(term) and term.startswith(self.begin)
        return known and term not in self.derived and not term.startswith(COMPUTED)


def of_elements(book: Rulebook) -> AskedTerms:
    """Return the terms that documents of elements state, beside what is lifted and inferred."""
    return AskedTerms(WRITTEN, made(book.axioms) | lifts(set(TREES)) | STATED | {FROM})


def of_composable(book: Rulebook, scratch: Term | None) -> AskedTerms:
    """Return the terms that composable models state, or, with *scratch*, imply."""
    given = _given(book.vocabulary, book.axioms)
    concluded = made(book.axioms)
    if scratch is None:
        return AskedTerms(("<",), given | concluded)
    return AskedTerms(("<",), given, concluded - given, scratch)


@lru_cache(maxsize=1)
def _given(vocabulary: Sequence[Path], axioms: Sequence[Axiom]) -> frozenset[Term]:
    """Return the terms of what is computed, stands in *vocabulary*, or follows from either."""
    store = Store()
    store.load_vocabulary(vocabulary)
    rows = store.oxigraph.query(
        f"SELECT DISTINCT ?t {{ GRAPH ?g {{ {{ ?s ?t ?o }} UNION {{ ?s {RDF_TYPE} ?t }} }} }}"
    )
    found = {str(row["t"]) for row in rows} | STATED | {FROM}  # type: ignore[union-attr]
    found.discard(RDF_TYPE)
    rules = [(term_of(each.head), {*map(term_of, each.body)}) for each in axioms]
    found |= {term for _, body in rules for term in body if term.startswith(COMPUTED)}
    while more := {head for head, body in rules if not found.isdisjoint(body)} - found:
        found |= more
    return frozenset(found)


def _all(constraint: Constraint) -> Sequence[Triple]:
    return (*constraint.premises, *constraint.targets)


def _joined(patterns: Sequence[Triple]) -> list[Triple]:
    """Return those of *patterns* that variables join to the first: the others would multiply."""
    found, left = list(patterns[:1]), list(patterns[1:])
    seen = {each for pattern in found for each in pattern}
    while more := [each for each in left if not seen.isdisjoint((each[0], each[2]))]:
        found += more
        seen |= {each for pattern in more for each in (pattern[0], pattern[2])}
        left = [each for each in left if each not in more]
    return found


def _text(patterns: Sequence[Triple]) -> str:
    return " ".join(f"{' '.join(each)} ." for each in patterns)
