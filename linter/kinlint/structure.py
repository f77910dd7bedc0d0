"""The kinematic structure of a robot: what a picture or an outline of it shows, as plain data."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple, TypeAlias

from kinlint.text import Location

Vector: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame on a link, by its IRI or blank node label, and where it is described."""

    iri: str
    name: str
    location: Location | None = None
    whole: Location | None = None


@dataclass(frozen=True, slots=True)
class Link:
    """A rigid body.

    `location` is the place of its identifier, `whole` that of its description. An `absent` one
    is joined by a joint, but described nowhere.
    """

    iri: str
    name: str
    location: Location | None = None
    whole: Location | None = None
    frames: tuple[Frame, ...] = ()
    absent: bool = False


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a joint is, as its parent sees it: `xyz` in m, `rpy` in rad about fixed axes.

    None is what no one relation states.
    """

    xyz: Vector | None = None
    rpy: Vector | None = None


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint between the links `parent` and `child`, by their IRIs; None where none is said.

    `kind` is a word such as `revolute` or `fixed`, as the file says it, or nothing. `others` are
    further links that hang on a joint which joins more than two. One that `closes` a loop is no
    branch of the tree: its child hangs elsewhere. `lower` and `upper` bound its position, in rad
    or m; `axis` is a direction as the joint's own frame sees it.
    """

    iri: str
    name: str
    kind: str = ""
    parent: str | None = None
    child: str | None = None
    others: tuple[str, ...] = ()
    closes: bool = False
    origin: Origin | None = None
    axis: Vector | None = None
    lower: float | None = None
    upper: float | None = None
    location: Location | None = None
    whole: Location | None = None


@dataclass(frozen=True, slots=True)
class Coupling:
    """What makes the joint `follower` move with the joint `leader`: a mimic, or a gear.

    The follower is where the leader is times `multiplier`, plus `offset` in rad or m.
    """

    iri: str
    name: str
    leader: str
    follower: str
    multiplier: float | None = None
    offset: float | None = None
    location: Location | None = None
    whole: Location | None = None


Part: TypeAlias = Link | Joint


class Step(NamedTuple):
    """A part on the way through a tree: how deep it hangs, and below which earlier step, or -1."""

    part: Part
    depth: int
    above: int


@dataclass(frozen=True)
class Structure:
    """One robot: its parts in the order of the text, and the trees that they make.

    `roots` are the links that trees begin with, by their IRIs. `files` are the names of the texts
    that describe it. `owners` tells of the entities that findings are about, by their terms, which
    part each belongs to; one that is the robot's own belongs to `iri`.
    """

    iri: str
    name: str
    links: tuple[Link, ...] = ()
    joints: tuple[Joint, ...] = ()
    couplings: tuple[Coupling, ...] = ()
    roots: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    location: Location | None = None
    whole: Location | None = None
    owners: Mapping[str, str] = field(default_factory=dict, repr=False)

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
        """The link with this IRI."""
        return self._links.get(iri)

    def joint(self, iri: str) -> Joint | None:
        """The joint with this IRI."""
        return self._joints.get(iri)

    def below(self, iri: str) -> Sequence[Joint]:
        """The joints that branch off a link, among them those that close a loop."""
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
        """All parts, each once and after what it hangs below.

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
        """The IRI of the part, or of the robot, that the entity *focus*, a term, belongs to."""
        return self.owners.get(focus)
