"""Tags of a figure: names and findings beside the parts that they are about, none over another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.picture.boxes import span
from kinlint.reporters.picture.finding_badges import Badge, sign
from kinlint.reporters.picture.stick_figure.projection import Spot, overlaps, project
from kinlint.structure import Vector

HEIGHT, LETTERS = 17.0, 10.5
"""Height of a tag and of its letters, in pixels."""
LONGEST = 22
"""Number of characters of a name that a tag shows."""
NAMED, SIGNED = 10, 60
"""Numbers of marked parts above which tags show their sign alone, and no more than a dot."""
MOST = 150
"""Number of tags above which further ones are placed on their parts."""
FAR = 12.0
"""Least distance in pixels between a tag and the part that it is about."""
WAYS = tuple(
    (x, y, ring)
    for ring in (1.0, 2.2, 3.6, 5.2)
    for x, y in ((1, -1), (-1, -1), (1, 1), (-1, 1), (0, -1.6), (0, 1.6), (1.6, 0), (-1.6, 0))
)
"""Directions from a part in which a tag is placed, in the order in which they are tried."""


@dataclass(frozen=True, slots=True)
class Tag:
    """Name of a part, with the sign of its findings if it has any."""

    id: str
    """Identifier on the page."""
    part: str
    """IRI of the part."""
    at: Vector
    """Place of the part in pixels."""
    name: str
    """Name of the part."""
    badge: Badge | None
    """Mark of its findings."""
    findings: Sequence[Finding]
    """Findings about the part, the worst first."""
    of: int = 0
    """Number of marked parts of the robot."""

    @property
    def text(self) -> str:
        """Text that is shown."""
        name = self.name if len(self.name) <= LONGEST else f"{self.name[: LONGEST - 1]}…"
        if self.badge is None:
            return name
        if self.of > SIGNED:
            return ""
        mark = sign(self.badge.severity)
        return mark if self.of > NAMED else f"{mark} {name}"

    @property
    def width(self) -> float:
        """Width in pixels; 0 if it is a dot on the part."""
        return span(self.text, LETTERS) + 14.0 if self.text else 0.0


def placed(
    tags: Sequence[Tag], width: float, height: float, middle: float
) -> Iterator[tuple[Tag, Spot | None]]:
    """Yield the tags, each with its middle in a figure of this size in pixels, and *middle*.

    None for names without room; a tag with findings is shown in any case. The method of
    `figure.js`, which places them anew when the figure is turned.
    """
    taken: list[tuple[float, float, float, float]] = []
    for tag in tags:
        spot: Spot | None = None
        x, y = project(tag.at)
        half = (width - tag.width) / 2, (height - HEIGHT) / 2
        for across, down, ring in WAYS if tag.width and len(taken) < MOST else ():
            beside = FAR * ring + (tag.width / 2 if across else 0.0)
            place = x + across * beside, y + down * FAR * ring
            inside = abs(place[0]) < half[0] and abs(place[1] - middle) < half[1]
            box = _box(place, tag.width)
            if inside and not any(overlaps(box, other) for other in taken):
                spot = place
                taken.append(box)
                break
        yield tag, spot if spot is not None or tag.badge is None else (x, y)


def _box(middle: Spot, width: float) -> tuple[float, float, float, float]:
    x, y = middle
    return x - width / 2 - 1, y - HEIGHT / 2 - 1, x + width / 2 + 1, y + HEIGHT / 2 + 1
