"""Placement of the shapes of a picture: downwards, to the right, or downwards in columns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate

from kinlint.light_dataclasses import dataclass
from kinlint.reporters.picture.boxes import CLEAR, Box
from kinlint.reporters.picture.tidy_tree import tidy

BESIDE = 22.0
"""Space between neighbours, in pixels."""
BEFORE = 26.0
"""Space between levels for the edges, in pixels."""
MARGIN = 18.0
CHANNEL = 44.0
"""Space between columns for the edges from one to the next, in pixels."""
TALL = 1500.0
"""Height in pixels above which a picture continues in a next column, or to the right."""
SHAPE = 1.5
"""Best ratio of width to height of a picture."""


@dataclass(frozen=True, slots=True)
class Place:
    """The middle of a shape, and the column it stands in."""

    x: float
    """Distance of its middle from the left, in units of the drawing."""
    y: float
    """Distance of its middle from the top, in units of the drawing."""
    column: int = 0
    """Column of the drawing, counted from zero."""


@dataclass(frozen=True, slots=True)
class Layout:
    """The layout of a picture."""

    places: Sequence[Place]
    """The place of each shape."""
    width: float
    """Width of the picture."""
    height: float
    """Height of the picture."""
    across: bool = False
    """True if trees grow to the right."""
    step: float = 0.0
    """Distance between the left edges of columns."""


def layout(boxes: Sequence[Box]) -> Layout:
    """The most readable of the three ways: the one that has to be moved about least."""
    ways = (_downwards(boxes), _across(boxes))
    return min(ways, key=lambda way: max(way.width / SHAPE, way.height))


def _levels(boxes: Sequence[Box]) -> list[int]:
    found: list[int] = []
    for box in boxes:
        found.append(found[box.above] + 1 if box.above >= 0 else 0)
    return found


def _downwards(boxes: Sequence[Box]) -> Layout:
    levels = _levels(boxes)
    sizes = [box.height + box.label_height for box in boxes]
    tops = _starts(levels, sizes)
    breadths = [max(box.width, box.label_width) for box in boxes]
    middles = tidy([box.above for box in boxes], breadths, BESIDE)
    width = max((at + breadths[i] / 2 for i, at in enumerate(middles)), default=0.0)
    places = [
        Place(x, tops[level] + box.label_height + box.height / 2)
        for x, level, box in zip(middles, levels, boxes, strict=True)
    ]
    return _folded(places, levels, tops, width)


def _across(boxes: Sequence[Box]) -> Layout:
    levels = _levels(boxes)
    sizes = [box.width + (box.label_width + 3 * CLEAR if box.label else 0.0) for box in boxes]
    starts = _starts(levels, sizes)
    breadths = [max(box.height, box.label_height) for box in boxes]
    middles = tidy([box.above for box in boxes], breadths, BESIDE / 2)
    height = max((at + breadths[i] / 2 for i, at in enumerate(middles)), default=0.0)
    places = [
        Place(starts[level] + size - box.width / 2 + MARGIN, y + MARGIN)
        for y, level, size, box in zip(middles, levels, sizes, boxes, strict=True)
    ]
    return Layout(places, starts[-1] - BEFORE + 2 * MARGIN, height + 2 * MARGIN, across=True)


def _starts(levels: Sequence[int], sizes: Sequence[float]) -> list[float]:
    """Return the start of each level, and of one more."""
    largest = [0.0] * (max(levels, default=-1) + 1)
    for level, size in zip(levels, sizes, strict=True):
        largest[level] = max(largest[level], size)
    return list(accumulate((size + BEFORE for size in largest), initial=0.0))


def _folded(
    places: Sequence[Place], levels: Sequence[int], tops: Sequence[float], width: float
) -> Layout:
    """Levels in columns, if there are so many that one were too high."""
    height = tops[-1] - BEFORE if len(tops) > 1 else 0.0
    step = width + CHANNEL
    columns = max(1, round(math.sqrt(height / (SHAPE * 0.8 * step)))) if height > TALL else 1
    length = height / columns
    column_of: list[int] = []
    begins: list[float] = []
    for level, top in enumerate(tops[:-1]):
        column = len(begins) - 1
        end = tops[level + 1] - BEFORE
        if column < 0 or (level % 2 == 0 and end - begins[column] > length + BEFORE):
            begins.append(top)
            column += 1
        column_of.append(column)
    moved = [
        Place(
            place.x + column_of[level] * step + MARGIN,
            place.y - begins[column_of[level]] + MARGIN,
            column_of[level],
        )
        for place, level in zip(places, levels, strict=True)
    ]
    ends = [tops[level + 1] - BEFORE - begins[at] for level, at in enumerate(column_of)]
    wide = len(begins) * step - CHANNEL if begins else 0.0
    high = max(ends, default=0.0) + 2 * MARGIN
    return Layout(moved, wide + 2 * MARGIN, high, step=step)
