"""Values of one quantity in two descriptions of a robot."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias

from kinlint.facts.comparison.tolerances import Tolerances
from kinlint.facts.linear_algebra import Vector, length
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term

Value: TypeAlias = "float | str | Vector | None"


@dataclass(frozen=True)
class Measured:
    """Quantity of a part that both descriptions have."""

    quantity: str
    """Name of the quantity, such as `mass`."""
    unit: str
    """Symbol of its unit; empty for a word, or for a number without a unit."""
    part: str
    """Name of the part in the first description."""
    other_part: str
    """Name of the part in the second."""
    at: Term
    """The part in the first description."""
    there: Term
    """The part in the second."""
    here: Value
    """The value in the first description; None if there is none."""
    other: Value
    """The value in the second."""
    differs: bool
    """Tells whether the values differ by more than the tolerance."""
    individual: bool = True
    """Tells whether equal values are evidence of one robot.

    Many robots share an axis along z, a range of half a turn, or an origin at zero.
    """
    sides: tuple[Term, Term] | None = None
    """Nodes that state the values, where they are not the parts themselves."""
    aspect: str = "joint"
    """Kind of quantity: `joint`, `placement`, `mass`, `shape`, `halved`, `missing` or `name`."""

    @property
    def component(self) -> int | None:
        """Index of the component that differs most, of vectors."""
        if not isinstance(self.here, tuple) or not isinstance(self.other, tuple):
            return None
        apart = [abs(a - b) for a, b in zip(self.here, self.other, strict=True)]
        return apart.index(max(apart))


@dataclass(frozen=True)
class Parts:
    """Part of both descriptions, of which quantities are measured with *tolerances*."""

    part: str
    """Name in the first description."""
    other_part: str
    """Name in the second."""
    at: Term
    """The part in the first description."""
    there: Term
    """The part in the second."""
    tolerances: Tolerances
    """Differences that do not count."""
    sides: tuple[Term, Term] | None = None
    """Nodes that state the values, where they are not the parts themselves."""
    aspect: str = "joint"
    """Kind of the quantities, as of one `Measured`."""

    def measured(  # noqa: PLR0913
        self,
        quantity: str,
        unit: str,
        here: Value,
        other: Value,
        *,
        differs: bool,
        individual: bool = True,
    ) -> Measured:
        """Return both values of a quantity."""
        return Measured(
            quantity,
            unit,
            self.part,
            self.other_part,
            self.at,
            self.there,
            here,
            other,
            differs,
            individual,
            self.sides,
            self.aspect,
        )

    def number(
        self, quantity: str, unit: str, here: float, other: float, *, individual: bool = True
    ) -> Measured:
        """Return two numbers."""
        differs = self.tolerances.apart(here, other)
        return self.measured(quantity, unit, here, other, differs=differs, individual=individual)

    def point(self, quantity: str, here: Vector | None, other: Vector | None) -> Iterator[Measured]:
        """Yield two points in m, if both are known; at the origin they are no evidence."""
        if here is not None and other is not None:
            differs = self.tolerances.away(here, other)
            telling = differs or length(here) > self.tolerances.distance
            yield self.measured(quantity, "m", here, other, differs=differs, individual=telling)

    def bound(self, quantity: str, unit: str, here: float | None, other: float | None) -> Measured:
        """Return two bounds; None is infinity."""
        differs = here is not other
        if here is not None and other is not None:
            differs = self.tolerances.apart(here, other)
        return self.measured(quantity, unit, here, other, differs=differs, individual=False)
