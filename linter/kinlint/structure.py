"""Kinematic structure of a robot as plain data, which pictures and outlines show."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple, TypeAlias

from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Location

Vector: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Frame:
    """Frame on a link."""

    iri: str
    """IRI or blank node label."""
    name: str
    """Name for people."""
    location: Location | None = None
    """Place of its identifier."""
    whole: Location | None = None
    """Place of its description."""


@dataclass(frozen=True, slots=True)
class Link:
    """Rigid body."""

    iri: str
    """IRI or blank node label."""
    name: str
    """Name for people."""
    location: Location | None = None
    """Place of its identifier."""
    whole: Location | None = None
    """Place of its description."""
    frames: tuple[Frame, ...] = ()
    """Frames on it, in the order of the text."""
    absent: bool = False
    """True if joints name it, but nothing describes it."""
    point: Vector | None = None
    """Its origin in m as the root of its tree sees it, with all joints at zero."""
    centre: Vector | None = None
    """Its centre of mass, seen likewise."""


@dataclass(frozen=True, slots=True)
class Origin:
    """Pose of a joint as its parent sees it; None is what no one relation states."""

    xyz: Vector | None = None
    """Position in m."""
    rpy: Vector | None = None
    """Angles in rad about the fixed axes x, y and z (REP-103)."""


@dataclass(frozen=True, slots=True)
class Joint:
    """Joint between a parent and a child link."""

    iri: str
    """IRI or blank node label."""
    name: str
    """Name for people."""
    kind: str = ""
    """Type such as `revolute` or `fixed`, as the file writes it; empty if it does not."""
    parent: str | None = None
    """IRI of the link on the side of the root; None if none is stated."""
    child: str | None = None
    """IRI of the link on the other side; None if none is stated."""
    others: tuple[str, ...] = ()
    """IRIs of further links of a joint that joins more than two."""
    closes: bool = False
    """True if it closes a loop and is no branch of the tree: its child hangs elsewhere."""
    origin: Origin | None = None
    """Pose in the frame of the parent."""
    axis: Vector | None = None
    """Unit vector of its axis in its own frame."""
    lower: float | None = None
    """Lower position limit in rad or m."""
    upper: float | None = None
    """Upper position limit in rad or m."""
    point: Vector | None = None
    """Its place on the parent in m as the root of its tree sees it, with all joints at zero."""
    end: Vector | None = None
    """Its place on the child, seen likewise: another one if a loop does not close at zero."""
    direction: Vector | None = None
    """Unit vector of its axis, seen likewise."""
    placed: bool = False
    """True if the files state its place on both links."""
    location: Location | None = None
    """Place of its identifier."""
    whole: Location | None = None
    """Place of its description."""


@dataclass(frozen=True, slots=True)
class Coupling:
    """Linear dependency of one joint's position on another's: a mimic, or a gear."""

    iri: str
    """IRI or blank node label."""
    name: str
    """Name for people."""
    leader: str
    """IRI of the joint that is followed."""
    follower: str
    """IRI of the joint that follows."""
    multiplier: float | None = None
    """Factor of the position of the leader."""
    offset: float | None = None
    """Position in rad or m that is added."""
    location: Location | None = None
    """Place of its identifier."""
    whole: Location | None = None
    """Place of its description."""


Part: TypeAlias = Link | Joint


class Step(NamedTuple):
    """Part on the way through a tree."""

    part: Part
    """Link or joint."""
    depth: int
    """Number of parts between it and its root."""
    above: int
    """Index of the step that it hangs below; -1 for roots."""


@dataclass(frozen=True)
class Structure:
    """Robot: its parts in the order of the text, and the trees that they make."""

    iri: str
    """IRI or blank node label."""
    name: str
    """Name for people."""
    links: tuple[Link, ...] = ()
    """Links in the order of the text."""
    joints: tuple[Joint, ...] = ()
    """Joints in the order of the text."""
    couplings: tuple[Coupling, ...] = ()
    """Couplings of its joints."""
    roots: tuple[str, ...] = ()
    """IRIs of the links that trees begin with."""
    files: tuple[str, ...] = ()
    """Names of the texts that describe it."""
    location: Location | None = None
    """Place of its identifier."""
    whole: Location | None = None
    """Place of its description."""
    owners: Mapping[str, str] = field(default_factory=dict, repr=False)
    """IRI of the part, or of the robot, by the term of each entity that a finding is about."""

    @cached_property
    def _links(self) -> Mapping[str, Link]:
        return {each.iri: each for each in self.links}

    @cached_property
    def _joints(self) -> Mapping[str, Joint]:
        return {each.iri: each for each in self.joints}

    @cached_property
    def _below(self) -> Mapping[str, Sequence[Joint]]:
        found: dict[str, list[Joint]] = {}
        for joint in self.joints:
            if joint.parent is not None:
                found.setdefault(joint.parent, []).append(joint)
        return found

    def link(self, iri: str) -> Link | None:
        """Return the link with this IRI."""
        return self._links.get(iri)

    def joint(self, iri: str) -> Joint | None:
        """Return the joint with this IRI."""
        return self._joints.get(iri)

    def below(self, iri: str) -> Sequence[Joint]:
        """Return the joints that branch off a link, among them those that close a loop."""
        return self._below.get(iri, ())

    @property
    def parts(self) -> tuple[Part, ...]:
        """All links, then all joints."""
        return (*self.links, *self.joints)

    @property
    def loops(self) -> tuple[Joint, ...]:
        """The joints that close a loop."""
        return tuple(each for each in self.joints if each.closes)

    def steps(self) -> Iterator[Step]:
        """Yield all parts, each once and after the part it hangs below.

        First come the trees, from their roots; then the joints that hang below no link. Nothing
        hangs below a joint that closes a loop.
        """
        loose = [joint for joint in self.joints if joint.parent is None]
        roots = [link for iri in self.roots if (link := self.link(iri)) is not None]
        begins: list[Part] = [*roots, *loose]
        waiting = [Step(part, 0, -1) for part in reversed(begins)]
        index = 0
        while waiting:
            step = waiting.pop()
            yield step
            parts = self._hanging(step.part)
            waiting += [Step(part, step.depth + 1, index) for part in reversed(parts)]
            index += 1

    def _hanging(self, part: Part) -> Sequence[Part]:
        if isinstance(part, Link):
            return self.below(part.iri)
        if part.closes:
            return ()
        ends = (self.link(iri) for iri in (part.child, *part.others) if iri is not None)
        return [link for link in ends if link is not None]

    def owner(self, focus: str) -> str | None:
        """Return the IRI of the part, or of the robot, that the entity *focus*, a term, is of."""
        return self.owners.get(focus)
