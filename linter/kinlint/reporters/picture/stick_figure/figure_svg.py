"""A stick figure as SVG: seen from a fixed direction, with what a script needs to turn it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from pathlib import Path

from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.picture.escape import attributes, element, empty, text
from kinlint.reporters.picture.finding_badges import Marks, badge, marked, sign
from kinlint.reporters.picture.labels import heading
from kinlint.reporters.picture.stick_figure.figure_lines import DENSE, LEAST, FigureLines
from kinlint.reporters.picture.stick_figure.projection import coordinate, coordinates, project
from kinlint.reporters.picture.stick_figure.skeleton import Skeleton
from kinlint.reporters.picture.stick_figure.tags import HEIGHT, Tag, placed
from kinlint.structure import Structure, Vector

WIDTH, TALL = 560.0, 440.0
"""Size of a figure in pixels."""
ALL_NAMED = 12
"""Number of joints up to which all have their name beside them."""


def rules() -> str:
    """The rules of CSS that figures need, for light and dark."""
    return Path(__file__).with_name("figure.css").read_text(encoding="utf-8")


@dataclass(frozen=True, slots=True)
class Drawn:
    """Figure as markup."""

    svg: str
    """The figure itself."""
    caption: str
    """Caption, as markup."""
    anchors: dict[int, str]
    """Identifier of the tag that shows each finding, by the `id` of the finding."""

    def at(self, x: float, y: float) -> str:
        """Return the figure as a part of another picture, at a place in pixels."""
        return self.svg.replace("<svg ", f"<svg {attributes(x=x, y=y)} ", 1)


def figure(
    structure: Structure,
    found: Marks,
    *,
    name: str,
    href: Callable[[Finding], str] | None = None,
) -> Drawn | None:
    """Return the figure of a robot for a page that has `rules`; None if no placement is stated.

    *name* begins the ids in it, *href* leads to findings.
    """
    skeleton = Skeleton(structure)
    return Figure(skeleton, marked(found), name, href).drawn() if skeleton.is_stated else None


class Figure:
    """Figure of one robot."""

    def __init__(
        self,
        skeleton: Skeleton,
        found: Marks,
        name: str,
        href: Callable[[Finding], str] | None,
    ) -> None:
        self.skeleton = skeleton
        self.structure = skeleton.structure
        self.found = found
        self.lines = FigureLines(skeleton, found)
        self.name = name
        self.href = href

    def drawn(self) -> Drawn:
        """Return the figure, its caption and where findings are."""
        title = f"Stick figure of {heading(self.structure)}"
        middle = self.lines.middle
        tags = list(placed(self._tags, WIDTH, TALL, middle))
        content = (
            element("title", text(title), id=f"{self.name}-title"),
            element("g", "".join(self.lines.floor()), class_="floor", aria_hidden="true"),
            element("g", "".join(self.lines.parts()), class_="parts", aria_hidden="true"),
            element("g", "".join(self.lines.root()), class_="frame", aria_hidden="true"),
            element("g", "".join(self._tag(*each) for each in tags), class_="flags"),
        )
        svg = element(
            "svg",
            "\n".join(content),
            xmlns="http://www.w3.org/2000/svg",
            class_="stick dense" if len(self.lines.joints) > DENSE else "stick",
            role="group",
            aria_labelledby=f"{self.name}-title",
            viewBox=" ".join(map(coordinate, (-WIDTH / 2, middle - TALL / 2, WIDTH, TALL))),
            width=WIDTH,
            height=TALL,
        )
        anchors = {id(one): tag.id for tag, _ in reversed(tags) for one in tag.findings}
        return Drawn(svg, self._caption(), anchors)

    def _caption(self) -> str:
        said = [f"All joints at zero. Squares of the floor: {self.lines.square:g} m."]
        guessed = sum(not each.placed for each in self.structure.joints)
        if guessed:
            said.append(
                f"{guessed:,} of {len(self.structure.joints):,} joints have no stated place and "
                "are drawn where their links are."
            )
        return text(" ".join(said))

    @cached_property
    def _tags(self) -> Sequence[Tag]:
        """Tags of the parts with findings, the worst first, then of the others that are named."""
        middles: dict[str, Vector] = {}
        for each in self.lines.sticks:
            middles.setdefault(each.link.iri, each.middle)
        spots = {**middles, **{joint.iri: at for joint, at in self.lines.joints}}
        count = sum(part in spots for part in self.found)
        tags = [
            Tag(
                f"{self.name}-{number}",
                part.iri,
                spots[part.iri],
                part.name,
                badge(self.found.get(part.iri, ())),
                self.found.get(part.iri, ()),
                count,
            )
            for number, part in enumerate(self.structure.parts)
            if part.iri in spots
        ]
        told = sorted((tag for tag in tags if tag.badge), key=lambda tag: -tag.findings[0].severity)
        few = len(self.lines.joints) <= ALL_NAMED
        joined = {end for each in self.structure.joints for end in (each.parent, each.child)}
        shown = {part.iri for part in self.structure.parts if part.iri not in joined}
        named = [tag for tag in tags if tag.badge is None and few and tag.part in shown]
        return [*told, *named]

    def _tag(self, tag: Tag, spot: tuple[float, float] | None) -> str:
        x, y = spot or project(tag.at)
        severity = f" {tag.badge.severity.label}" if tag.badge is not None else ""
        told = (f"{sign(one.severity)} {one.rule.code}: {one.message}" for one in tag.findings)
        shown = element("title", "\n".join(map(text, (tag.name, *told))))
        half = HEIGHT / 2
        if tag.width:
            shown += empty(
                "rect", x=-tag.width / 2, y=-half, width=tag.width, height=HEIGHT, rx=half
            )
            shown += element("text", text(tag.text), y=3.8)
        else:
            shown += empty("circle", r=LEAST * 1.6)
        if self.href is not None and tag.findings:
            first = tag.findings[0]
            label = f"{first.severity.label} {', '.join(_codes(tag.findings))} of {tag.name}"
            shown = element("a", shown, href=self.href(first), aria_label=label)
        moved = f"translate({coordinate(x)} {coordinate(y)})"
        shown = element("g", shown, class_="pill", transform=moved)
        leader = empty("path", class_="leader", d=_leader(project(tag.at), (x, y)))
        return element(
            "g",
            leader + shown,
            id=tag.id,
            class_=f"flag{severity}{'' if spot else ' crowded'}",
            data_at=coordinates([tag.at]),
            data_w=tag.width,
        )


def _codes(findings: Iterable[Finding]) -> Iterable[str]:
    return dict.fromkeys(one.rule.code for one in findings)


def _leader(start: tuple[float, float], end: tuple[float, float]) -> str:
    return "M{} {}L{} {}".format(*map(coordinate, (*start, *end)))
