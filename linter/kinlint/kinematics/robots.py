"""Which links and joints make one robot, where files and graphs hold several."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import is_address, lifted_at, split, steps
from kinlint.facts.component import JOINTS
from kinlint.facts.forest import Roots
from kinlint.facts.scan import Scan
from kinlint.kinematics.arrangement import Branch
from kinlint.kinematics.mechanics import Mechanics
from kinlint.terms import Term, iri_value


class Robots:
    """The parts of a closed model in groups: each is connected, or one model of one file."""

    def __init__(self, scan: Scan, mechanics: Mechanics, branches: Sequence[Branch]) -> None:
        self.scan = scan
        self.mechanics = mechanics
        self.branches = branches
        self._sets = Roots()
        for each in branches:
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
        """The joints of each kinematic chain that no element was made into."""
        known = {each.joint for each in self.branches}
        return {
            chain: named
            for chain, joints in sorted(self.scan.table(JOINTS).items())
            if (named := [each for each in joints if each in known])
        }

    @cached_property
    def _models(self) -> Mapping[Term, Sequence[Term]]:
        """The parts in each robot of URDF, and in each model of SDF that is in no other."""
        found: dict[Term, list[Term]] = {}
        for part in (*self.mechanics.bodies, *(each.joint for each in self.branches)):
            if is_address(part):
                found.setdefault(model_of(part), []).append(part)
        return found

    def _alone(self) -> Iterator[Sequence[Term]]:
        """Bodies that nothing is joined to: with the one robot of their file, or by themselves."""
        joined = {end for each in self.branches for end in each.ends}
        loose: dict[int, list[Term]] = {}
        for body in self.mechanics.bodies:
            if body not in joined and not is_address(body):
                loose.setdefault(self.scan.place(body)[0], []).append(body)
        if not loose:
            return
        homes: dict[int, dict[Term, None]] = {}
        for each in self.branches:
            for part in (each.joint, *each.ends):
                whole = self._sets.of(each.joint)
                homes.setdefault(self.scan.place(part)[0], {})[whole] = None
        for home, bodies in loose.items():
            robots = list(homes.get(home, ()))
            yield (*robots, *bodies) if len(robots) == 1 else bodies

    def groups(self) -> Sequence[tuple[Sequence[Term], Sequence[Branch]]]:
        """The bodies and the branches of each robot, all in the order of the text."""
        bodies: dict[Term, list[Term]] = {}
        branches: dict[Term, list[Branch]] = {}
        for body in self.mechanics.bodies:
            bodies.setdefault(self._sets.of(body), []).append(body)
        for each in self.branches:
            branches.setdefault(self._sets.of(each.joint), []).append(each)
        return [(bodies.get(key, ()), branches.get(key, ())) for key in {**bodies, **branches}]


def model_of(part: Term) -> Term:
    """The robot or the outermost model that an element's *part* is in, by its address."""
    way: list[str] = []
    kinds = ["world", "model"]
    for tag, name in steps(split(iri_value(part))[1], tuple(kinds)):
        if not name or tag not in kinds:
            break
        del kinds[: kinds.index(tag) + 1]
        way += (tag, name)
    return lifted_at(part, "/".join(way))
