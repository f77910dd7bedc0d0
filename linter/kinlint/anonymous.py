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

    @cached_property
    def _ways(self) -> dict[Term, tuple[Term, str]]:
        """From which node, and on which way, each blank node is first reached."""
        ways: dict[Term, tuple[Term, str]] = {}
        siblings: dict[tuple[Term, Term], int] = {}
        for subject, predicate, value in self._document.statements:
            if is_blank(value) and value not in ways:
                number = siblings[subject, predicate] = siblings.get((subject, predicate), 0) + 1
                ways[value] = (subject, f"{predicate}{number}")
        return ways

    def label(self, node: Term) -> Term:
        """A blank node label for *node* that depends on its nearest named node and the way there.

        Nodes that nothing leads to are told apart by what is stated of them first.
        """
        way: list[str] = []
        at, seen = node, {node}
        while (step := self._ways.get(at)) is not None and step[0] not in seen:
            at, said = step
            way.append(said)
            seen.add(at)
        anchor = self._first.get(at, "") if is_blank(at) else at
        digest = blake2b("\x1f".join([anchor, *way]).encode("utf-8", "surrogatepass"))
        return f"_:b{digest.hexdigest()[:16]}"

    @cached_property
    def _first(self) -> dict[Term, str]:
        first: dict[Term, str] = {}
        for subject, predicate, value in self._document.statements:
            if is_blank(subject) and not is_blank(value):
                first.setdefault(subject, f"{predicate} {value}")
        return first
