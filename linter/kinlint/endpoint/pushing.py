"""Asks a store which models rules may find anything in, so that no others are streamed.

The patterns that hold wherever a constraint is violated are a SELECT of standard SPARQL over all
graphs at once, as far as they are about what graphs state, and nothing that is lifted, inferred or
computed. A model that matches none of them has no finding; one that does is judged as ever.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import groupby

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import FROM
from kinlint.endpoint.connection import Endpoint, QueryRefused
from kinlint.endpoint.stored_graphs import pages
from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.lifting import lifts
from kinlint.engine.required_terms import made
from kinlint.formats.records import TREES
from kinlint.missing_files import STATED
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.vocabulary import ATTRIBUTE, SRC

WRITTEN = tuple(
    f"<{each}" for each in (SRC, ATTRIBUTE, *(t.namespace for t in TREES if t.namespace))
)
"""Beginnings of the terms that readers state, and nothing else but what is left out below."""


def concerned(
    endpoint: Endpoint,
    book: Rulebook,
    codes: Collection[str],
    tell: Callable[[str], None],
    begin: Callable[[str], None] = lambda _: None,
) -> frozenset[Term] | None:
    """Return the graphs in which the rules with *codes* may find anything; None for all of them.

    *tell* is told what was found for each rule, and which query is refused; *begin* is called with
    the code of each rule before its queries are asked.
    """
    queries = dict(_queries(book, codes))
    if unasked := [code for code, wheres in queries.items() if wheres is None]:
        some = f"{unasked[0] or 'shapes'}" + (
            f" and {len(unasked) - 1} more" if unasked[1:] else ""
        )
        tell(f"{some}: no pattern says where anything is found, so all models are read")
        return None
    found = set[Term]()
    for code, wheres in queries.items():
        begin(code)
        graphs = set[Term]()
        for where in wheres or ():
            try:
                graphs.update(row["g"] for row in pages(endpoint, "DISTINCT ?g", where))
            except QueryRefused as error:
                tell(f"{code}: the store refuses its query, so all models are read: {error}")
                return None
        tell(f"{code}: {len(graphs)} graphs to look at")
        found |= graphs
    return frozenset(found)


def _queries(book: Rulebook, codes: Collection[str]) -> Iterator[tuple[str, Sequence[str] | None]]:
    """Yield the patterns for each rule by its code; None if it may find something in any model."""
    derived = made(book.axioms) | lifts(set(TREES)) | STATED | {FROM}
    of_rule = {
        owner: list(each)
        for owner, each in groupby(
            sorted(book.constraints, key=lambda one: one.owner), lambda one: one.owner
        )
    }
    for rule in book.rules:
        if rule.code in codes:
            wheres = [condition(each, derived) for each in of_rule.get(rule.iri, ())]
            told = [each for each in wheres if each is not None]
            yield rule.code, told if wheres and len(told) == len(wheres) else None
    if any(owner not in book.by_iri for owner in of_rule):  # shapes of a user's own
        yield "", None


def condition(constraint: Constraint, derived: Collection[Term]) -> str | None:
    """Return what a graph matches in which *constraint* is violated; None if that is anything."""
    if constraint.deferred is not None:
        return None
    patterns = _joined(list(_patterns(constraint.premises, derived)))
    lines = (" ".join(each) + " ." for each in patterns)
    return f"GRAPH ?g {{ {' '.join(lines)} }}" if patterns else None


def _patterns(premises: Sequence[Triple], derived: Collection[Term]) -> Iterator[Triple]:
    """Yield those of *premises* that are about what readers state; other values are any.

    A class that none is inferred to have is that of the node itself, not one below it.
    """
    below = {kind: value for kind, path, value in premises if path == f"{SUBCLASS}*"}
    for number, (subject, predicate, given) in enumerate(premises):
        value = below.get(given, given) if predicate == RDF_TYPE else given
        term = value if predicate == RDF_TYPE else predicate
        if not PLAIN.fullmatch(predicate) or not term.startswith(WRITTEN) or term in derived:
            continue
        named = is_iri(value) and value.startswith(WRITTEN)
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
