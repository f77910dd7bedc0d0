"""Limits of zero, and how many of their kind are not zero: an outlier, or a habit of the file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cached_property

from kinlint.facts.fact_statements import fact, integer
from kinlint.facts.metamodel_terms import chain, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Term, Triple

KINDS = tuple(kin(f"Actuator{name}Limit") for name in ("Force", "Velocity"))


def zero_limits(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each limit of zero how many others in its chain are zero, and how many not."""
    return ZeroLimits(scan).facts()


class ZeroLimits:
    """Limits of actuators, with the chains that their joints are in."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan

    @cached_property
    def _upper(self) -> Mapping[Term, float]:
        return self.scan.numbers(kin("upper"))

    @cached_property
    def _following(self) -> frozenset[Term]:
        """Joints that follow others, and need no actuator."""
        return frozenset(self.scan.single(kin("follower")).values())

    def facts(self) -> Iterator[Triple]:
        """Yield for each limit of zero how many others in its chain are zero, and how many not."""
        chains: dict[Term, Term] = {}
        for whole, joints in self.scan.table(chain("joints")).items():
            chains.update((joint, min(whole, chains.get(joint, whole))) for joint in joints)
        joint_of = self.scan.single(kin("actuates"))
        for kind in KINDS:
            found: dict[Term, list[Term]] = {}
            for limit in sorted(self.scan.instances(kind)):
                joint = joint_of.get(self.scan.single(kin("of-actuator")).get(limit, ""), "")
                if joint in chains and joint not in self._following and limit in self._upper:
                    found.setdefault(chains[joint], []).append(limit)
            for limits in found.values():
                yield from self._counted(limits)

    def _counted(self, limits: list[Term]) -> Iterator[Triple]:
        zero = {limit: self._is_zero(limit) for limit in limits}
        counts = Counter(zero.values())
        for limit in limits:
            if zero[limit]:
                yield limit, fact("idle"), integer(counts[True])
                yield limit, fact("working"), integer(counts[False])

    def _is_zero(self, limit: Term) -> bool:
        """Tell whether *limit* allows nothing in either direction."""
        return self._upper[limit] == 0.0 and self.scan.numbers(kin("lower")).get(limit, 0.0) >= 0.0
