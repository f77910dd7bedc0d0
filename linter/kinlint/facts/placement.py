"""Where joints and centres of mass are and which way axes point, as URDF and SDF files write it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import is_repeated, lifted
from kinlint.facts.linear import ZERO, Vector, length, scale
from kinlint.facts.names import attribute, sdf, urdf
from kinlint.facts.scan import Scan
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import SRC


def _components(names: Sequence[str]) -> tuple[Term, Term, Term]:
    x, y, z = (iri(f"{SRC}{name}") for name in names)
    return x, y, z


XYZ = (attribute("xyz-1"), attribute("xyz-2"), attribute("xyz-3"))
TEXT = _components(("text-1", "text-2", "text-3"))
TURNS = tuple(attribute(f"{name}-{at}") for name in ("rpy", "quat_xyzw") for at in (1, 2, 3))
TEXT_TURNS = _components(("text-4", "text-5", "text-6"))
ROTATION_FORMAT = attribute("rotation_format")
SEEN_BY_PARENT = _components(("parent-x", "parent-y", "parent-z"))
UNIT_AXIS = _components(("x", "y", "z"))
X_AXIS: Vector = (1.0, 0.0, 0.0)


class Placements:
    """Vectors by joint or body of the composable model, straight from the elements."""

    def __init__(self, scan: Scan) -> None:
        self.scan = scan

    @cached_property
    def origins(self) -> Mapping[Term, Vector]:
        """The place of each joint, as the link that carries it sees it."""
        found = dict(self._below("joint", urdf("origin"), XYZ, ZERO))
        for joint in self._all(sdf("joint")):
            if (seen := self._vector(joint, SEEN_BY_PARENT)) is not None:
                found[lifted(joint)] = seen
        return found

    @cached_property
    def axes(self) -> Mapping[Term, Vector]:
        """The direction of the axis of each joint, in its own frame."""
        found = {
            joint: scale(1.0 / length(axis), axis)
            for joint, axis in self._below("joint", urdf("axis"), XYZ, X_AXIS)
            if length(axis) > 0.0
        }
        for joint in self._all(sdf("joint")):
            for axis in self._children(joint, sdf("axis")):
                for written in self._children(axis, sdf("xyz")):
                    if (unit := self._vector(written, UNIT_AXIS)) is not None:
                        found[lifted(joint)] = unit
        return found

    @cached_property
    def centres(self) -> Mapping[Term, Vector]:
        """The centre of mass of each link, as the link sees it."""
        found: dict[Term, Vector] = {}
        kinds = (("link", urdf, "origin", XYZ), ("link", sdf, "pose", TEXT))
        for tag, space, place, components in kinds:
            for link in self._all(space(tag)):
                for inertial in self._children(link, space("inertial")):
                    at = self._placed(inertial, space(place), components, ZERO)
                    if at is not None:
                        found[lifted(link)] = at
        return found

    @cached_property
    def turned(self) -> frozenset[Term]:
        """The links whose inertia is seen along other axes than theirs, or may be."""
        found: set[Term] = set()
        for space, place, parts in ((urdf, "origin", TURNS), (sdf, "pose", TEXT_TURNS)):
            for link in self._all(space("link")):
                for inertial in self._children(link, space("inertial")):
                    for child in self._children(inertial, space(place)):
                        angles = (self.scan.numbers(each).get(child, 0.0) for each in parts)
                        if any(angles) or child in self.scan.table(ROTATION_FORMAT):
                            found.add(lifted(link))
        return frozenset(found)

    @cached_property
    def carriers(self) -> Mapping[Term, str]:
        """The name of the link that carries each joint."""
        named = self.scan.single(attribute("name"))
        found: dict[Term, str] = {}
        for joint in self._all(urdf("joint")):
            for parent in self._children(joint, urdf("parent")):
                if (link := self.scan.single(attribute("link")).get(parent)) is not None:
                    found[lifted(joint)] = literal_value(link)
        for joint, link in self.scan.single(iri(f"{SRC}parentBody")).items():
            if link in named:
                found[lifted(joint)] = literal_value(named[link])
        return found

    def _all(self, tag: Term) -> Iterator[Term]:
        """The elements called *tag*, the first of each name."""
        every = self.scan.table(tag).items()
        yield from (each for _, found in every for each in found if not is_repeated(each))

    def _children(self, element: Term, tag: Term) -> Iterator[Term]:
        """The first child called *tag*, if there is one."""
        found = (each for each in self.scan.table(tag).of(element) if not is_repeated(each))
        yield from list(found)[:1]

    def _below(
        self, owner: str, tag: Term, components: Sequence[Term], default: Vector
    ) -> Iterator[tuple[Term, Vector]]:
        """What a child called *tag* says of each element of URDF called *owner*."""
        for element in self._all(urdf(owner)):
            if (said := self._placed(element, tag, components, default)) is not None:
                yield lifted(element), said

    def _placed(
        self, element: Term, tag: Term, components: Sequence[Term], default: Vector
    ) -> Vector | None:
        """The vector of a child; *default* without one, None where it is relative to others."""
        for child in self._children(element, tag):
            if child in self.scan.table(attribute("relative_to")):
                return None
            written = any(child in self.scan.table(each) for each in components)
            return self._vector(child, components) if written else default
        return default

    def _vector(self, element: Term, components: Sequence[Term]) -> Vector | None:
        """The numbers that *element* has for all three *components*."""
        x, y, z = (self.scan.numbers(each).get(element) for each in components)
        return None if x is None or y is None or z is None else (x, y, z)
