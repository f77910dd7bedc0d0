"""The bases of frames whose vectors are given by numbers (paper, section II-B)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.fact_statements import derived, numbers
from kinlint.facts.linear_algebra import Vector, dot, length, scale
from kinlint.facts.metamodel_terms import AS_SEEN_BY, COORDINATE_OF, OF, WITH_RESPECT_TO, geom, rel
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import AXES, Quantities
from kinlint.facts.rotation import columns, residuals
from kinlint.terms import Term, Triple


class Arrow(NamedTuple):
    """Numbers of a vector, the frame that sees them, and the node that states them."""

    vector: Vector
    """Components of the vector."""
    seen_by: Term | None
    """Frame whose axes the components are along; None if it is not stated."""
    source: Term
    """Node that states the components."""


class Bases:
    """The vectors of frames: numbers on a vector itself, or the position of its end."""

    def __init__(self, scan: PredicateIndex, quantities: Quantities) -> None:
        self.scan = scan
        self.quantities = quantities

    def facts(self) -> Iterator[Triple]:
        """Yield how far the vectors of each frame are from an orthonormal right-handed basis."""
        x, y, z = (self.scan.single(geom(f"vector-{axis}")) for axis in AXES)
        for frame in x:
            if frame not in y or frame not in z:
                continue
            arrows = [self._arrow(table[frame]) for table in (x, y, z)]
            a, b, c = arrows
            if a is None or b is None or c is None:
                continue
            if a.seen_by == b.seen_by == c.seen_by:
                yield from residuals(frame, columns(a.vector, b.vector, c.vector))
                yield from _orthogonality(frame, a.vector, b.vector, c.vector)
                yield from derived(frame, [a.source, b.source, c.source])

    def _arrow(self, vector: Term) -> Arrow | None:
        if (own := self._read(vector)) is not None:
            return own
        if (end := self._ends.get(vector)) is None:
            return None
        if (start := self._starts.get(vector)) is None:
            return None
        if (there := self._positions.get((end, start))) is not None:
            return there
        back = self._positions.get((start, end))
        return None if back is None else back._replace(vector=scale(-1.0, back.vector))

    def _read(self, node: Term) -> Arrow | None:
        vector = self.quantities.vectors.get(node) or self.quantities.plain.get(node)
        return None if vector is None else Arrow(vector, self._seen_by.get(node), node)

    @cached_property
    def _positions(self) -> Mapping[tuple[Term, Term], Arrow]:
        """The coordinates of each position of a point with respect to another."""
        starts, ends = self.scan.single(WITH_RESPECT_TO), self.scan.single(OF)
        positions = self.scan.instances(rel("Position"))
        found: dict[tuple[Term, Term], Arrow] = {}
        pairs = [(node, node) for node in positions]
        for node, relations in self.scan.table(COORDINATE_OF).items():
            pairs += ((node, relation) for relation in relations if relation in positions)
        for node, relation in sorted(pairs):
            if relation in starts and relation in ends:
                arrow = self._read(node) if node in self.quantities.vectors else None
                if arrow is not None and arrow.seen_by is not None:
                    found.setdefault((ends[relation], starts[relation]), arrow)
        return found

    @cached_property
    def _seen_by(self) -> Mapping[Term, Term]:
        return self.scan.single(AS_SEEN_BY)

    @cached_property
    def _starts(self) -> Mapping[Term, Term]:
        return self.scan.single(geom("start"))

    @cached_property
    def _ends(self) -> Mapping[Term, Term]:
        return self.scan.single(geom("end"))


def _orthogonality(frame: Term, x: Vector, y: Vector, z: Vector) -> Iterator[Triple]:
    """Yield the largest absolute cosine between two of the vectors, whatever their lengths."""
    norms = [length(each) for each in (x, y, z)]
    if min(norms) > 0.0:
        a, b, c = (scale(1.0 / norm, each) for norm, each in zip(norms, (x, y, z), strict=True))
        yield from numbers(
            frame, [("orthogonality", max(abs(dot(a, b)), abs(dot(b, c)), abs(dot(c, a))))]
        )
