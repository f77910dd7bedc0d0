"""The shapes of a picture: what is written in each, and how much room that takes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal, TypeAlias

from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.display_width import printable, width
from kinlint.reporters.picture.finding_badges import Badge, Marks, badge, marked
from kinlint.reporters.picture.labels import limits, mimics, origin
from kinlint.structure import Frame, Joint, Link, Structure

Kind: TypeAlias = Literal["link", "absent", "joint", "loop", "frame"]

ADVANCE = 0.602
"""The width of a character of a monospaced font, by its size."""
NAME, SMALL, LABEL, BADGE = 12.0, 10.0, 9.5, 10.0
"""The sizes of letters, in pixels."""
LONGEST, TAIL = 40, 14
"""Number of characters of a name that are written, and of its end; the title has all of it."""
PAD = 12.0
LINE = 14.0
LABEL_LINE = 12.0
BADGE_LINE = 19.0
"""Height that a badge takes in its shape, below the text, in pixels."""
CLEAR = 6.0
"""Length of the edge, in pixels, visible between a label and its shape."""
ROUND = 1.16
"""Width of an ellipse relative to its text, so that the corners fit."""


@dataclass(frozen=True, slots=True)
class Box:
    """A shape of a picture."""

    kind: Kind
    """The kind of the part that it shows."""
    iri: str
    """IRI of the part."""
    title: str
    """The name of the part."""
    rows: tuple[str, ...]
    """The name and the lines below it."""
    above: int
    """Index of the box that it hangs below, or -1."""
    label: tuple[str, ...] = ()
    """The text at the edge to that box."""
    badge: Badge | None = None
    """The mark of its findings."""
    findings: tuple[Finding, ...] = ()
    """The findings about the part."""

    @property
    def width(self) -> float:
        """Width of the shape in pixels."""
        size = SMALL if self.kind == "frame" else NAME
        first, *more = self.rows
        text = max(span(first, size), *(span(row, SMALL) for row in more), self.badge_width)
        if self.kind in {"joint", "loop"}:
            return text * ROUND + 2 * PAD
        return text + 2 * PAD * (0.7 if self.kind == "frame" else 1.0)

    @property
    def height(self) -> float:
        """Height of the shape in pixels."""
        if self.kind == "frame":
            return 20.0
        rows = LINE * len(self.rows) + (BADGE_LINE if self.badge is not None else 0.0)
        return rows + (18.0 if self.kind in {"joint", "loop"} else 16.0)

    @property
    def label_width(self) -> float:
        """Width of the label at its edge, in pixels."""
        return max((span(line, LABEL) for line in self.label), default=0.0)

    @property
    def label_height(self) -> float:
        """Height of the label at its edge, in pixels."""
        return LABEL_LINE * len(self.label) + (CLEAR if self.label else 0.0)

    @property
    def badge_width(self) -> float:
        """Width of its badge, in pixels."""
        return 0.0 if self.badge is None else span(self.badge.text(), BADGE) + 14.0


def span(text: str, size: float) -> float:
    """Return the width of *text* in pixels at font size *size*."""
    return width(text) * size * ADVANCE


def cut(text: str) -> str:
    """Return *text* in printable characters, its middle left out if it is very long."""
    text = printable(text)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - TAIL - 1]}…{text[-TAIL:]}"


def boxes(structure: Structure, found: Marks, *, frames: bool = False) -> Sequence[Box]:
    """All shapes of a picture of *structure*, each behind the one that it hangs below.

    Infos are told in titles, and not marked.
    """
    signs = marked(found)
    following = mimics(structure)
    made: list[Box] = []
    place: list[int] = []
    for step in structure.steps():
        part = step.part
        above = place[step.above] if step.above >= 0 else -1
        place.append(len(made))
        told = tuple(found.get(part.iri, ()))
        mark = badge(signs.get(part.iri, ()))
        if isinstance(part, Link):
            made.append(_link(part, above, mark, told))
            if frames:
                home = len(made) - 1
                made += [_frame(each, home) for each in part.frames]
        else:
            rows = tuple(_rows(part, following.get(part.iri, ())))
            kind: Kind = "loop" if part.closes else "joint"
            label = tuple(origin(part))
            made.append(Box(kind, part.iri, part.name, rows, above, label, mark, told))
    return made


def _link(link: Link, above: int, mark: Badge | None, told: tuple[Finding, ...]) -> Box:
    rows = (cut(link.name), *(("not described",) if link.absent else ()))
    kind: Kind = "absent" if link.absent else "link"
    return Box(kind, link.iri, link.name, rows, above, (), mark, told)


def _frame(frame: Frame, above: int) -> Box:
    return Box("frame", frame.iri, frame.name, (cut(frame.name),), above)


def _rows(joint: Joint, following: Sequence[str]) -> Iterator[str]:
    yield cut(joint.name)
    kind = " ".join(filter(None, (cut(joint.kind), limits(joint))))
    if kind:
        yield kind
    yield from map(cut, following)
    if joint.child is None:
        yield "joins no child"
    if joint.parent is None:
        yield "joins no parent"
