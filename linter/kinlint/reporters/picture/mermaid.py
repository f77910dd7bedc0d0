"""A robot as a Mermaid flowchart, which GitHub and GitLab draw in Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinlint.reporters.display_width import printable
from kinlint.reporters.picture.finding_badges import Badge, Marks, badge, marked
from kinlint.reporters.picture.labels import heading, mimics, origin
from kinlint.reporters.terminal_style import Style
from kinlint.structure import Link, Part, Structure

SPECIAL = re.compile(r"[^\w .,:+\-×✖▲●∞−]", re.ASCII)  # noqa: RUF001
LONGEST = 60
STYLES = (
    "classDef link fill:#f4f6f9,stroke:#44546a,color:#17202c",
    "classDef joint fill:#e4efff,stroke:#2463c9,color:#0d2f6e",
    "classDef frame fill:#ffffff,stroke:#8592a3,color:#44546a,stroke-dasharray:2 2",
    "classDef absent fill:#ffffff,stroke:#44546a,color:#44546a,stroke-dasharray:5 3",
    "classDef error stroke:#c62828,stroke-width:3px",
    "classDef warning stroke:#b26a00,stroke-width:3px",
    "classDef info stroke:#5f6b7a,stroke-width:3px",
)


def lines(structure: Structure, found: Marks, *, frames: bool = False) -> Iterator[str]:
    """The lines of the chart, without line ends; *found* are the marks of its parts.

    Links are boxes, joints have round ends, and a loop is closed by a dotted arrow.
    """
    yield "flowchart TB"
    yield from _body(structure, found, "n", frames=frames)
    yield from (f"  {style}" for style in STYLES)


def render(
    pairs: Sequence[tuple[Structure, Marks]], style: Style, *, frames: bool = False
) -> Iterator[str]:
    """Render one chart of all robots; where *style* has ASCII only, with character references."""
    for line in joined(pairs, frames=frames):
        text = line if style.unicode else "".join(map(_referred, line))
        yield f"{text}\n"


def _referred(char: str) -> str:
    return char if char.isascii() else f"#{ord(char)};"


def joined(pairs: Sequence[tuple[Structure, Marks]], *, frames: bool = False) -> Iterator[str]:
    """Yield one chart of several robots, each in a subgraph."""
    if len(pairs) == 1:
        yield from lines(*pairs[0], frames=frames)
        return
    yield "flowchart TB"
    for index, (structure, found) in enumerate(pairs):
        yield f'  subgraph r{index}["{escaped(heading(structure))}"]'
        yield from (f"  {line}" for line in _body(structure, found, f"r{index}n", frames=frames))
        yield "  end"
    yield from (f"  {style}" for style in STYLES)


def _body(structure: Structure, found: Marks, stem: str, *, frames: bool) -> Iterator[str]:
    following = mimics(structure)
    names: dict[str, str] = {}
    found = marked(found)
    if (own := badge(found.get(structure.iri, ()))) is not None:
        text = f"{escaped(structure.name)}<br/>{escaped(own.text())}"
        yield f'  {stem}{{{{"{text}"}}}}:::{own.severity.label}'
    for index, step in enumerate(structure.steps()):
        part, name = step.part, f"{stem}{index}"
        names[part.iri] = name
        yield from _node(part, name, badge(found.get(part.iri, ())), following.get(part.iri, ()))
        if step.above >= 0:
            label = "" if isinstance(part, Link) else "<br/>".join(map(escaped, origin(part)))
            arrow = f'-- "{label}" -->' if label else "-->"
            yield f"  {stem}{step.above} {arrow} {name}"
        if frames and isinstance(part, Link):
            yield from _frames(part, name)
    for joint in structure.loops:
        if joint.child in names:
            yield f'  {names[joint.iri]} -. "closes a loop" .-> {names[joint.child]}'
    for each in structure.couplings:
        if each.leader in names and each.follower in names:
            yield f'  {names[each.leader]} -. "mimic" .-> {names[each.follower]}'


def _node(part: Part, name: str, mark: Badge | None, following: Sequence[str]) -> Iterator[str]:
    rows = [part.name]
    if isinstance(part, Link):
        kind, opening, closing = "absent" if part.absent else "link", "[", "]"
        rows += ["not described"] * part.absent
    else:
        kind, opening, closing = "joint", "([", "])"
        rows += [f"({part.kind})"] * bool(part.kind) + list(following)
    if mark is not None:
        rows.append(mark.text())
    text = "<br/>".join(map(escaped, rows))
    yield f'  {name}{opening}"{text}"{closing}:::{kind}'
    if mark is not None:
        yield f"  class {name} {mark.severity.label}"


def _frames(link: Link, name: str) -> Iterator[str]:
    for number, frame in enumerate(link.frames):
        yield f'  {name}f{number}("{escaped(frame.name)}"):::frame'
        yield f"  {name} -.- {name}f{number}"


def escaped(text: str) -> str:
    """Escape *text* for use in quotes: special characters become character references."""
    if len(text) > LONGEST:
        text = f"{text[: LONGEST - 20]}…{text[-19:]}"
    return SPECIAL.sub(lambda found: f"#{ord(found[0])};", printable(text))
