"""A robot as SVG, laid out here: boxes, ellipses and lines, readable without Graphviz."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from kinlint.finding import Finding
from kinlint.reporters.picture.boxes import (
    BADGE,
    BADGE_LINE,
    CLEAR,
    LABEL_LINE,
    LINE,
    NAME,
    SMALL,
    Box,
    boxes,
    cut,
    span,
)
from kinlint.reporters.picture.edges import edges, loops
from kinlint.reporters.picture.escape import attributes, element, empty, number, text
from kinlint.reporters.picture.finding_badges import (
    Badge,
    Marks,
    badge,
    described_findings,
    marked,
    sign,
)
from kinlint.reporters.picture.labels import heading
from kinlint.reporters.picture.placement import MARGIN, Place, layout
from kinlint.reporters.picture.stick_figure import figure_svg
from kinlint.reporters.terminal_style import Style
from kinlint.structure import Structure

NAMESPACE = "http://www.w3.org/2000/svg"
LISTED = 30
"""Number of findings listed below a picture that stands alone."""
HEAD, ROW = 34.0, 17.0
BESIDE = 800.0
"""Width of a tree in pixels up to which it stands beside the stick figure, and not below."""
BADGE_HEIGHT = 16.0
LETTERS = 110
"""Number of characters of a listed message."""


def rules() -> str:
    """The rules of CSS that pictures need, for light and dark."""
    return Path(__file__).with_name("picture.css").read_text(encoding="utf-8")


def figure(
    structure: Structure,
    found: Marks,
    *,
    name: str,
    frames: bool = False,
    href: Callable[[Finding], str] | None = None,
) -> str:
    """A picture for a page that has `rules`.

    *name* begins the ids in it, *href* leads on.
    """
    shapes = boxes(structure, found, frames=frames)
    width, height, content = _drawn(structure, shapes, name, href)
    head = element("title", text(_title(structure)), id=f"{name}-title")
    return element(
        "svg",
        head + content,
        xmlns=NAMESPACE,
        class_="robot",
        role="group",
        aria_labelledby=f"{name}-title",
        viewBox=f"0 0 {number(width)} {number(height)}",
        width=width,
        height=height,
    )


def render(
    pairs: Sequence[tuple[Structure, Marks]], style: Style, *, frames: bool = False
) -> Iterator[str]:
    """A file of all robots; where *style* has no characters beyond ASCII, with references."""
    for piece in document(pairs, frames=frames):
        yield piece if style.unicode else piece.encode("ascii", "xmlcharrefreplace").decode("ascii")


def document(pairs: Sequence[tuple[Structure, Marks]], *, frames: bool = False) -> Iterator[str]:
    """A file of SVG with all robots below each other, each with what is found of it."""
    blocks: list[str] = []
    width, y = 0.0, 0.0
    for index, (structure, found) in enumerate(pairs):
        shapes = boxes(structure, found, frames=frames)
        wide, high, content = _drawn(structure, shapes, f"r{index}", None)
        listing, rows_width, rows_height = _listing(found)
        own = badge(marked(found).get(structure.iri, ()))
        title = cut_heading(structure)
        head = element("text", text(title), class_="heading", x=MARGIN, y=24.0)
        head += _badge(own, MARGIN + span(title, 15.0) + 14.0, 10.0, (), None)
        stick = figure_svg.figure(structure, found, name=f"r{index}-figure")
        left, above = 0.0, 0.0
        body = ""
        if stick is not None:
            body = stick.at(MARGIN, HEAD)
            beside = wide <= BESIDE
            left = figure_svg.WIDTH + MARGIN if beside else 0.0
            above = 0.0 if beside else figure_svg.TALL
            high = max(high, figure_svg.TALL) if beside else high + figure_svg.TALL
            wide = max(wide + left, figure_svg.WIDTH + 2 * MARGIN)
        moved = f"translate({number(left)} {number(HEAD + above)})"
        body += element("g", content, transform=moved)
        foot = element("g", listing, transform=f"translate(0 {number(HEAD + high)})")
        blocks.append(element("g", head + body + foot, transform=f"translate(0 {number(y)})"))
        title_width = 2 * MARGIN + span(title, 15.0) + (own is not None) * 160.0
        width = max(width, wide, rows_width, title_width)
        y += HEAD + high + rows_height
    title = "; ".join(_title(structure) for structure, _ in pairs)
    size = attributes(
        xmlns=NAMESPACE,
        class_="robot",
        role="img",
        viewBox=f"0 0 {number(width)} {number(y)}",
        width=width,
        height=y,
    )
    style = rules() + figure_svg.rules()
    yield f"<svg{size}>\n<title>{text(title)}</title>\n<style>{style}</style>\n"
    yield empty("rect", class_="page", width=width, height=y) + "\n"
    yield from (f"{block}\n" for block in blocks)
    yield "</svg>\n"


def _title(structure: Structure) -> str:
    return f"Kinematic structure of {heading(structure)}"


def cut_heading(structure: Structure) -> str:
    """The heading of a robot, with a name that is not longer than those in its picture."""
    return cut(structure.name) + heading(structure)[len(structure.name) :]


def _drawn(
    structure: Structure, shapes: Sequence[Box], name: str, href: Callable[[Finding], str] | None
) -> tuple[float, float, str]:
    """Width, height and content of the picture of one robot."""
    plan = layout(shapes)
    arrow = f"{name}-arrow"
    closing = {each.iri: each.child for each in structure.loops if each.child is not None}
    head = empty("path", d="M0,0L8,4L0,8z")
    marker = element(
        "marker",
        head,
        id=arrow,
        viewBox="0 0 8 8",
        refX="8",
        refY="4",
        markerWidth="7",
        markerHeight="7",
        orient="auto-start-reverse",
        class_="arrow",
    )
    parts = [
        element("defs", marker),
        *edges(shapes, plan, arrow),
        *loops(shapes, plan, closing, arrow),
        *(
            _shape(box, at, href, across=plan.across)
            for box, at in zip(shapes, plan.places, strict=True)
        ),
    ]
    return plan.width, plan.height, "\n".join(parts)


def _shape(box: Box, at: Place, href: Callable[[Finding], str] | None, *, across: bool) -> str:
    severity = f" {box.badge.severity.label}" if box.badge is not None else ""
    if box.kind in {"joint", "loop"}:
        outline = empty("ellipse", cx=at.x, cy=at.y, rx=box.width / 2, ry=box.height / 2)
    else:
        corner = at.x - box.width / 2, at.y - box.height / 2
        outline = empty(
            "rect", x=corner[0], y=corner[1], width=box.width, height=box.height, rx=5.0
        )
    bottom = at.y + box.height / 2 - (9.0 if box.kind in {"joint", "loop"} else 6.0)
    mark = _badge(box.badge, at.x - box.badge_width / 2, bottom - BADGE_HEIGHT, box.findings, href)
    content = element("title", "\n".join(map(text, _told(box)))) + outline + _rows(box, at)
    return element(
        "g", content + _label(box, at, across=across) + mark, class_=f"{box.kind}{severity}"
    )


def _told(box: Box) -> Iterator[str]:
    """The lines of the title of a shape: its name in full, and what is found of it."""
    yield box.title
    yield from box.rows[1:]
    yield from box.label
    for one in box.findings:
        yield f"{sign(one.severity)} {one.severity.label} {one.rule.code}: {one.message}"


def _rows(box: Box, at: Place) -> str:
    size = SMALL if box.kind == "frame" else NAME
    lines_height = LINE * (len(box.rows) - 1) + (BADGE_LINE if box.badge is not None else 0.0)
    first = at.y - lines_height / 2 + size * 0.35
    lines = [element("text", text(box.rows[0]), class_="name", x=at.x, y=first)]
    lines += [
        element("text", text(row), class_="more", x=at.x, y=first + LINE * number_)
        for number_, row in enumerate(box.rows[1:], 1)
    ]
    return "".join(lines)


def _label(box: Box, at: Place, *, across: bool) -> str:
    """Return the label on the edge to a shape: above it, or at its left."""
    if not box.label:
        return ""
    high, wide = LABEL_LINE * len(box.label), box.label_width + 6.0
    x, y = at.x, at.y - box.height / 2 - box.label_height
    if across:
        x, y = at.x - box.width / 2 - CLEAR - wide / 2, at.y - high / 2
    sheet = empty("rect", class_="sheet", x=x - wide / 2, y=y, width=wide, height=high)
    return sheet + "".join(
        element("text", text(line), class_="label", x=x, y=y + LABEL_LINE * (number_ + 0.76))
        for number_, line in enumerate(box.label)
    )


def _badge(
    mark: Badge | None,
    x: float,
    y: float,
    found: Sequence[Finding],
    href: Callable[[Finding], str] | None,
) -> str:
    if mark is None:
        return ""
    words = mark.text()
    wide = span(words, BADGE) + 14.0
    pill = empty("rect", x=x, y=y, width=wide, height=BADGE_HEIGHT, rx=8.0)
    pill += element("text", text(words), x=x + wide / 2, y=y + 11.6)
    drawn = element("g", pill, class_=f"badge {mark.severity.label}")
    if href is None or not found:
        return drawn
    label = f"{found[0].severity.label} {', '.join(mark.codes)}"
    return element("a", drawn, href=href(found[0]), aria_label=label)


def _listing(found: Marks) -> tuple[str, float, float]:
    """Return the findings of a robot as lines, and the width and height of all."""
    every = list(described_findings(found))
    lines: list[tuple[str, str]] = []
    for one in every[:LISTED]:
        place = f"{one.location.source.name}:{one.location.start.line}"
        message = one.message if len(one.message) <= LETTERS else one.message[: LETTERS - 1] + "…"
        line = f"{sign(one.severity)} {one.rule.code}  {message}  ({place})"
        lines.append((line, one.severity.label))
    if len(every) > LISTED:
        lines.append((f"and {len(every) - LISTED:,} more", "info"))
    content = "".join(
        element("text", text(line), class_=f"told {severity}", x=MARGIN, y=ROW * (index + 0.7))
        for index, (line, severity) in enumerate(lines)
    )
    width = max((span(line, 11.0) for line, _ in lines), default=0.0) + 2 * MARGIN
    return content, width if lines else 0.0, ROW * len(lines) + (MARGIN if lines else 0.0)
