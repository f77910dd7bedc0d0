"""The difference of two lists of statements."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kinlint.terms import Triple

AHEAD = 48
"""Number of statements ahead within which two lists must agree again."""


class Difference(NamedTuple):
    """The statements to remove from a list, and to add, to have another."""

    removed: frozenset[Triple]
    """Statements to remove."""
    added: frozenset[Triple]
    """Statements to add."""

    def __bool__(self) -> bool:
        return bool(self.removed or self.added)


NONE = Difference(frozenset(), frozenset())


def triple_difference(old: Sequence[Triple], new: Sequence[Triple]) -> Difference:
    """Return what turns the statements *old* into *new*, each of which has a triple once.

    As fast as comparing them where they differ in a few places.
    """
    removed, added = list[Triple](), list[Triple]()
    at = to = 0
    while at < len(old) and to < len(new):
        if old[at] == new[to]:
            at, to = at + 1, to + 1
            continue
        step = _meeting(old, at, new, to)
        if step is None:
            break
        removed += old[at : at + step[0]]
        added += new[to : to + step[1]]
        at, to = at + step[0], to + step[1]
    removed += old[at:]
    added += new[to:]
    gone, come = frozenset(removed), frozenset(added)
    return Difference(gone - come, come - gone)


def _meeting(
    old: Sequence[Triple], at: int, new: Sequence[Triple], to: int
) -> tuple[int, int] | None:
    """Return how far to go on in both until they agree; None if that is further than `AHEAD`."""
    ahead = {triple: step for step, triple in enumerate(new[to : to + AHEAD])}
    steps = (
        (step + ahead[triple], step, ahead[triple])
        for step, triple in enumerate(old[at : at + AHEAD])
        if triple in ahead
    )
    found = min(steps, default=None)
    return None if found is None else found[1:]
