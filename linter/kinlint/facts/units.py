"""Units of a model: factors from a node's numbers to SI units."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from kinlint.facts.metamodel_terms import qudt, terms_in
from kinlint.facts.predicate_index import PredicateIndex, numeric
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri
from kinlint.vocabulary import QUANTITY_KIND

_dimension = terms_in("http://qudt.org/vocab/dimensionvector/")
ANGLE_KIND = iri(f"{QUANTITY_KIND}Angle")

FACTOR, OFFSET = qudt("conversionMultiplier"), qudt("conversionOffset")
DIMENSION_VECTOR, KIND = qudt("hasDimensionVector"), qudt("hasQuantityKind")

LENGTH = _dimension("A0E0L1I0M0H0T0D0")
MASS = _dimension("A0E0L0I0M1H0T0D0")
FIRST_MOMENT = _dimension("A0E0L1I0M1H0T0D0")
INERTIA = _dimension("A0E0L2I0M1H0T0D0")
SPEED = _dimension("A0E0L1I0M0H0T-1D0")
ACCELERATION = _dimension("A0E0L1I0M0H0T-2D0")
ANGULAR_SPEED = _dimension("A0E0L0I0M0H0T-1D0")
ANGULAR_ACCELERATION = _dimension("A0E0L0I0M0H0T-2D0")
FORCE = _dimension("A0E0L1I0M1H0T-2D0")
TORQUE = _dimension("A0E0L2I0M1H0T-2D0")
ANGLE = "angle"
"""Stands for a dimension, though QUDT tells angles from other pure numbers only by kind."""


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of QUDT."""

    factor: float
    """Factor of numbers in it for SI."""
    offset: float
    """Summand after that."""
    measures: Term
    """The dimension vector of what it measures."""

    def si(self, number: float) -> float:
        """Return *number* of this unit in SI units."""
        return number * self.factor + self.offset


SI = Unit(1.0, 0.0, "")


class Units:
    """Units that nodes of a model name, as far as they are known."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan
        self._units: dict[Term, Unit | None] = {}

    @cached_property
    def _named(self) -> Mapping[Term, tuple[Term, ...]]:
        """Distinct units of each node that names any."""
        named: dict[Term, tuple[Term, ...]] = {}
        for predicate in (qudt("unit"), qudt("hasUnit")):
            for node, found in self.scan.table(predicate).items():
                named[node] = tuple(dict.fromkeys((*named.get(node, ()), *found)))
        return named

    def _known(self, unit: Term) -> Unit | None:
        """Return what QUDT states of *unit*, looked up when it is first named.

        None if it is incomplete.
        """
        if unit not in self._units:
            said = self.scan.statements(unit)
            factors = [each for each in map(numeric, said.get(FACTOR, ())) if each is not None]
            offsets = [each for each in map(numeric, said.get(OFFSET, ())) if each is not None]
            measured = said.get(DIMENSION_VECTOR, [])
            known = len(factors) == 1 and factors[0] > 0.0 and len(measured) == 1
            self._units[unit] = None
            if known:
                measures = ANGLE if ANGLE_KIND in said.get(KIND, ()) else measured[0]
                self._units[unit] = Unit(factors[0], sum(offsets), measures)
        return self._units[unit]

    def has(self, node: Term) -> bool:
        """Tell whether *node* names a unit, known or not."""
        return node in self._named

    def only(self, node: Term) -> Unit | None:
        """Return the unit of a node that names exactly one."""
        found = self._named.get(node, ())
        return self._known(found[0]) if len(found) == 1 else None

    def measuring(self, node: Term, dimension: Term) -> Unit | None:
        """Return the one unit of *node* that is of *dimension*."""
        named = self._named.get(node, ())
        if len(named) == 1:
            only = self._known(named[0])
            return only if only is not None and only.measures == dimension else None
        found = [
            known
            for each in named
            if (known := self._known(each)) is not None and known.measures == dimension
        ]
        return found[0] if len(found) == 1 else None

    def ambiguous(self, node: Term, dimension: Term) -> bool:
        """Tell whether *node* names several units of *dimension*."""
        known = map(self._known, self._named.get(node, ()))
        return sum(each is not None and each.measures == dimension for each in known) > 1
