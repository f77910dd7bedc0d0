"""The parts of a file in their order, and where they are."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from kinlint.formats.jsonld.incremental.part import NOTHING, Notes, Part, shifted


@dataclass(frozen=True, slots=True, eq=False)
class Arrangement:
    """Parts, each of which has moved by one of `shifts` since it was read."""

    parts: Sequence[Part]
    shifts: Sequence[int]

    def end_of(self, number: int) -> int:
        """Return the end of a part."""
        return self.parts[number].whole.end + self.shifts[number]

    def first_to(self, end: int) -> int:
        """Return the first part that ends at *end* or later; as many as there are if none does."""
        return bisect_left(range(len(self.parts)), end, key=self.end_of)

    def replaced(self, first: int, rest: int, between: Arrangement, by: int) -> Arrangement:
        """Return the *first* parts, others *between*, and the *rest*, which moves *by*."""
        moved = (each + by for each in self.shifts[rest:])
        return Arrangement(
            [*self.parts[:first], *between.parts, *self.parts[rest:]],
            [*self.shifts[:first], *between.shifts, *moved],
        )

    def notes(self) -> Iterator[Notes]:
        """Yield the notes of the parts, moved to their present places."""
        for part, by in zip(self.parts, self.shifts, strict=True):
            if part.notes is not NOTHING:
                yield part.notes.moved(partial(shifted, by=by)) if by else part.notes
