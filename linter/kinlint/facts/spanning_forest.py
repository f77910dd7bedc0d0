"""Spanning forests of graphs whose edges are relations, and the edges that close a loop."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from kinlint.terms import Term

Edge = tuple[Term, Term]


class DisjointSets:
    """Sets of connected nodes, by union-find with path halving (Tarjan and van Leeuwen 1984)."""

    def __init__(self) -> None:
        self._parent: dict[Term, Term] = {}

    def representative(self, node: Term) -> Term:
        """Return the node that stands for the set of *node*."""
        parent = self._parent
        while (above := parent.get(node, node)) != node:
            parent[node] = parent.get(above, above)
            node = above
        return node

    def join(self, one: Term, other: Term) -> bool:
        """Connect two nodes; tell whether they were apart before."""
        a, b = self.representative(one), self.representative(other)
        if a != b:
            self._parent[b] = a
        return a != b


class SpanningForest:
    """Trees that *edges* span, earlier ones first; edges are named by their index.

    `closing` are those that close a loop with earlier ones. `order` names the nodes so that each
    comes after its parent.
    """

    def __init__(self, edges: Sequence[Edge]) -> None:
        self.edges = edges
        self.closing: list[int] = []
        self.parent: dict[Term, tuple[Term, int]] = {}
        self.root: dict[Term, Term] = {}
        self._depth: dict[Term, int] = {}
        self._jump: dict[Term, Term] = {}
        roots = DisjointSets()
        near: dict[Term, list[tuple[Term, int]]] = {}
        for index, (one, other) in enumerate(edges):
            near.setdefault(one, [])
            near.setdefault(other, [])
            if roots.join(one, other):
                near[one].append((other, index))
                near[other].append((one, index))
            else:
                self.closing.append(index)
        for start in near:
            if start not in self.root:
                self._grow(start, near)
        self.order = tuple(self.root)

    def _grow(self, start: Term, near: dict[Term, list[tuple[Term, int]]]) -> None:
        self.root[start] = self._jump[start] = start
        self._depth[start] = 0
        waiting = deque([start])
        while waiting:
            node = waiting.popleft()
            for child, index in near[node]:
                if child not in self.root:
                    self.root[child] = start
                    self.parent[child] = node, index
                    self._depth[child] = self._depth[node] + 1
                    self._jump[child] = self._leap(node)
                    waiting.append(child)

    def _leap(self, node: Term) -> Term:
        """Return the jump pointer of a child of *node*: ancestors are O(log n) jumps away.

        Source: Myers, An applicative random-access stack, 1983.
        """
        near = self._jump[node]
        far = self._jump[near]
        depth = self._depth
        return far if depth[node] - depth[near] == depth[near] - depth[far] else node

    def meet(self, one: Term, other: Term) -> Term:
        """Return the lowest common ancestor of two nodes of one tree, in logarithmic time."""
        depth, jump, parent = self._depth, self._jump, self.parent
        low, high = (one, other) if depth[one] > depth[other] else (other, one)
        while depth[low] > depth[high]:
            low = jump[low] if depth[jump[low]] >= depth[high] else parent[low][0]
        while low != high:
            if jump[low] != jump[high]:
                low, high = jump[low], jump[high]
            else:
                low, high = parent[low][0], parent[high][0]
        return low

    def between(self, one: Term, other: Term) -> int:
        """Return the number of edges on the path from *one* to *other*."""
        above = self.meet(one, other)
        return self._depth[one] + self._depth[other] - 2 * self._depth[above]

    def way(self, one: Term, other: Term, most: int) -> Iterable[int]:
        """Return at most *most* edges of the path from *one* to *other*, its ends first."""
        above = self.meet(one, other)
        return islice(_alternating(self._climb(one, above), self._climb(other, above)), most)

    def _climb(self, node: Term, above: Term) -> Iterator[int]:
        while node != above:
            node, index = self.parent[node]
            yield index


def _alternating(one: Iterator[int], other: Iterator[int]) -> Iterator[int]:
    waiting = deque([one, other])
    while waiting:
        each = waiting.popleft()
        if (found := next(each, None)) is not None:
            yield found
            waiting.append(each)
