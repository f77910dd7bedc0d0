"""Numbers that coordinates which contradict others would have if the others are right."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import chain, count

from kinlint.facts.coordinate_agreement import LISTS, MASS, PLACE, CoordinateAgreements, Pair
from kinlint.facts.fact_statements import double, fact, fact_node
from kinlint.facts.linear_algebra import Matrix, apply, transpose
from kinlint.facts.metamodel_terms import coord, kin, qudt
from kinlint.facts.predicate_index import FIRST, PredicateIndex
from kinlint.facts.quantity import AXES, MASSES
from kinlint.facts.rotation import QUATERNION, Rotations, euler, quaternion
from kinlint.facts.units import ANGLE, LENGTH, Unit
from kinlint.facts.units import MASS as OF_MASS
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, literal_value

DIGITS = 6
"""Fewest significant digits that a computed number is written with, as most files have."""
COSINES = tuple(coord(f"direction-cosine-{axis}") for axis in AXES)
VECTOR = tuple(coord(axis) for axis in AXES)
ANGLES = ("alpha", "beta", "gamma")


@dataclass(frozen=True, slots=True)
class Written:
    """Number of a file: the node and the property that it is the value of."""

    node: Term
    """Node that has the number."""
    entry: Term
    """Property or cell of a list with the number."""
    value: float
    """The number."""


Row = tuple[Written, ...]
"""The numbers that state one thing together, in the order of its components."""


class CoordinateRepairs:
    """Numbers to replace those of two coordinates that are stated less exactly.

    Of three or more coordinates, the one that the others are compared with is right; of two, the
    one with more digits, or else the first. Inertias and first moments are left.
    """

    def __init__(self, agreements: CoordinateAgreements) -> None:
        self.relations = agreements.relations
        self.agreements = agreements
        self.scan: PredicateIndex = self.relations.scan
        self.rotations: Rotations = self.relations.rotations
        self.units = self.relations.quantities.units
        self._numbers = count(1)

    def facts(self) -> Iterator[Triple]:
        """Yield a node for each number that could be there instead.

        It hangs on the agreement or, of one node with several rotations, on the coordinates.
        """
        for pair in self.agreements.pairs():
            for name, value in pair.found.values:
                if value > 0.0 and name == "distance" and not pair.found.norm_only:
                    yield from self._moved(pair)
                elif value > 0.0 and name == "angle":
                    yield from self._turned(pair)
        for node, apart in self.rotations.spread.items():
            if apart > 0.0:
                yield from self._alike(node)

    def _moved(self, pair: Pair) -> Iterator[Triple]:
        """Yield the vector or the scalar of one of *pair* in the frame and unit of the other."""
        first, second = (self._row(node, pair.quantity) for node in (pair.first, pair.second))
        if first is None or second is None:
            return
        kept, other = self._ordered(pair, {pair.first: first[0], pair.second: second[0]})
        (row, unit), (old, own) = (first, second) if kept == pair.first else (second, first)
        values: Sequence[float] = [unit.si(each.value) for each in row]
        if len(row) == len(AXES):
            turn = self.agreements.turn(pair.relation, other, kept)
            values = apply(turn, (values[0], values[1], values[2])) if turn is not None else ()
        new = [(each - own.offset) / own.factor for each in values]
        yield from self._instead(pair.node, "recomputed", old, new, _digits(row))

    def _turned(self, pair: Pair) -> Iterator[Triple]:
        """Yield the orientation of one of *pair* in all representations of the other."""
        stated = {node: self._ways(node) for node in (pair.first, pair.second)}
        kept, other = self._ordered(
            pair, {node: tuple(chain(*ways.values())) for node, ways in stated.items()}
        )
        matrix, digits = self.rotations.proper[kept], _digits(chain(*stated[kept].values()))
        for way, old in stated[other].items():
            new = self._as(way, matrix, other, old)
            yield from self._instead(pair.node, "turned", old, new, digits)

    def _alike(self, node: Term) -> Iterator[Triple]:
        """Yield the rotation that *node* states with most digits in its other representations."""
        ways = self._ways(node)
        kept = max(ways, key=lambda way: _digits(ways[way]))
        matrix = self.rotations.ways[kept][node]
        for way, old in ways.items():
            if way != kept:
                new = self._as(way, matrix, node, old)
                yield from self._instead(node, "turned", old, new, _digits(ways[kept]))

    def _ordered(self, pair: Pair, rows: Mapping[Term, Row]) -> tuple[Term, Term]:
        """Return the node of *pair* that is taken to be right, and the other."""
        first, second = pair.first, pair.second
        if not pair.alone or _digits(rows[first]) >= _digits(rows[second]):
            return first, second
        return second, first

    def _instead(
        self, on: Term, kind: str, old: Row, new: Sequence[float], digits: int
    ) -> Iterator[Triple]:
        """Yield that *old* could be *new*, rounded as far as all of that has *digits*."""
        size = max(map(abs, new), default=0.0)
        if not math.isfinite(size):
            return
        decimals = max(digits, DIGITS) - 1 - (math.floor(math.log10(size)) if size else 0)
        for written, value in zip(old, new, strict=False):
            rounded = round(value, decimals) + 0.0
            if rounded != written.value:
                change = fact_node("recomputed", next(self._numbers))
                yield on, fact(kind), change
                yield change, fact("place"), written.node
                yield change, fact("entry"), written.entry
                yield change, fact("amended"), double(rounded)

    def _row(self, node: Term, quantity: Term) -> tuple[Row, Unit] | None:
        """Return the numbers of *quantity* on *node* and their unit.

        None if they cannot be restated.
        """
        dimensions = {PLACE: LENGTH, qudt("value"): LENGTH, MASS: OF_MASS, **dict(LISTS)}
        entries: Mapping[Term, Sequence[Term]] = {PLACE: VECTOR, MASS: MASSES}
        if quantity not in dimensions:
            return None
        if quantity in dict(LISTS):
            row = self._list(node, quantity)
        else:
            row = self._properties(node, entries.get(quantity, (quantity,)))
        unit = self.units.measuring(node, dimensions[quantity])
        complete = len(row) == (1 if quantity in (MASS, qudt("value")) else len(AXES))
        return (row, unit) if unit is not None and complete else None

    def _ways(self, node: Term) -> Mapping[str, Row]:
        """Return the numbers of each representation of rotation on *node*, each as one row."""
        rows = {
            "cosines": tuple(chain(*(self._list(node, each) for each in COSINES))),
            "quaternion": self._properties(node, QUATERNION),
            "euler": self._properties(node, [kin(name) for name in ANGLES]),
        }
        return {way: rows[way] for way, table in self.rotations.ways.items() if node in table}

    def _as(self, way: str, matrix: Matrix, node: Term, old: Row) -> Sequence[float]:
        """Return the numbers by which *node* states *matrix*, close to its *old* ones."""
        if way == "cosines":
            return [*chain(*transpose(matrix))]
        values = [each.value for each in old]
        if way == "quaternion":
            found = quaternion(matrix)
            near = sum(one * other for one, other in zip(found, values, strict=False))
            return [each if near >= 0.0 else -each for each in found]
        unit = self.units.measuring(node, ANGLE)
        sequence = self.scan.single(kin("axes-sequence")).get(node)
        if unit is None or sequence is None:
            return []
        near_by = [unit.si(each) for each in values]
        intrinsic = node in self.scan.instances(kin("Intrinsic"))
        angles = euler(literal_value(sequence), matrix, near_by, intrinsic=intrinsic)
        return [each / unit.factor for each in angles]

    def _properties(self, node: Term, entries: Sequence[Term]) -> Row:
        found = ((each, self.scan.numbers(each)) for each in entries)
        return tuple(Written(node, each, table[node]) for each, table in found if node in table)

    def _list(self, node: Term, entry: Term) -> Row:
        """Return the items of the list that is the one value of *entry*, each at its cell."""
        head = self.scan.single(entry).get(node)
        cells = (self.scan.cells(head, len(AXES)) if head is not None else None) or ()
        return tuple(
            Written(cell, FIRST, value)
            for cell in cells
            if (value := self.scan.numbers(FIRST).get(cell)) is not None
        )


def _digits(numbers: Iterator[Written] | Row) -> int:
    """Return the largest count of significant digits among *numbers*."""
    return max((_significant(each.value) for each in numbers), default=0)


def _significant(value: float) -> int:
    return len(Decimal(repr(value)).normalize().as_tuple().digits)
