"""Names anonymous nodes by how a file reaches them, so that edits elsewhere change no name."""

from __future__ import annotations

from functools import cached_property
from hashlib import blake2b

from kinlint.document import Document
from kinlint.terms import Term, is_blank


class AnonymousNodes:
    """The blank nodes of one document."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._labels: dict[Term, str] = {}

    @cached_property
    def _ways(self) -> dict[Term, tuple[Term, str]]:
        """Node from which each blank node is first reached, and the path to it."""
        ways: dict[Term, tuple[Term, str]] = {}
        siblings: dict[tuple[Term, Term], int] = {}
        for subject, predicate, value in self._document.statements:
            if value[0] == "_" and value not in ways:
                number = siblings[subject, predicate] = siblings.get((subject, predicate), 0) + 1
                ways[value] = (subject, f"{predicate}{number}")
        return ways

    def label(self, node: Term) -> Term:
        """Return a blank node label for *node* by its nearest named node and the path there.

        Nodes that nothing leads to are told apart by what is stated of them first. All labels
        together take as long as the ways have steps: each goes on from that of the node before.
        """
        way: list[tuple[Term, str]] = []
        at, seen = node, {node}
        while at not in self._labels and (step := self._ways.get(at)) and step[0] not in seen:
            way.append((at, step[1]))
            at = step[0]
            seen.add(at)
        label = self._labels.get(at)
        if label is None:
            label = self._first.get(at, "") if is_blank(at) else at
            if not way:
                label = _digest(label)
        for each, said in reversed(way):
            label = self._labels[each] = _digest(f"{label}\x1f{said}")
        return f"_:b{label}"

    @cached_property
    def _first(self) -> dict[Term, str]:
        first: dict[Term, str] = {}
        for subject, predicate, value in self._document.statements:
            if is_blank(subject) and not is_blank(value):
                first.setdefault(subject, f"{predicate} {value}")
        return first


def _digest(way: str) -> str:
    return blake2b(way.encode("utf-8", "surrogatepass")).hexdigest()[:16]
