"""The lines of a picture: from shape to shape, from column to column, and round loops."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.reporters.picture.boxes import CLEAR, Box
from kinlint.reporters.picture.escape import empty, number
from kinlint.reporters.picture.placement import CHANNEL, MARGIN, Layout, Place

STRAY = 5.0
"""Distance in pixels between lines from one column to the next."""

CLEARANCE = 14.0
"""Distance in pixels of a loop from what it passes; less than the margin."""
FAR = 40
"""A loop over more parts is not led round all of them."""


def edges(boxes: Sequence[Box], layout: Layout, arrow: str) -> Iterator[str]:
    """The paths to each shape from the one it hangs below; *arrow* is the id of the arrowhead."""
    crossing: dict[int, int] = {}
    for index, box in enumerate(boxes):
        if box.above < 0:
            continue
        parent, child = layout.places[box.above], layout.places[index]
        above = boxes[box.above]
        lane = 0
        if parent.column != child.column:
            lane = crossing[child.column] = crossing.get(child.column, 0) + 1
        way = _way(above, parent, box, child, layout, lane)
        arrowed = f"url(#{arrow})" if box.kind in {"link", "absent"} else None
        yield empty("path", class_=f"edge {box.kind}-edge", d=way, marker_end=arrowed)


def _way(  # noqa: PLR0913, PLR0917
    above: Box, parent: Place, box: Box, child: Place, layout: Layout, lane: int
) -> str:
    if layout.across:
        x, y = parent.x + above.width / 2, parent.y
        end = child.x - box.width / 2
        bend = end - (box.label_width + 2 * CLEAR if box.label else 0.0)
        middle = (x + bend) / 2
        curve = f"M{_at(x, y)}C{_at(middle, y)} {_at(middle, child.y)} {_at(bend, child.y)}"
        return f"{curve}H{number(end)}" if box.label else curve
    x, y = parent.x, parent.y + above.height / 2
    end = child.y - box.height / 2
    bend = end - box.label_height
    if not lane:
        middle = (y + bend) / 2
        curve = f"M{_at(x, y)}C{_at(x, middle)} {_at(child.x, middle)} {_at(child.x, bend)}"
        return f"{curve}V{number(end)}" if box.label else curve
    column = MARGIN + child.column * layout.step - CHANNEL / 2 + STRAY * (lane - 2)
    top = MARGIN / 2
    low = y + 10.0
    return (
        f"M{_at(x, y)}V{number(low)}H{number(column)}V{number(top)}H{number(child.x)}V{number(end)}"
    )


def loops(
    boxes: Sequence[Box], layout: Layout, ends: Mapping[str, str], arrow: str
) -> Iterator[str]:
    """Dashed paths from the joints that close loops to the links in *ends*, all by their IRIs."""
    place = {box.iri: index for index, box in enumerate(boxes)}
    for joint, link in ends.items():
        if joint in place and link in place:
            way = _round(boxes, layout, place[joint], place[link])
            yield empty("path", class_="edge closing", d=way, marker_end=f"url(#{arrow})")


def _round(boxes: Sequence[Box], layout: Layout, joint: int, link: int) -> str:
    """Return the line from side to side, or out to the right and back if one is above the other."""
    one, start = boxes[joint], layout.places[joint]
    other, end = boxes[link], layout.places[link]
    apart = end.x - start.x
    if abs(apart) < (one.width + other.width) / 2 + 10.0:
        right = start.x + one.width / 2, end.x + other.width / 2
        middle = max(*right, *_passed(boxes, layout, joint, link)) + CLEARANCE
        # A curve of Bézier reaches three quarters of the way to what bends it.
        out = (middle - sum(right) / 8) / 0.75
        return (
            f"M{_at(right[0], start.y)}C{_at(out, start.y)} {_at(out, end.y)} "
            f"{_at(right[1], end.y)}"
        )
    side = 1.0 if apart > 0 else -1.0
    x, to = start.x + side * one.width / 2, end.x - side * other.width / 2
    bulge = side * max(30.0, abs(to - x) / 2)
    return f"M{_at(x, start.y)}C{_at(x + bulge, start.y)} {_at(to - bulge, end.y)} {_at(to, end.y)}"


def _passed(boxes: Sequence[Box], layout: Layout, joint: int, link: int) -> Iterator[float]:
    """The right edges of what *joint* hangs below, up to *link*, as far as that is near."""
    at = boxes[joint].above
    for _ in range(FAR):
        if at in {-1, link}:
            return
        if layout.places[at].column == layout.places[joint].column:
            yield layout.places[at].x + boxes[at].width / 2
        at = boxes[at].above


def _at(x: float, y: float) -> str:
    return f"{number(x)},{number(y)}"
