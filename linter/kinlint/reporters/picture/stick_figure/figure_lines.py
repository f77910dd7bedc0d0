"""Lines of a stick figure: the floor, links, joints and the frame of the root, as markup."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from kinlint.reporters.picture.escape import element, empty, text
from kinlint.reporters.picture.finding_badges import Marks, badge
from kinlint.reporters.picture.stick_figure.joint_glyphs import STEP, Glyph
from kinlint.reporters.picture.stick_figure.projection import (
    coordinate,
    coordinates,
    depth,
    project,
    way,
)
from kinlint.reporters.picture.stick_figure.skeleton import RADIUS, Skeleton, Stick
from kinlint.structure import Joint, Vector

RING, LEAST = 9.0, 1.5
"""Radius of the ring of a joint in pixels, and the least where joints are near each other."""
END = 4.0
"""Radius of the end of a link in pixels."""
DENSE = 60
"""Number of joints above which lines are thin and circles coarse."""
ARROW = 34.0
"""Length in pixels of the axes at the root."""
SQUARES = (1.0, 2.0, 5.0)
"""Sides of the squares of the floor, times a power of ten, in m."""


class FigureLines:
    """Lines of one robot, each with its points in space, from which a script turns it."""

    def __init__(self, skeleton: Skeleton, found: Marks) -> None:
        self.skeleton = skeleton
        self.structure = skeleton.structure
        self.found = found

    @cached_property
    def sticks(self) -> Sequence[Stick]:
        """Sticks of all links, in pixels."""
        return list(self.skeleton.sticks())

    @cached_property
    def joints(self) -> Sequence[tuple[Joint, Vector]]:
        """Joints with their places in pixels."""
        return list(self.skeleton.joints())

    @cached_property
    def square(self) -> float:
        """Side of the squares of the floor in m: a round number, so that there are about ten."""
        wanted = self.skeleton.size / 9.0
        power = 10.0 ** math.floor(math.log10(wanted))
        return next((each * power for each in SQUARES if each * power >= wanted), 10.0 * power)

    @cached_property
    def middle(self) -> float:
        """Height of the middle of robot and floor in pixels, downwards."""
        reach, z = self._reach, self.skeleton.floor
        corners = [(x, y, z) for x in (-reach, reach) for y in (-reach, reach)]
        ends = (end for each in self.sticks for end in (each.start, each.end))
        heights = [project(point)[1] for point in (*corners, *ends)]
        return (min(heights) + max(heights)) / 2.0

    @property
    def _reach(self) -> float:
        """Distance in pixels from the middle of the floor to its sides."""
        side = self.square * self.skeleton.scale
        return side * math.ceil(RADIUS * 0.7 / side)

    def floor(self) -> Iterator[str]:
        """Yield the lines of the floor, below the lowest point."""
        side, reach, z = self.square * self.skeleton.scale, self._reach, self.skeleton.floor
        for number in range(round(2 * reach / side) + 1):
            at = number * side - reach
            yield _line("", [(at, -reach, z), (at, reach, z)])
            yield _line("", [(-reach, at, z), (reach, at, z)])

    def parts(self) -> Iterable[str]:
        """Yield links and joints, the farthest first."""
        parts = [*self._bones(), *self._glyphs()]
        return (shown for _, shown in sorted(parts, key=lambda each: each[0]))

    def _bones(self) -> Iterator[tuple[float, str]]:
        for each in self.sticks:
            severity = self._severity(each.link.iri)
            kind = f"bone tip{severity}" if each.tip else f"bone{severity}"
            far = (depth(each.start) + depth(each.end)) / 2
            told = element("title", text(each.link.name))
            shown = "" if each.start == each.end else _line(kind, [each.start, each.end])
            if each.tip or (not shown and each.link.iri not in self._moved):
                shown += _dot(f"end{severity}", each.end, END)
            if shown:
                yield far, element("g", told + shown, data_z=coordinates([each.start, each.end]))

    @cached_property
    def _moved(self) -> frozenset[str]:
        """Links at the end of a joint that is drawn."""
        return frozenset(
            end for joint, _ in self.joints for end in (joint.child, *joint.others) if end
        )

    def _glyphs(self) -> Iterator[tuple[float, str]]:
        along = {each.link.iri: each.vector for each in reversed(self.sticks)}
        for joint, at in self.joints:
            toward = along.get(joint.child or "", (0.0, 0.0, 0.0))
            size = self._size(joint, toward)
            step = STEP if len(self.joints) <= DENSE else 2.0 * STEP
            lines = Glyph(joint, at, toward, size, self.skeleton.scale, step).lines()
            shown = "".join(_line(each.kind, each.points, closed=each.closed) for each in lines)
            if joint.closes and joint.end not in {None, joint.point}:
                end = self.skeleton.pixels(joint.end or at, joint.iri)
                shown += _line("gap", [at, end])
            kind = "fixed" if joint.kind == "fixed" else "moving"
            shown += _dot(
                f"{kind}{self._severity(joint.iri)}",
                at,
                0.3 * size if kind == "fixed" else 0.5 * size,
            )
            told = element("title", text(" ".join(filter(None, (joint.name, joint.kind)))))
            yield (
                depth(at) + 1.0,
                element("g", told + shown, class_="joint", data_z=coordinates([at])),
            )

    def _size(self, joint: Joint, toward: Vector) -> float:
        """Return the radius of the ring of *joint*, by the lengths of the links beside it."""
        own = math.hypot(*toward)
        near = min(filter(None, (own, self._lengths.get(joint.parent or ""))), default=RING * 3)
        return min(RING, max(LEAST, 0.34 * near))

    @cached_property
    def _lengths(self) -> dict[str, float]:
        """Length of the shortest stick of each link."""
        found: dict[str, float] = {}
        for each in self.sticks:
            if size := math.dist(each.start, each.end):
                found[each.link.iri] = min(size, found.get(each.link.iri, size))
        return found

    def _severity(self, part: str) -> str:
        mark = badge(self.found.get(part, ()))
        return f" {mark.severity.label}" if mark is not None else ""

    def root(self) -> Iterator[str]:
        """Yield the axes of the frame that the first tree begins with."""
        first = self.structure.link(next(iter(self.structure.roots), ""))
        if first is None or first.point is None:
            return
        at = self.skeleton.pixels(first.point, first.iri)
        for number, axis in enumerate("xyz"):
            end = list(at)
            end[number] += ARROW
            x, y, z = end
            yield _line(f"axis-{axis}", [at, (x, y, z)])
            end[number] += 8.0
            x, y, z = end
            shown = element("text", axis, class_=f"axis-{axis}")
            yield _placed(shown, (x, y, z))


def _line(kind: str, points: Sequence[Vector], *, closed: bool = False) -> str:
    return empty(
        "path",
        class_=kind or None,
        d=way(points, closed=closed),
        data_p=coordinates(points),
    )


def _dot(kind: str, at: Vector, radius: float) -> str:
    return _placed(empty("circle", class_=kind, r=radius), at)


def _placed(shown: str, at: Vector) -> str:
    x, y = project(at)
    moved = f"translate({coordinate(x)} {coordinate(y)})"
    return element("g", shown, transform=moved, data_at=coordinates([at]))
