"""Tidy tree layout: parents are centred and nothing overlaps, in linear time.

Source: Buchheim, Jünger and Leipert, Improving Walker's Algorithm to Run in Linear Time, 2002; here
for nodes of different sizes, and without recursion.
"""

from __future__ import annotations

from collections.abc import Sequence

NONE = -1


def tidy(above: Sequence[int], breadths: Sequence[float], gap: float) -> list[float]:
    """The middle of each node, across the direction of growth; the least edge is at 0.

    *above* names for each node another one that it hangs below, or -1; *breadths* are their
    sizes, and *gap* is what has to be free between neighbours. Several trees stand side by side.
    """
    return _Walk(above, breadths, gap).middles()


class _Walk:
    """The trees below one more node, the last, which nobody sees.

    `place` is that of a node as its parent counts, `move` what its descendants move along with
    it. `shift` and `change` are what is owed to the siblings before it. A `thread` leads from the
    last node of an outline to the next one of that outline, in another subtree.
    """

    def __init__(self, above: Sequence[int], breadths: Sequence[float], gap: float) -> None:
        count = len(above) + 1
        self.root = count - 1
        self.gap = gap
        self.breadths = [*breadths, 0.0]
        self.above = [self.root if each < 0 else each for each in above] + [NONE]
        self.below: list[list[int]] = [[] for _ in range(count)]
        self.number = [0] * count
        for node, parent in enumerate(self.above[:-1]):
            self.number[node] = len(self.below[parent])
            self.below[parent].append(node)
        self.place, self.move = [0.0] * count, [0.0] * count
        self.shift, self.change = [0.0] * count, [0.0] * count
        self.thread = [NONE] * count
        self.ancestor = list(range(count))
        self.default = [children[0] if children else NONE for children in self.below]

    def middles(self) -> list[float]:
        """The middle of each node that is seen."""
        down: list[int] = []
        waiting = [self.root]
        while waiting:
            node = waiting.pop()
            down.append(node)
            waiting += self.below[node]
        for node in reversed(down):
            self._settle(node)
        for node in down[1:]:
            parent = self.above[node]
            self.place[node] += self.move[parent]
            self.move[node] += self.move[parent]
        found = self.place[: self.root]
        least = min((at - self.breadths[node] / 2 for node, at in enumerate(found)), default=0.0)
        return [at - least for at in found]

    def _settle(self, node: int) -> None:
        """Place *node* beside the sibling before it, all below both being settled."""
        children = self.below[node]
        number = self.number[node]
        parent = self.above[node]
        before = self.below[parent][number - 1] if parent != NONE and number else NONE
        if before != NONE:
            self.place[node] = self.place[before] + self._distance(before, node)
        if children:
            self._spread(children)
            middle = (self.place[children[0]] + self.place[children[-1]]) / 2
            if before == NONE:
                self.place[node] = middle
            else:
                self.move[node] = self.place[node] - middle
        if before != NONE:
            self._separate(node, before)

    def _distance(self, one: int, other: int) -> float:
        return (self.breadths[one] + self.breadths[other]) / 2 + self.gap

    def _spread(self, children: Sequence[int]) -> None:
        """Pay what is owed to *children* that stand between others which moved apart."""
        shift = change = 0.0
        for child in reversed(children):
            self.place[child] += shift
            self.move[child] += shift
            change += self.change[child]
            shift += self.shift[child] + change

    def _separate(self, node: int, before: int) -> None:
        """Move *node* away from all that hangs below its earlier siblings, level by level."""
        parent = self.above[node]
        inner, outer = node, node
        near, far = before, self.below[parent][0]
        inner_by = outer_by = self.move[node]
        near_by, far_by = self.move[near], self.move[far]
        while True:
            next_near, next_inner = self._last(near), self._first(inner)
            if NONE in {next_near, next_inner}:
                break
            near, inner = next_near, next_inner
            far, outer = self._first(far), self._last(outer)
            self.ancestor[outer] = node
            overlap = self.place[near] + near_by - self.place[inner] - inner_by
            overlap += self._distance(near, inner)
            if overlap > 0:
                self._push(self._mover(near, node), node, overlap)
                inner_by += overlap
                outer_by += overlap
            near_by += self.move[near]
            inner_by += self.move[inner]
            far_by += self.move[far]
            outer_by += self.move[outer]
        if next_near != NONE and self._last(outer) == NONE:
            self.thread[outer] = next_near
            self.move[outer] += near_by - outer_by
        if next_inner != NONE and self._first(far) == NONE:
            self.thread[far] = next_inner
            self.move[far] += inner_by - far_by
            self.default[parent] = node

    def _first(self, node: int) -> int:
        return self.below[node][0] if self.below[node] else self.thread[node]

    def _last(self, node: int) -> int:
        return self.below[node][-1] if self.below[node] else self.thread[node]

    def _mover(self, near: int, node: int) -> int:
        """The sibling of *node* below which *near* hangs."""
        parent = self.above[node]
        found = self.ancestor[near]
        return found if self.above[found] == parent else self.default[parent]

    def _push(self, still: int, moved: int, by: float) -> None:
        """Move *moved* by this, and its siblings behind *still* by their share, later."""
        share = by / (self.number[moved] - self.number[still])
        self.change[moved] -= share
        self.shift[moved] += by
        self.change[still] += share
        self.place[moved] += by
        self.move[moved] += by
