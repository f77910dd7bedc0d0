"""Names, numbers and tables among the nodes that PyYAML composes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import yaml

from kinlint.text import Span


class Number(NamedTuple):
    """A number that a file gives."""

    name: str
    """Its key."""
    value: float
    """The number."""
    span: Span
    """Its place."""


class Entry(NamedTuple):
    """Mention of a part of a robot, with the numbers that a file gives for it."""

    tag: str
    """`joint`, `joint_limit`, `initial_position`, `link`, `frame`, `group`, `controller`..."""
    name: str
    """The name of the part."""
    span: Span
    """The place of the name, without quotes."""
    numbers: tuple[Number, ...] = ()
    """Numbers that are given for it."""
    group: int = -1
    """Offset of the list or table that it is a member of; -1 if it is none."""
    told: tuple[tuple[str, str | int], ...] = ()
    """Facts that are said of it besides, by the names of properties."""
    parameters: tuple[tuple[str, Span], ...] = ()
    """Keys of the parameters of a controller, with their places."""


def said(table: yaml.MappingNode) -> dict[str, yaml.Node]:
    """Return the values of *table* by their keys."""
    return {str(getattr(key, "value", "")): value for key, value in table.value}


def list_offset(value: yaml.Node) -> int:
    """Return the place in the text that tells a list, or a single name, from others."""
    return int(value.start_mark.index)


def floats(values: Mapping[str, yaml.Node | None]) -> Iterator[Number]:
    """Yield the *values* that are numbers."""
    for name, node in values.items():
        if isinstance(node, yaml.ScalarNode) and node.tag.endswith((":int", ":float")):
            try:
                yield Number(name, float(node.value), span_of(node))
            except ValueError:
                continue


def name_of(node: yaml.Node | None) -> tuple[str, Span] | None:
    """Return a name and its place; None for what is none, or is made by a launch file."""
    if not isinstance(node, yaml.ScalarNode) or not node.tag.endswith(":str"):
        return None
    name = node.value
    if not name or name.isspace() or any(each in name for each in "$<>{}*\n"):
        return None
    return name, span_of(node)


def span_of(node: yaml.ScalarNode) -> Span:
    """Return the place of the text of *node*, without quotes."""
    start, end = node.start_mark.index, node.end_mark.index
    quoted = node.style in ("'", '"')
    return Span(start + quoted, end - quoted)
