"""Kinds of quantity with the same units, and units unlike those of numbers of the same size."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.metamodel_terms import body, coord, inertia, kin, qudt
from kinlint.facts.mirror_symmetry import split_name
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.units import INERTIA, KIND, LENGTH, MASS, Unit, Units
from kinlint.terms import Term, Triple

KINDS: tuple[tuple[Term | None, tuple[Term, ...]], ...] = (
    (LENGTH, tuple(map(coord, "xyz"))),
    (INERTIA, tuple(map(inertia, ("ixx", "iyy", "izz")))),
    (MASS, (inertia("mass"), body("mass"))),
    (None, (kin("lower"), kin("upper"))),
    (None, (qudt("value"),)),
)
"""Properties whose numbers are of one kind, and their dimension; None for that of the one unit."""
TERMS = tuple(term for _, terms in KINDS for term in terms)
OTHERS = 3
"""Fewest numbers of one unit that make another one odd."""
NEAR = 2.0
"""Factor by which a number as written is out of the range of the others at most."""
APART = 5.0
"""Factor by which it is out of their range in its unit at least."""


class Numbers(NamedTuple):
    """Numbers of one kind that a node states."""

    node: Term
    """Node itself."""
    size: float
    """Greatest of its numbers as written, without sign."""
    unit: Unit
    """Unit of them."""


def shared_units(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each kind that a model states the kinds with which it shares a unit, itself too."""
    units = scan.instances(qudt("Unit"))
    measured = scan.table(KIND)
    stated = {kind for node, kinds in measured.items() if node not in units for kind in kinds}
    shared = {
        (kind, other)
        for unit in units
        for kind in stated.intersection(measured.values(unit))
        for other in measured.values(unit)
    }
    for kind, other in sorted(shared):
        yield kind, fact("shares-unit-with"), other


def odd_units(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield each node whose number fits the others of its kind, but only in the unit of these.

    It points to one of them, and comes with the least and the greatest of their numbers.
    """
    units = Units(scan)
    for dimension, terms in KINDS:
        groups: dict[tuple[str, Term], list[Numbers]] = {}
        for node, size in _sizes(scan, terms).items():
            unit = units.measuring(node, dimension) if dimension else units.only(node)
            if unit is not None:
                found = Numbers(node, size, unit)
                groups.setdefault((split_name(node)[0], unit.measures), []).append(found)
        for group in groups.values():
            yield from _odd(group)


def _sizes(scan: PredicateIndex, terms: tuple[Term, ...]) -> Mapping[Term, float]:
    sizes: dict[Term, float] = {}
    for term in terms:
        for node, number in scan.numbers(term).items():
            sizes[node] = max(abs(number), sizes.get(node, 0.0))
    return sizes


def _odd(group: list[Numbers]) -> Iterator[Triple]:
    (usual, count), *_ = Counter(each.unit.factor for each in group).most_common(1)
    if count < OTHERS or 2 * count <= len(group):
        return
    others = sorted(each for each in group if each.unit.factor == usual and each.size > 0.0)
    if not others:
        return
    least, most = (end(each.size for each in others) for end in (min, max))
    for each in sorted(group):
        size = each.size * each.unit.factor / usual
        apart = size * APART < least or size > most * APART
        alike = least <= each.size * NEAR and each.size <= most * NEAR
        if each.unit.factor != usual and alike and apart:
            yield each.node, fact("unit-unlike"), others[0].node
            yield from numbers(each.node, [("least-like", least), ("most-like", most)])
