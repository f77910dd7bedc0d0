"""Links and joints grouped by robot, where files and graphs hold several."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import is_address
from kinlint.facts.connected_components import JOINTS
from kinlint.facts.joint_trees import Edge
from kinlint.facts.mechanism import Mechanism, model_of
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spanning_forest import DisjointSets
from kinlint.terms import Term


class RobotGroups:
    """Parts of a closed model in groups: each is connected, or one model of one file."""

    def __init__(self, scan: PredicateIndex, mechanism: Mechanism, edges: Sequence[Edge]) -> None:
        self.scan = scan
        self.mechanism = mechanism
        self.edges = edges
        self._sets = DisjointSets()
        for each in edges:
            self._together((each.joint, *each.ends))
        for joints in self.chains.values():
            self._together(joints)
        for model, parts in self._models.items():
            self._together((model, *parts))
        for parts in self._alone():
            self._together(parts)

    def _together(self, parts: Iterable[Term]) -> None:
        first, *others = parts
        for each in others:
            self._sets.join(first, each)

    @cached_property
    def chains(self) -> Mapping[Term, Sequence[Term]]:
        """Joints of each kinematic chain that no element was made into."""
        known = {each.joint for each in self.edges}
        return {
            chain: named
            for chain, joints in sorted(self.scan.table(JOINTS).items())
            if (named := [each for each in joints if each in known])
        }

    @cached_property
    def _models(self) -> Mapping[Term, Sequence[Term]]:
        """Parts of each robot of URDF, and of each model of SDF that is in no other."""
        found: dict[Term, list[Term]] = {}
        for part in (*self.mechanism.bodies, *(each.joint for each in self.edges)):
            if is_address(part):
                found.setdefault(model_of(part), []).append(part)
        return found

    def _alone(self) -> Iterator[Sequence[Term]]:
        """Yield bodies that nothing is joined to.

        With the one robot of their file, or by themselves.
        """
        joined = {end for each in self.edges for end in each.ends}
        loose: dict[int, list[Term]] = {}
        for body in self.mechanism.bodies:
            if body not in joined and not is_address(body):
                loose.setdefault(self.scan.place(body)[0], []).append(body)
        if not loose:
            return
        homes: dict[int, dict[Term, None]] = {}
        for each in self.edges:
            for part in (each.joint, *each.ends):
                whole = self._sets.representative(each.joint)
                homes.setdefault(self.scan.place(part)[0], {})[whole] = None
        for home, bodies in loose.items():
            robots = list(homes.get(home, ()))
            yield (*robots, *bodies) if len(robots) == 1 else bodies

    def groups(self) -> Sequence[tuple[Sequence[Term], Sequence[Edge]]]:
        """Return the bodies and the edges of each robot, all in the order of the text."""
        bodies: dict[Term, list[Term]] = {}
        edges: dict[Term, list[Edge]] = {}
        for body in self.mechanism.bodies:
            bodies.setdefault(self._sets.representative(body), []).append(body)
        for each in self.edges:
            edges.setdefault(self._sets.representative(each.joint), []).append(each)
        return [(bodies.get(key, ()), edges.get(key, ())) for key in {**bodies, **edges}]
