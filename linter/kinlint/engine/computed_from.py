"""Finds out what a computed triple was computed from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from kinlint.engine.store import Store
from kinlint.terms import (
    NUMERIC,
    RDF,
    RDF_TYPE,
    Term,
    Triple,
    iri,
    is_blank,
    is_literal,
    literal_datatype,
)
from kinlint.vocabulary import FACT, QUDT, SRC

COMPUTED, COMPUTED_TOO = "computed from", "computed from the same"
COMPUTED_ALONE = "computed from the elements"
"""The label in place of an axiom: numbers follow, were shown before, or there are none."""

DERIVED_FROM = iri(f"{FACT}derived-from")
TYPE_FACTS = frozenset(iri(f"{FACT}{name}") for name in ("excluded-type", "entailed-type"))
"""Computed of what is of a class, so that rules look at few: they say no more than that it is."""

CONTRADICTED = iri(f"{FACT}contradicted")
"""Says only where a rule is to look."""
UNIT = iri(f"{QUDT}unit")
FIRST, REST, NIL = (iri(f"{RDF}{name}") for name in ("first", "rest", "nil"))
FEW = 3
"""Up to this many sources are shown with all of their numbers; of each of more, one number."""

RESOLVED = f"<{SRC}"
"""The beginning of properties that readers resolve, such as poses in the frame of a body.

No file states their numbers.
"""

NODE = "<urn:kinlint:fact:"
"""The beginning of the names of computed nodes."""

KIND_OF = 3
"""The rank of what a node is, after that of numbers, units and lists."""

MOST_READ = 200
MOST_ITEMS = 3
MOST = 12
"""The number of statements that are shown for one computed triple, at most."""


def is_fact(triple: Triple) -> bool:
    """Tell whether *triple* is computed: such triples have properties and classes of their own."""
    space = f"<{FACT}"
    return triple[1].startswith(space) or (triple[1] == RDF_TYPE and triple[2].startswith(space))


def sources(store: Store, triple: Triple) -> Sequence[Term]:
    """Return the node that a computed triple is about, and its sources.

    A node that is itself computed is not among them.
    """
    subject, _, value = triple
    own = () if subject.startswith(NODE) else (subject,)
    for node in (subject, value):
        if not is_literal(node) and (found := tuple(store.values(node, DERIVED_FROM))):
            return tuple(dict.fromkeys((*own, *found) if node == subject else found))
    return own


def statements(store: Store, nodes: Sequence[Term]) -> Iterator[Triple]:
    """Yield the statements about *nodes* that numbers are computed from: numbers, lists, units."""
    each = MOST if len(nodes) <= FEW else 1
    return islice((triple for node in nodes for triple in _told(store, node, each)), MOST)


def items(store: Store, head: Term) -> Sequence[Term]:
    """Return the first items of the list at *head*; none if it is no list."""
    found: list[Term] = []
    for _ in range(MOST_ITEMS):
        if not is_blank(head):
            break
        found += islice(store.values(head, FIRST), 1)
        head = next(store.values(head, REST), NIL)
    return found


def _told(store: Store, node: Term, most: int) -> Sequence[Triple]:
    """Return at most *most* of these, numbers first; what the node is if there are none."""
    ranked = sorted(
        (_rank(store, value, predicate), predicate, value)
        for predicate, value in islice(store.described(node), MOST_READ)
        if not predicate.startswith(RESOLVED)
    )
    numbers = [(node, predicate, value) for rank, predicate, value in ranked if rank < KIND_OF]
    kinds = [(node, predicate, value) for rank, predicate, value in ranked if rank == KIND_OF]
    return numbers[:most] or kinds[:1]


def _rank(store: Store, value: Term, predicate: Term) -> int:
    if is_literal(value):
        return 0 if literal_datatype(value) in NUMERIC else KIND_OF + 1
    if predicate == UNIT:
        return 1
    if predicate == RDF_TYPE:
        return KIND_OF
    return 2 if is_blank(value) and any(store.values(value, FIRST)) else KIND_OF + 1
