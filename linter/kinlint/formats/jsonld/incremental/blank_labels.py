"""Gives the blank nodes of all parts of a file their labels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.jsonld.incremental.part import Part
from kinlint.terms import Term

Named = Mapping[Part, tuple[tuple[Term, ...], Part]]
"""Parts with the labels of their blank nodes, and as they are with these labels."""


class Labelling:
    """Labels blank nodes in the order in which they are asked for when a file is read at once.

    That is by the statements of one part after the other, then, after `finish`, by what is lost.
    """

    def __init__(self, name: str, parts: Sequence[Part]) -> None:
        self.blanks = BlankNodes(name)
        self._parts = [part for part in parts if part.asked]
        self._names: list[dict[Term, Term]] = [{} for _ in self._parts]
        self._ask(0)

    def finish(self, known: Named) -> Named:
        """Return the parts with all of their labels; those that are *known* are not made again."""
        for step in (1, 2, 3):
            self._ask(step)
        named: dict[Part, tuple[tuple[Term, ...], Part]] = {}
        for part, names in zip(self._parts, self._names, strict=True):
            labels = tuple(names.values())
            before = known.get(part)
            unchanged = before is not None and before[0] == labels
            named[part] = before if before and unchanged else (labels, part.renamed(names))
        return named

    def _ask(self, step: int) -> None:
        blanks = self.blanks
        for part, names in zip(self._parts, self._names, strict=True):
            ends = (0, *part.steps, len(part.asked))
            for node, label in part.asked[ends[step] : ends[step + 1]]:
                names[node] = blanks.fresh() if label is None else blanks.named(label)
