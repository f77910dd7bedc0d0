"""Joints that move with others: mimics of URDF and SDF, and couplings of composable models."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from kinlint.facts.mechanism import named
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.findings.locator import Locator
from kinlint.kinematics.joint_numbers import JointNumbers
from kinlint.structure import Coupling
from kinlint.terms import Term

LEADER, FOLLOWER = kin("leader"), kin("follower")


class Couplings:
    """Couplings of a closed model, by the joint that follows."""

    def __init__(self, scan: PredicateIndex, locator: Locator, numbers: JointNumbers) -> None:
        self.scan = scan
        self.locator = locator
        self.numbers = numbers

    @cached_property
    def _following(self) -> Mapping[Term, list[Term]]:
        found: dict[Term, list[Term]] = {}
        for coupling, joints in sorted(self.scan.table(FOLLOWER).items()):
            for joint in joints:
                found.setdefault(joint, []).append(coupling)
        return found

    def couplings(self, joint: Term) -> Iterator[Coupling]:
        """Yield the couplings that make *joint* move."""
        for node in self._following.get(joint, ()):
            for leader in self.scan.table(LEADER).values(node):
                yield Coupling(
                    iri=named(node),
                    name=named(node).rpartition("#")[2],
                    leader=named(leader),
                    follower=named(joint),
                    multiplier=self.scan.numbers(kin("multiplier")).get(node),
                    offset=self.numbers.si(node, self.scan.numbers(kin("offset"))),
                    location=self.locator.node(node),
                    whole=self.locator.whole(node),
                )
