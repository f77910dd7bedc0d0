"""Strongly connected components of a directed graph."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.terms import Term


def strongly_connected_components(arcs: Mapping[Term, Sequence[Term]]) -> Iterator[list[Term]]:
    """Yield the largest groups of nodes that all reach each other; linear in nodes and arcs.

    By Tarjan's algorithm (Depth-first search and linear graph algorithms, 1972) without recursion;
    groups come after those that they lead to.
    """
    index: dict[Term, int] = {}
    low: dict[Term, int] = {}
    stack: list[Term] = []
    waiting: set[Term] = set()
    for start in arcs:
        if start in index:
            continue
        path = [(start, iter(arcs[start]))]
        while path:
            node, rest = path[-1]
            if node not in index:
                index[node] = low[node] = len(index)
                stack.append(node)
                waiting.add(node)
            following = next(rest, None)
            if following is not None:
                if following not in index:
                    path.append((following, iter(arcs.get(following, ()))))
                elif following in waiting:
                    low[node] = min(low[node], index[following])
                continue
            path.pop()
            if path:
                above = path[-1][0]
                low[above] = min(low[above], low[node])
            if low[node] == index[node]:
                yield _popped(stack, node, waiting)


def _popped(stack: list[Term], last: Term, waiting: set[Term]) -> list[Term]:
    """Return the nodes on the stack down to *last*, taken off."""
    group: list[Term] = []
    while not group or group[-1] != last:
        group.append(stack.pop())
    waiting.difference_update(group)
    return group
