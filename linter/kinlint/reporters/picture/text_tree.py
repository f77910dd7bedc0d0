"""A robot as lines of text: a tree with the findings behind what they are about."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping, Sequence

from kinlint.light_dataclasses import dataclass
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.picture.finding_badges import Marks, badge, described_findings, sign
from kinlint.reporters.picture.labels import heading, mimics
from kinlint.reporters.terminal_style import INK_OF, Style
from kinlint.structure import Joint, Link, Part, Structure

DEEPEST = 24
"""Depth in joints at which the rest of a tree starts again at the margin."""


@dataclass(frozen=True, slots=True)
class Rules:
    """The lines of a tree: a branch, the last one, what passes by a branch, and loops likewise."""

    branch: str
    """A branch with others below it."""
    last: str
    """The last branch."""
    beside: str
    """Line beside the part below a branch."""
    loop: str
    """A joint that closes a loop."""
    last_loop: str
    """The last one of these."""
    arrow: str
    """Points from a joint to its link."""


BOXES = Rules("├─ ", "└─ ", "│  ", "├╌ ", "└╌ ", "→")
ASCII = Rules("|- ", "`- ", "|  ", "|~ ", "`~ ", "->")


def render(
    pairs: Sequence[tuple[Structure, Marks]], style: Style, *, frames: bool = False
) -> Iterator[str]:
    """All robots, one below the other."""
    for index, (structure, found) in enumerate(pairs):
        yield "\n" * bool(index)
        yield from (f"{line}\n" for line in lines(structure, found, style, frames=frames))


def lines(
    structure: Structure, found: Marks, style: Style, *, frames: bool = False
) -> Iterator[str]:
    """The lines of the tree, without line ends, and below them what the findings say."""
    outline = _Outline(structure, found, style, frames=frames)
    yield style.ink(_text(heading(structure), style), "strong") + outline.mark(structure.iri)
    yield from outline.trees()
    said = list(described_findings(found))
    if said:
        yield ""
    for one in said:
        start = one.location.start
        name = printable(one.location.source.name, unicode=style.unicode)
        kind = f"{sign(one.severity, unicode=style.unicode)} {one.rule.code}"
        message = fold_lines(one.message, unicode=style.unicode)
        yield (
            f"{style.ink(kind, INK_OF[one.severity])} {name}:{start.line}:{start.column}: {message}"
        )


class _Outline:
    def __init__(self, structure: Structure, found: Marks, style: Style, *, frames: bool) -> None:
        self.structure = structure
        self.found = found
        self.style = style
        self.frames = frames
        self.rules = BOXES if style.unicode else ASCII
        self.following: Mapping[str, Sequence[str]] = mimics(structure)

    def trees(self) -> Iterator[str]:
        """All trees; what hangs deeper than `DEEPEST` follows as a tree of its own."""
        steps = list(self.structure.steps())
        below: list[list[int]] = [[] for _ in steps]
        for index, step in enumerate(steps):
            if step.above >= 0:
                below[step.above].append(index)
        waiting = deque((index, 0) for index, step in enumerate(steps) if step.above < 0)
        count = 0
        while waiting:
            root, number_ = waiting.popleft()
            lead = f"{self._more(number_)} " if number_ else ""
            cut: list[int] = []
            stack = [(root, "", "", 0)]
            while stack:
                index, prefix, margin, depth = stack.pop()
                part = steps[index].part
                line = f"{prefix}{lead if index == root else ''}{self._name(part)}"
                at = index
                if isinstance(part, Joint) and len(below[index]) == 1:
                    at = below[index][0]
                    line += f" {self.rules.arrow} {self._name(steps[at].part)}"
                hanging = below[at]
                if depth >= DEEPEST and hanging:
                    count += 1
                    cut.append(at)
                    yield f"{line} {self._more(count)}"
                    continue
                yield line
                yield from self._frames(steps[at].part, margin, more=bool(hanging))
                for place, each in reversed(list(enumerate(hanging))):
                    last = place == len(hanging) - 1
                    stack.append(
                        (
                            each,
                            margin + self._branch(steps[each].part, last=last),
                            margin + ("   " if last else self.rules.beside),
                            depth + 1,
                        )
                    )
            waiting.extendleft(
                (at, count - len(cut) + 1 + place) for place, at in reversed(list(enumerate(cut)))
            )

    def _branch(self, part: Part, *, last: bool) -> str:
        if isinstance(part, Joint) and part.closes:
            return self.rules.last_loop if last else self.rules.loop
        return self.rules.last if last else self.rules.branch

    def _more(self, number_: int) -> str:
        return f"{'⋯' if self.style.unicode else '...'}{number_}"

    def _frames(self, part: Part, margin: str, *, more: bool) -> Iterator[str]:
        if self.frames and isinstance(part, Link):
            for frame in part.frames:
                yield f"{margin}{self.rules.beside if more else '   '}. {self._shown(frame.name)}"

    def _name(self, part: Part) -> str:
        if isinstance(part, Link):
            absent = " (not described)" if part.absent else ""
            return f"{self._shown(part.name)}{absent}{self.mark(part.iri)}"
        told_ = [part.kind] * bool(part.kind) + list(self.following.get(part.iri, ()))
        if part.closes:
            child = self.structure.link(part.child or "")
            told_.append(f"closes a loop to {child.name if child else part.child}")
        elif part.child is None:
            told_.append("joins no child")
        if part.parent is None:
            told_.append("joins no parent")
        aside = f" ({self._shown(', '.join(told_))})" if told_ else ""
        return f"{self._shown(part.name)}{aside}{self.mark(part.iri)}"

    def mark(self, iri: str) -> str:
        """The badge of a part, behind a blank, or nothing."""
        mark = badge(self.found.get(iri, ()))
        if mark is None:
            return ""
        text = f"[{mark.text(unicode=self.style.unicode)}]"
        return f"  {self.style.ink(text, INK_OF[mark.severity])}"

    def _shown(self, text: str) -> str:
        return _text(text, self.style)


def _text(text: str, style: Style) -> str:
    if not style.unicode:
        text = text.replace("×", "x")  # noqa: RUF001
    return printable(text, unicode=style.unicode)
