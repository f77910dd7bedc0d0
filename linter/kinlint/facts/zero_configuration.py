"""Poses of bodies and joints while all joints are at zero, which figures draw.

Frames of one body are placed by the relations between them, and bodies by what coincides at their
joints: their frames, or the vectors that a zero configuration and a common axis name. Where nothing
states a placement, the frames of a joint are taken to be those of the bodies.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.facts.body_frames import BodyFrames
from kinlint.facts.frame_placement import ABOUT, OF_BODY, Placements
from kinlint.facts.joint_meetings import JointMeetings, Meeting
from kinlint.facts.joint_numbers import DIRECTION
from kinlint.facts.joint_trees import Edge
from kinlint.facts.linear_algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    product,
    subtract,
    transpose,
)
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import chain
from kinlint.facts.orientation_graph import OrientationGraph
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativeOrientation, RelativePosition, SpatialRelations
from kinlint.terms import Term

OFFSET = chain("origin-offset")


class ZeroConfiguration:
    """Poses of all parts at zero, each as the root of its tree sees it, in m.

    *edges* are arranged in trees. Takes time linear in relations and joints.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        relations: SpatialRelations,
        placements: Placements,
        edges: Sequence[Edge],
    ) -> None:
        self.scan = mechanism.scan
        self.mechanism = mechanism
        self.relations = relations
        self.placements = placements
        self.edges = sorted(edges, key=lambda each: each.closes)
        self.frames = BodyFrames(mechanism, relations, placements)
        self.meetings = JointMeetings(mechanism, self.edges)

    def _reference(self, body: Term | None, other: Term) -> Term:
        return self.frames.references.get(body or "", other)

    @cached_property
    def _assumed(self) -> Sequence[Meeting]:
        """Frames of joints and bodies that are taken to coincide if nothing else tells."""
        found: list[Meeting] = []
        for each in self.meetings.all:
            for end in (each.near, each.far):
                reference = self._reference(self.mechanism.carrier.get(end), end)
                if reference != end:
                    found.append(Meeting(each.joint, reference, end, IDENTITY))
        return found

    @cached_property
    def _orientations(self) -> OrientationGraph:
        axes = self.relations.axes
        turns = self.relations.turns
        own = [each for each in turns if self.frames.on_one_body(each)]
        made = [*self.meetings.all, *self._assumed]
        met = [
            RelativeOrientation(each.joint, axes(each.near), axes(each.far), each.turn, each.joint)
            for each in made
        ]
        return OrientationGraph([*own, *met])

    def _steps(self) -> Iterator[tuple[Term, Term, RelativePosition | None, Term | None]]:
        """Yield what places points, the surest first.

        Two points with the relation between them, if they do not coincide; and the joint at which
        they are only taken to coincide.
        """
        point, shifts = self.relations.point, self.relations.shifts
        yield from (
            (each.base, each.of, each, None) for each in shifts if self.frames.on_one_body(each)
        )
        offsets: dict[Term, list[RelativePosition]] = {}
        for each in shifts:
            offsets.setdefault(each.relation, []).append(each)
        for meeting in self.meetings.all:
            for relation in self.scan.table(OFFSET).values(meeting.joint):
                yield from ((each.base, each.of, each, None) for each in offsets.get(relation, ()))
            yield point(meeting.near), point(meeting.far), None, None
        for guess in self._assumed:
            yield point(guess.near), point(guess.far), None, guess.joint

    @cached_property
    def _points(self) -> tuple[Mapping[Term, Vector], frozenset[Term]]:
        """Positions in their component, and the joints without a stated one."""
        steps = list(self._steps())
        forest = SpanningForest([(one, other) for one, other, *_ in steps])
        places: dict[Term, Vector] = {}
        guessed: set[Term] = set()
        for node in forest.order:
            if node not in forest.parent:
                places[node] = ZERO
                continue
            above, index = forest.parent[node]
            _, end, shift, guess = steps[index]
            step = ZERO if shift is None else self._turned(shift)
            places[node] = (add if end == node else subtract)(places[above], step)
            if guess is not None:
                guessed.add(guess)
        return places, frozenset(guessed)

    def _turned(self, shift: RelativePosition) -> Vector:
        return apply(self._orientations.matrix(shift.seen_by), shift.vector)

    @cached_property
    def _roots(self) -> Mapping[Term, Term]:
        """Root of the tree of each body."""
        above = {
            body: edge.parent
            for edge in reversed(self.edges)
            if edge.parent is not None and not edge.closes
            for body in (edge.child, *edge.others)
            if body is not None
        }
        found: dict[Term, Term] = {}
        for body in self.mechanism.bodies:
            way = [body]
            while way[-1] not in found and way[-1] in above and len(way) <= len(above):
                way.append(above[way[-1]])
            root = found.get(way[-1], way[-1])
            found.update(dict.fromkeys(way, root))
        return found

    def _seen(self, node: Term, body: Term) -> Vector | None:
        """Return where a point is for the root of the tree that *body* is in."""
        places = self._points[0]
        home = self._reference(self._roots.get(body), node)
        if home == node:
            return ZERO
        point, base = places.get(self.relations.point(node)), self.relations.point(home)
        if point is None:
            return None
        turn = transpose(self._orientations.matrix(self.relations.axes(home)))
        seen = apply(turn, subtract(point, places.get(base, ZERO)))
        return seen if all(map(math.isfinite, seen)) else None

    def is_stated(self, joint: Term) -> bool:
        """Tell whether the files state where *joint* is on the bodies that it joins."""
        return joint not in self._points[1]

    def joint_point(self, edge: Edge) -> Vector | None:
        """Return the place of a joint in m; None if it joins no frame or point."""
        return self._attached(edge, edge.parent)

    def child_point(self, edge: Edge) -> Vector | None:
        """Return where the child of a joint is attached, in m: elsewhere if a loop is open."""
        return self._attached(edge, edge.child)

    def _attached(self, edge: Edge, body: Term | None) -> Vector | None:
        near = self.mechanism.near(edge.joint, body) if body is not None else None
        return None if near is None or body is None else self._seen(near, body)

    def origin(self, body: Term) -> Vector | None:
        """Return where the frame is that *body* is described in, in m."""
        frame = self.frames.references.get(body)
        return self._seen(frame, body) if frame is not None else None

    def pose(self, frame: Term, body: Term) -> tuple[Vector, Matrix] | None:
        """Return the position in m and the rotation of *frame*, which is on *body*."""
        if (point := self._seen(frame, body)) is None:
            return None
        home = self._reference(self._roots.get(body), frame)
        base, own = (self._orientations.matrix(self.relations.axes(each)) for each in (home, frame))
        return point, product(transpose(base), own)

    def body_pose(self, body: Term) -> tuple[Vector, Matrix] | None:
        """Return the pose of the frame that *body* is described in."""
        frame = self.frames.references.get(body)
        return self.pose(frame, body) if frame is not None else None

    def centre(self, body: Term) -> Vector | None:
        """Return the centre of mass of *body* in m."""
        point = self._centres.get(body)
        return self._seen(point, body) if point is not None else None

    @cached_property
    def _centres(self) -> Mapping[Term, Term]:
        """Point that the inertia of each body is about."""
        about = self.scan.single(ABOUT)
        owners = sorted(self.scan.single(OF_BODY).items())
        return {owner: about[inertia] for inertia, owner in owners if inertia in about}

    def direction(self, edge: Edge) -> Vector | None:
        """Return the unit vector of the axis of a joint; None if it has none."""
        joint = edge.joint
        body = edge.parent or edge.child
        if body is None:
            return None
        found = self._axis(joint, self.mechanism.near(joint, body))
        if found is None:
            return None
        home = self._reference(self._roots.get(body), found[0])
        matrices = (
            self._orientations.matrix(self.relations.axes(each)) for each in (home, found[0])
        )
        base, own = matrices
        seen = apply(product(transpose(base), own), found[1])
        return seen if all(map(math.isfinite, seen)) else None

    def _axis(self, joint: Term, near: Term | None) -> tuple[Term, Vector] | None:
        """Return the axis of *joint*, with the frame that its components are along."""
        if near is not None and (written := self.placements.axes.get(joint)) is not None:
            return near, written
        lines = self.meetings.lines(joint)
        told = (self.scan.single(DIRECTION).get(joint, ""), *sorted(lines))
        return next(
            (self.meetings.basis[each] for each in told if each in self.meetings.basis), None
        )
