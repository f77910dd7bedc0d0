"""Differences between files of different formats that describe one robot."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.comparison.comparison import Comparison
from kinlint.facts.comparison.described_robot import DescribedRobot
from kinlint.facts.comparison.extraction import RobotExtraction, RobotParts
from kinlint.facts.comparison.measured import Measured
from kinlint.facts.comparison.tolerances import EXPORTED
from kinlint.facts.comparison.unmatched_parts import unmatched_parts
from kinlint.facts.description_pairs import Description, DescriptionPairs
from kinlint.facts.fact_statements import fact, fact_node, numbers
from kinlint.terms import Term, Triple, literal

MATCHED = 2.0 / 3.0
"""Least share of common joints in two descriptions that nothing but their numbers connects."""
TELLING = 4
"""Least number of equal masses, centres and origins that show two such to be of one robot."""
NOTHING = 1e-12
"""Values below are what rounding leaves of zero."""
UNLIMITED = "unlimited"
"""Word for a bound that there is not."""
ENTRIES = {"moments": ("ixx", "iyy", "izz"), "products": ("ixy", "ixz", "iyz")}


class DescriptionDrifts:
    """Robots of a run that are described more than once."""

    def __init__(self, parts: RobotParts) -> None:
        self.extraction = RobotExtraction(parts)
        self.pairs = DescriptionPairs(parts.scan, parts.mechanism)
        self._robots: dict[int, DescribedRobot] = {}

    def facts(self) -> Iterator[Triple]:
        """Yield each difference: the part, the quantity, both values, and why they are compared."""
        number = 0
        for comparison, evidence in self._compared():
            for each in (*comparison.differences, *unmatched_parts(comparison)):
                node = fact_node("drift", number := number + 1)
                yield each.at, fact("drift"), node
                yield node, fact("from"), each.there
                yield node, fact("evidence"), literal(evidence)
                yield node, fact("aspect"), literal(each.aspect)
                yield from _told(node, each)

    def _compared(self) -> Iterator[tuple[Comparison, str]]:
        """Yield the descriptions of one robot, compared, and what shows that they are of one."""
        met: set[int] = set()
        for one, other, ties in self.pairs.pairs():
            comparison = self._comparison(one, other)
            if evidence := ties or comparison.agreement(alone=self.pairs.are_one):
                met |= {id(one), id(other)}
                yield comparison, evidence
        for one, other in self.pairs.unnamed():
            if met.isdisjoint((id(one), id(other))):
                comparison = self._comparison(one, other)
                if _is_one_robot(comparison):
                    yield comparison, comparison.agreement()

    def _comparison(self, one: Description, other: Description) -> Comparison:
        return Comparison(self._robot(one), self._robot(other), EXPORTED)

    def _robot(self, described: Description) -> DescribedRobot:
        if id(described) not in self._robots:
            self._robots[id(described)] = self.extraction.robot(
                described.form, described.bodies.values(), described.joints.values()
            )
        return self._robots[id(described)]


def _is_one_robot(comparison: Comparison) -> bool:
    """Tell whether two robots without a common name have joints and numbers in common."""
    one, other = comparison.one, comparison.other
    least = MATCHED * min(len(one.joints), len(other.joints))
    if not one.joints or len(comparison.correspondence.joints) < least:
        return False
    equal = sum(each.individual and not each.differs for each in comparison.measured)
    return equal >= TELLING and bool(comparison.agreement())


def _told(node: Term, each: Measured) -> Iterator[Triple]:
    """Yield the quantity of a difference, and its values: a number, or a word."""
    if each.quantity.startswith("orientation") and isinstance(each.other, float):
        yield node, fact("quantity"), literal(each.quantity)
        yield from numbers(node, [("angle", each.other)])
        return
    at = each.component
    yield node, fact("quantity"), literal(_label(each, at))
    for name, value in (("here", each.here), ("there", each.other)):
        if isinstance(value, tuple):
            value = value[at or 0]  # noqa: PLW2901  the component that differs most
        if isinstance(value, float):
            shown = 0.0 if abs(value) < NOTHING else float(f"{value:.12g}")
            yield from numbers(node, [(name, shown)])
        else:
            yield node, fact(name), literal(UNLIMITED if value is None else value)


def _label(each: Measured, component: int | None) -> str:
    """Return the quantity, with the component, and the unit where its name does not imply it."""
    what = each.quantity.partition(" ")[0]
    if what in ENTRIES and component is not None:
        return f"{what[:-1]} of inertia {ENTRIES[what][component]} in {each.unit}"
    if each.quantity == "mass":
        return f"mass in {each.unit}"
    return each.quantity if component is None else f"{each.quantity} along {'xyz'[component]}"
