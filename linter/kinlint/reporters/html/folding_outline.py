"""Outline of a robot that is too large to draw as a tree: nested lists that fold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby

from kinlint.finding import Finding
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.picture.finding_badges import Marks, badge
from kinlint.reporters.picture.labels import limits, mimics
from kinlint.structure import Joint, Link, Structure

DEEPEST = 20
"""Number of branchings below which lists are not nested: browsers have limits."""
FEW = 6
"""Number of rows in a list, and of branches of a root, up to which they are unfolded."""
LONG = 10
"""Number of rows in sequence without findings above which they are folded into one."""
UNFOLD = '<button type="button" class="unfold" data-open="1" hidden>Unfold all</button>'


def outline(structure: Structure, found: Marks, href: Callable[[Finding], str]) -> str:
    """Return the links and joints as nested lists; what has findings is unfolded."""
    return _Outline(structure, found, href).markup()


class _Outline:
    def __init__(self, structure: Structure, found: Marks, href: Callable[[Finding], str]) -> None:
        self.structure = structure
        self.found = found
        self.href = href
        self.following = mimics(structure)
        self.steps = list(structure.steps())
        self.below: list[list[int]] = [[] for _ in self.steps]
        for index, step in enumerate(self.steps):
            if step.above >= 0:
                self.below[step.above].append(index)
        self.links = [int(isinstance(step.part, Link)) for step in self.steps]
        self.told = [bool(found.get(step.part.iri)) for step in self.steps]
        for index in range(len(self.steps) - 1, -1, -1):
            if (above := self.steps[index].above) >= 0:
                self.links[above] += self.links[index]
                self.told[above] |= self.told[index]

    def markup(self) -> str:
        """Return all trees."""
        roots = [index for index, step in enumerate(self.steps) if step.above < 0]
        items = "".join(self._items(roots, 0))
        return element("div", f"{UNFOLD}<ul>{items}</ul>", class_="outline")

    def _end(self, index: int) -> int:
        """Return the step that ends the row of a step: the one link of a joint, or itself."""
        below = self.below[index]
        return below[0] if isinstance(self.steps[index].part, Joint) and len(below) == 1 else index

    def _run(self, index: int) -> tuple[list[int], Sequence[int]]:
        """Return the rows from a step to the next branching, and what branches off there."""
        rows = [index]
        while len(below := self.below[self._end(rows[-1])]) == 1:
            rows += below
        return rows, below

    def _items(self, starts: Sequence[int], depth: int) -> Iterator[str]:
        """Yield the branches that begin with *starts*, each as an item."""
        for start in starts:
            rows, branches = self._run(start)
            if len(rows) == 1 and not branches:
                yield element("li", self._row(start))
                continue
            inner = "".join(self._folded(rows[1:]))
            if depth < DEEPEST:
                inner += "".join(self._items(branches, depth + 1))
            else:
                inner += "".join(self._folded(list(self._flat(branches))))
            links = self.links[start]
            count = element("span", f"{links:,} links", class_="count")
            opened = (
                depth == 0
                or (depth == 1 and len(starts) <= FEW)
                or links <= FEW
                or any(self.told[each] for each in (*rows[1:], *branches))
            )
            fold = f"<details{' open' * opened}><summary>{self._row(start)} {count}</summary>"
            yield element("li", f"{fold}<ul>{inner}</ul></details>")

    def _flat(self, starts: Sequence[int]) -> Iterator[int]:
        """Yield the rows of all that hangs below, without their nesting."""
        waiting = list(reversed(starts))
        while waiting:
            rows, branches = self._run(waiting.pop())
            yield from rows
            waiting += reversed(branches)

    def _folded(self, rows: Sequence[int]) -> Iterator[str]:
        """Yield *rows* as items, many in sequence without findings as one that unfolds."""
        for told, group in groupby(rows, key=self._is_told):
            each = list(group)
            items = "".join(element("li", self._row(row)) for row in each)
            if told or len(each) <= LONG:
                yield items
                continue
            first, last = (self.steps[row].part.name for row in (each[0], each[-1]))
            head = f"{text(first)} … {text(last)}"
            count = element("span", f"{len(each):,} rows", class_="count")
            yield f"<li><details><summary>{head} {count}</summary><ul>{items}</ul></details></li>"

    def _is_told(self, row: int) -> bool:
        ends = {row, self._end(row)}
        return any(self.found.get(self.steps[each].part.iri) for each in ends)

    def _row(self, index: int) -> str:
        """Return a joint with its link, or either alone."""
        part = self.steps[index].part
        if isinstance(part, Link):
            return self._link(part)
        said = element("span", text(part.name), class_="joint-name")
        about = " ".join(
            (*filter(None, (part.kind, limits(part))), *self.following.get(part.iri, ()))
        )
        said += f" {element('span', text(about), class_='note')}" if about else ""
        said += self._mark(part.iri)
        end = self._end(index)
        if end != index and isinstance(link := self.steps[end].part, Link):
            return f"{said} → {self._link(link)}"
        if part.closes:
            child = self.structure.link(part.child or "")
            return f"{said} ⤴ closes a loop to {text(child.name if child else part.child or '')}"
        return said

    def _link(self, link: Link) -> str:
        absent = ' <span class="note">not described</span>' if link.absent else ""
        return (
            f"{element('span', text(link.name), class_='link-name')}{absent}{self._mark(link.iri)}"
        )

    def _mark(self, part: str) -> str:
        found = self.found.get(part, ())
        mark = badge(found)
        if mark is None:
            return ""
        link = element("a", text(mark.text()), href=self.href(found[0]))
        return " " + element("span", link, class_=f"chip {mark.severity.label}")
