"""Pairs of coordinates that describe one body or inertia in parts."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from typing import TypeAlias

from kinlint.facts.metamodel_terms import AS_SEEN_BY, COORDINATE_OF, body, kin, rel
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Term

Key: TypeAlias = Callable[[Term], Hashable | None]


class CoordinatePairs:
    """Index of the coordinates of inertias, which may be split over nodes and relations."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.relations = scan.single(COORDINATE_OF)
        self.bodies = scan.single(kin("of-body"))
        self.frames = scan.single(AS_SEEN_BY)
        pointing = (body("about"), body("reference-point"), rel("reference-point"))
        self.points = {at: point for each in pointing for at, point in scan.single(each).items()}

    def with_mass(self, candidates: Iterable[Term]) -> PairedCoordinates:
        """Return an index of *candidates* for the mass of a node's relation, or of its body."""
        return PairedCoordinates(candidates, (self._relation, self._body))

    def with_moment(self, candidates: Iterable[Term]) -> PairedCoordinates:
        """Return an index of *candidates* with the frame and the reference point of a node."""
        return PairedCoordinates(candidates, (self._seen_relation, self._seen_body))

    def point(self, node: Term) -> Term | None:
        """Return the point that *node* is about."""
        return self.points.get(self.relations.get(node, node))

    def _relation(self, node: Term) -> Term | None:
        return self.relations.get(node)

    def _body(self, node: Term) -> Term | None:
        return self.bodies.get(self.relations.get(node, node))

    def _seen_relation(self, node: Term) -> Hashable | None:
        relation, frame = self._relation(node), self.frames.get(node)
        return (relation, frame) if relation and frame else None

    def _seen_body(self, node: Term) -> Hashable | None:
        owner, frame = self._body(node), self.frames.get(node)
        point = self.point(node)
        return (owner, point, frame) if owner and point and frame else None


class PairedCoordinates:
    """Index of candidates by keys; the first key under which a node has any counts."""

    def __init__(self, candidates: Iterable[Term], keys: Iterable[Key]) -> None:
        self.candidates = frozenset(candidates)
        self.found = [(key, self._grouped(key)) for key in keys]

    def _grouped(self, key: Key) -> Mapping[Hashable, list[Term]]:
        groups: dict[Hashable, list[Term]] = {}
        for candidate in sorted(self.candidates):
            if (value := key(candidate)) is not None:
                groups.setdefault(value, []).append(candidate)
        return groups

    def match(self, node: Term) -> Term | None:
        """Return the candidate for *node*: itself if it is one, None where several others are."""
        if node in self.candidates:
            return node
        for key, groups in self.found:
            value = key(node)
            group = groups.get(value, []) if value is not None else []
            if group:
                return group[0] if len(group) == 1 else None
        return None
