"""The order in which axioms are evaluated, so that few of them are evaluated twice."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence
from typing import TypeVar

from kinlint.engine.axioms import Axiom, instantiate, match, unify
from kinlint.light_dataclasses import replace

Node = TypeVar("Node", bound=Hashable)


def stratified(axioms: Sequence[Axiom]) -> tuple[Axiom, ...]:
    """Return *axioms* in an order in which those that feed others come first, with their strata."""
    feeds = {
        index: [other for other, fed in enumerate(axioms) if _feeds(axiom, fed)]
        for index, axiom in enumerate(axioms)
    }
    stratum: dict[int, int] = {}
    recursive: set[int] = set()
    for component in reversed(components(feeds)):
        level = max((stratum.get(index, 0) for index in component), default=0)
        if len(component) > 1 or component[0] in feeds[component[0]]:
            recursive.update(component)
        for index in component:
            stratum[index] = level
            for fed in feeds[index]:
                if fed not in component:
                    stratum[fed] = max(stratum.get(fed, 0), level + 1)
    ordered = sorted(range(len(axioms)), key=lambda index: (stratum[index], index in recursive))
    return tuple(
        replace(axioms[index], stratum=stratum[index], recursive=index in recursive)
        for index in ordered
    )


def _feeds(axiom: Axiom, fed: Axiom) -> bool:
    """Tell whether *fed* may conclude something new from what *axiom* concludes.

    It cannot if it only leads back to a premise of *axiom*, as the other half of an inverse does.
    """
    if not any(unify(axiom.head, pattern) for pattern in fed.body):
        return False
    if len(fed.body) == 1 and (bindings := match(fed.body[0], axiom.head)) is not None:
        return instantiate(fed.head, bindings) not in axiom.body
    return True


def components(edges: Mapping[Node, Iterable[Node]]) -> list[tuple[Node, ...]]:
    """Return the strongly connected components, each after all those it leads to (Tarjan)."""
    found: list[tuple[Node, ...]] = []
    number: dict[Node, int] = {}
    low: dict[Node, int] = {}
    path: list[Node] = []

    for root in edges:
        if root in number:
            continue
        number[root] = low[root] = len(number)
        path.append(root)
        work = [(root, iter(edges.get(root, ())))]
        while work:
            node, targets = work[-1]
            for target in targets:
                if target not in number:
                    number[target] = low[target] = len(number)
                    path.append(target)
                    work.append((target, iter(edges.get(target, ()))))
                    break
                if target in path:
                    low[node] = min(low[node], number[target])
            else:
                work.pop()
                if work:
                    parent = work[-1][0]
                    low[parent] = min(low[parent], low[node])
                if low[node] == number[node]:
                    start = path.index(node)
                    found.append(tuple(path[start:]))
                    del path[start:]
    return found
