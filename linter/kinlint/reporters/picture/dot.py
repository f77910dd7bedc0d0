"""A robot in the language of Graphviz, drawn as `urdf_to_graphviz` draws it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinlint.reporters.display_width import printable
from kinlint.reporters.picture.finding_badges import Marks, badge, marked
from kinlint.reporters.picture.labels import heading, limits, mimics, origin
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity
from kinlint.structure import Link, Part, Structure

BEYOND = re.compile("[^\u0000-\uffff]")
"""Characters that Graphviz reads no reference to."""
REFERENCE = "xmlcharrefreplace"
OUTLINES = {Severity.ERROR: "#c62828", Severity.WARNING: "#b26a00", Severity.INFO: "#5f6b7a"}


def render(
    pairs: Sequence[tuple[Structure, Marks]], style: Style, *, frames: bool = False
) -> Iterator[str]:
    """Render one graph of all robots; where *style* has ASCII only, with character references."""
    text = "".join(f"{line}\n" for line in lines(pairs, frames=frames))
    yield text if style.unicode else BEYOND.sub("?", text).encode("ascii", REFERENCE).decode()


def lines(pairs: Sequence[tuple[Structure, Marks]], *, frames: bool = False) -> Iterator[str]:
    """The lines of one graph of all robots, without line ends, each robot with its marks."""
    yield "digraph kinlint {"
    yield '  graph [fontname="Helvetica", nodesep=0.3, ranksep=0.35];'
    yield '  node [fontname="Helvetica", fontsize=11];'
    yield '  edge [fontname="Helvetica", fontsize=9, color="#44546a"];'
    for index, (structure, every) in enumerate(pairs):
        found = marked(every)
        title = [heading(structure), *_mark(found, structure.iri)]
        yield f"  subgraph cluster_{index} {{"
        color = quoted(_color(found, structure.iri))
        yield f"    label={quoted(*title)}; style=rounded; color={color};"
        yield from _body(structure, found, f"r{index}n", frames=frames)
        yield "  }"
    yield "}"


def _body(structure: Structure, found: Marks, stem: str, *, frames: bool) -> Iterator[str]:
    following = mimics(structure)
    names: dict[str, str] = {}
    for index, step in enumerate(structure.steps()):
        part, name = step.part, f"{stem}{index}"
        names[part.iri] = name
        yield f"    {name} [{_node(part, found, following.get(part.iri, ()))}];"
        if step.above >= 0:
            label = () if isinstance(part, Link) else tuple(origin(part))
            told = f" [label={quoted(*label)}]" if label else ""
            yield f"    {stem}{step.above} -> {name}{told};"
        if frames and isinstance(part, Link):
            for number, frame in enumerate(part.frames):
                yield (
                    f"    {name}f{number} [shape=ellipse, style=dotted, fontsize=9, "
                    f"label={quoted(frame.name)}];"
                )
                yield f"    {name} -> {name}f{number} [style=dotted, arrowhead=none];"
    for joint in structure.loops:
        if joint.child in names:
            yield (
                f"    {names[joint.iri]} -> {names[joint.child]} "
                f'[style=dashed, constraint=false, label="closes a loop"];'
            )
    for each in structure.couplings:
        if each.leader in names and each.follower in names:
            yield (
                f"    {names[each.leader]} -> {names[each.follower]} "
                f'[style=dotted, constraint=false, label="mimic"];'
            )


def _node(part: Part, found: Marks, following: Sequence[str]) -> str:
    mark = _mark(found, part.iri)
    width = ", penwidth=3" if mark else ""
    if isinstance(part, Link):
        style = "dashed" if part.absent else "filled"
        rows = [part.name, *(["not described"] if part.absent else []), *mark]
        color = _color(found, part.iri)
        return (
            f'shape=box, style={style}, fillcolor="#f4f6f9", color={quoted(color)}{width}, '
            f"label={quoted(*rows)}"
        )
    kind = " ".join(filter(None, (part.kind, limits(part))))
    rows = [part.name, *filter(None, (kind,)), *following, *mark]
    color = _color(found, part.iri, "#2463c9")
    return (
        f'shape=ellipse, style=filled, fillcolor="#e4efff", color={quoted(color)}{width}, '
        f"label={quoted(*rows)}"
    )


def _mark(found: Marks, iri: str) -> list[str]:
    mark = badge(found.get(iri, ()))
    return [] if mark is None else [mark.text()]


def _color(found: Marks, iri: str, plain: str = "#44546a") -> str:
    mark = badge(found.get(iri, ()))
    return plain if mark is None else OUTLINES[mark.severity]


def quoted(*rows: str) -> str:
    """Return *rows* as one DOT string, each centred on a line of its own."""
    text = "\\n".join(
        printable(row).replace("&", "&amp;").replace("\\", "\\\\").replace('"', '\\"')
        for row in rows
    )
    return f'"{text}"'
