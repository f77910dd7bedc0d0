"""Finds the target nodes that changes may concern: those from which a pattern leads to them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import islice
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.constraint import PLAIN
from kinlint.incremental.change import Changes
from kinlint.incremental.dependency_paths import PatternPath
from kinlint.incremental.solution_paths import Edge, Path
from kinlint.sparql.tokens import is_variable
from kinlint.terms import RDF_TYPE, Triple, iri_value, is_iri

Node: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple
Fact: TypeAlias = tuple[Node, ox.NamedNode, Node]

THIS = "?this"
"""The variable of targets where they are chosen."""
FEW, SHARE = 60, 20
"""More nodes, and more than one in so many, are as well found by a query about all."""


class TooMany(Exception):
    """More target nodes are concerned than are worth to be looked for."""


class AffectedNodes:
    """Follows ways through what a store holds, and what it held before *changes*."""

    def __init__(self, changes: Changes) -> None:
        self._changes = changes
        self._store = changes.store.oxigraph
        described = sum(len(each.map.nodes) for each in changes.store.documents.values())
        self._most = max(FEW, described // SHARE)
        self._changed = dict.fromkeys(map(_fact, (*changes.removed, *changes.added)))
        self._by_property: dict[str, list[Fact]] = {}
        for fact in self._changed:
            self._by_property.setdefault(str(fact[1]), []).append(fact)
        self._before: dict[Node, list[Fact]] = {}
        for fact in map(_fact, changes.removed):
            self._before.setdefault(fact[0], []).append(fact)
            self._before.setdefault(fact[2], []).append(fact)
        self._begun: dict[tuple[Path, str, str, bool], frozenset[Node]] = {}
        self._chosen: dict[tuple[Triple, Node], bool] = {}
        self._reached: dict[tuple[Node, Path, bool], tuple[Node, ...]] = {}

    def is_target(self, node: Node, targets: Sequence[Triple]) -> bool:
        """Tell whether one of the patterns *targets* chooses *node*."""
        return any(self._known_to_choose(way, node) for way in targets)

    def _known_to_choose(self, way: Triple, node: Node) -> bool:
        key = way, node
        if key not in self._chosen:
            self._chosen[key] = self._chooses(way, node)
        return self._chosen[key]

    def _chooses(self, way: Triple, node: Node) -> bool:
        subject, predicate, value = way
        if not PLAIN.fullmatch(predicate) or THIS not in (subject, value):
            return True
        property_ = ox.NamedNode(iri_value(predicate))
        if subject != THIS:
            return any(True for _ in self._store.quads_for_pattern(None, property_, node, None))
        if isinstance(node, ox.Literal):
            return False
        found = self._store.quads_for_pattern(node, property_, None, None)
        if predicate != RDF_TYPE or not is_iri(value):
            return any(True for _ in found)
        return any(value in self._changes.superclasses(quad.object) for quad in found)

    def nodes(self, pattern_paths: Sequence[PatternPath]) -> set[Node]:
        """Return the target nodes that any of *pattern_paths* leads to from what changed.

        Raises `TooMany`.
        """
        found = set[Node]()
        for sight in pattern_paths:
            starts: Collection[Node] = self._starts(sight)
            if not starts:
                continue
            if sight.steps is None:
                raise TooMany
            for path, back in sight.steps:
                starts = self._step(starts, path, back)
            found.update(starts)
            if len(found) > self._most:
                raise TooMany
        return found

    def _starts(self, sight: PatternPath) -> frozenset[Node]:
        """The nodes at that end of the pattern of *sight* from which the way leads on."""
        edge = sight.edge
        key = edge.path, _fixed(edge.subject), _fixed(edge.object), sight.from_object
        if key not in self._begun:
            self._begun[key] = frozenset(self._begin(edge, from_object=sight.from_object))
        return self._begun[key]

    def _begin(self, edge: Edge, *, from_object: bool) -> set[Node]:
        matched = [fact for fact in self._changed_facts(edge.path) if _matches(edge, fact)]
        if not edge.path.plain:
            ends = {end for fact in matched for end in (fact[0], fact[2])}
            return self._step(ends, edge.path, back=False) | ends
        return {fact[2] if from_object else fact[0] for fact in matched}

    def _changed_facts(self, path: Path) -> Iterable[Fact]:
        if path.terms is None:
            return self._changed
        return (fact for term in path.terms for fact in self._by_property.get(term, ()))

    def _step(self, nodes: Collection[Node], path: Path, back: bool) -> set[Node]:  # noqa: FBT001
        """Return the nodes that *path* leads to from *nodes*, *back* or not."""
        if path.plain:
            return self._bounded(end for node in nodes for end in self._near(node, path, back))
        found, waiting = set(nodes), list(nodes)
        while waiting:
            node = waiting.pop()
            for end in self._ends(node, path, (False, True)):
                if end not in found:
                    found.add(end)
                    waiting.append(end)
            if len(found) > self._most:
                raise TooMany
        return found

    def _bounded(self, ends: Iterable[Node]) -> set[Node]:
        found = set[Node]()
        for end in ends:
            found.add(end)
            if len(found) > self._most:
                raise TooMany
        return found

    def _near(self, node: Node, path: Path, back: bool) -> tuple[Node, ...]:  # noqa: FBT001
        """Return what *path* leads to from *node* in one step, *back* or not."""
        key = node, path, back
        if key not in self._reached:
            self._reached[key] = tuple(islice(self._ends(node, path, (back,)), self._most + 1))
        return self._reached[key]

    def _ends(self, node: Node, path: Path, ways: Sequence[bool]) -> Iterator[Node]:
        terms = path.terms
        properties: list[ox.NamedNode | None] = (
            [None] if terms is None else [ox.NamedNode(iri_value(term)) for term in terms]
        )
        for back in ways:
            if not back and isinstance(node, ox.Literal):
                continue
            for property_ in properties:
                quads = (
                    self._store.quads_for_pattern(None, property_, node, None)
                    if back
                    else self._store.quads_for_pattern(node, property_, None, None)  # type: ignore[arg-type]
                )
                yield from (quad.subject if back else quad.object for quad in quads)
            for subject, predicate, value in self._before.get(node, ()):
                if terms is None or str(predicate) in terms:
                    if back and value == node:
                        yield subject
                    elif not back and subject == node:
                        yield value


def _fact(quad: ox.Quad) -> Fact:
    return quad.subject, quad.predicate, quad.object


def _fixed(end: str) -> str:
    """Return the term at an end of a pattern, `?` for any variable."""
    return "?" if is_variable(end) else end


def _matches(edge: Edge, fact: Fact) -> bool:
    """Tell whether *fact* may match *edge*, by the terms that are written in it."""
    if not edge.path.plain:
        return True
    return all(
        is_variable(end) or not is_iri(end) or str(term) == end
        for end, term in ((edge.subject, fact[0]), (edge.object, fact[2]))
    )
