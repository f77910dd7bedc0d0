"""Labels that front ends make up for blank nodes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from copy import copy
from hashlib import blake2b

from kinlint.terms import Term, blank


class BlankNodes:
    """Labels for the blank nodes of one document that no other document has.

    They depend on the document's name and the order of asking alone.
    """

    def __init__(self, name: str) -> None:
        number = int.from_bytes(blake2b(name.encode(), digest_size=8).digest())
        self._prefix = f"d{number}n"
        self._count = 0
        self._written: dict[str, Term] = {}

    def fresh(self) -> Term:
        """Return a blank node without a name in the text."""
        self._count += 1
        return blank(f"{self._prefix}{self._count}")

    def named(self, label: str) -> Term:
        """Return the blank node that the text calls *label*."""
        known = self._written.get(label)
        if known is None:
            known = self._written[label] = self.fresh()
        return known

    @property
    def labels(self) -> Mapping[Term, str]:
        """Labels that the text gives to its blank nodes."""
        return {node: label for label, node in self._written.items()}

    @property
    def count(self) -> int:
        """The number of nodes that were asked for."""
        return self._count

    def rewind(self, count: int) -> None:
        """Forget the nodes after the first *count*, none of which has a name in the text."""
        self._count = count

    def since(self, count: int) -> BlankNodes:
        """Return labels that are those given after the first *count*, once more."""
        again = self.continued()
        again.rewind(count)
        return again

    def continued(self) -> BlankNodes:
        """Return labels for what is new in the document, apart from all that were asked for."""
        more = copy(self)
        more._written = dict(self._written)  # noqa: SLF001  of its own class
        return more


class RecalledBlankNodes(BlankNodes):
    """Labels that were given before, in their order, and when these are used up, *new* ones."""

    def __init__(self, before: Iterable[Term], new: BlankNodes) -> None:
        self._before = iter(before)
        self._new = new

    def fresh(self) -> Term:
        """Return a blank node without a name in the text."""
        return next(self._before, None) or self._new.fresh()

    def named(self, label: str) -> Term:
        """Return the blank node that the text calls *label*."""
        return self._new.named(label)
