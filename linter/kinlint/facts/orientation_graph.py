"""Graph of frames whose edges are known relative orientations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.common_cause import common_causes, turned
from kinlint.facts.linear_algebra import IDENTITY, Matrix, angle, product, transpose
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativeOrientation
from kinlint.terms import Term

MOST_MEMBERS = 12
"""Most relations of a loop that are named: nobody reads more, and long loops would cost much."""


class Loop(NamedTuple):
    """A cycle of orientations."""

    edges: Sequence[int]
    """Its edges by index, the closing one first."""
    length: int
    """The number of its edges."""
    residual: float
    """The angle in rad by which it does not close."""
    cause: int | None = None
    """The edge to blame, if other cycles through it miss alike."""


class OrientationGraph:
    """Axes of all frames, each seen by one frame of its component."""

    def __init__(self, turns: Sequence[RelativeOrientation]) -> None:
        self.turns = turns
        self.forest = SpanningForest([(turn.base, turn.of) for turn in turns])

    @cached_property
    def seen(self) -> Mapping[Term, Matrix]:
        """Matrix of each frame, seen by the frame that stands for its group."""
        found: dict[Term, Matrix] = {}
        for node in self.forest.order:
            if node not in self.forest.parent:
                found[node] = IDENTITY
                continue
            above, index = self.forest.parent[node]
            turn = self.turns[index]
            step = turn.matrix if turn.of == node else transpose(turn.matrix)
            found[node] = product(found[above], step)
        return found

    def group(self, frame: Term) -> Term:
        """Return the frame that stands for all whose orientation to *frame* is known."""
        return self.forest.root.get(frame, frame)

    def matrix(self, frame: Term) -> Matrix:
        """Return the matrix of *frame*, seen by the frame of its group."""
        return self.seen.get(frame, IDENTITY)

    def between(self, base: Term, frame: Term) -> Matrix | None:
        """Return the rotation of components seen by *frame* into those seen by *base*, if known."""
        if base == frame:
            return IDENTITY
        if self.group(base) != self.group(frame):
            return None
        return product(transpose(self.matrix(base)), self.matrix(frame))

    def loops(self) -> Iterator[Loop]:
        """Yield each independent loop of orientations, with the angle in rad that it misses."""
        missing = {index: self._missing(self.turns[index]) for index in self.forest.closing}
        causes = common_causes(self.forest, [turned(*each) for each in missing.items()])
        for index, by in missing.items():
            turn = self.turns[index]
            way = self.forest.way(turn.base, turn.of, MOST_MEMBERS - 1)
            length = self.forest.between(turn.base, turn.of) + 1
            yield Loop((index, *way), length, angle(by), causes.get(index))

    def _missing(self, turn: RelativeOrientation) -> Matrix:
        """Return the rotation from the axes of `turn.of` to those by *turn*, seen by their root."""
        return product(
            product(self.matrix(turn.base), turn.matrix), transpose(self.matrix(turn.of))
        )
