"""Entries of YAML files about joints, found with their places, whatever package reads them.

- `joints: [...]` of a controller (ros2_control, MoveIt), of MoveIt's fake controllers, and the
  wheels of ros2_controllers;
- `joint_limits: {joint: {max_velocity: ...}}` of MoveIt;
- `initial_positions: {joint: value}` of ros2_control.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import yaml

from kinlint.errors import SourceError
from kinlint.formats.joint_words import LARGEST, LIMITS, LISTS, NAMING, POSITIONS
from kinlint.text import Span

TEMPLATE = re.compile(r"\{[{%#]|<%|^\s*@\[", re.MULTILINE)
"""Marks of Jinja, ERB and EmPy, whose templates need not be YAML."""
BOUNDS = {
    "min_position": "has_position_limits",
    "max_position": "has_position_limits",
    "max_velocity": "has_velocity_limits",
    "max_effort": "has_effort_limits",
}
"""Limits of a joint, with the key that says whether each counts."""


class Number(NamedTuple):
    """A number that a file gives."""

    name: str
    """Its key."""
    value: float
    """The number."""
    span: Span
    """Its place."""


class Entry(NamedTuple):
    """Mention of a joint, with the numbers that a file gives for it."""

    tag: str
    """`joint`, `joint_limit` or `initial_position`."""
    name: str
    """The name of the joint."""
    span: Span
    """The place of the name, without quotes."""
    numbers: tuple[Number, ...] = ()
    """Numbers that are given for it."""


def entries(name: str, text: str) -> list[Entry]:
    """Return what *text* of the file called *name* says of joints, in its order.

    Raises `SourceError` for what is neither YAML nor a template of YAML.
    """
    if len(text) > LARGEST or not NAMING.search(text.encode("utf-8", "replace")):
        return []
    try:
        tops = list(yaml.compose_all(text, Loader=yaml.SafeLoader))
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        if TEMPLATE.search(text):
            return []
        raise _source_error(name, error) from error
    found = (each for top in tops if top is not None for each in _entries(top))
    return sorted(found, key=lambda each: each.span.start)


def _source_error(name: str, error: Exception) -> SourceError:
    if isinstance(error, RecursionError):
        return SourceError(name, "nested too deeply")
    if isinstance(error, yaml.MarkedYAMLError) and error.problem_mark is not None:
        mark = error.problem_mark
        return SourceError(name, f"not YAML: {error.problem}", mark.line + 1, mark.column + 1)
    return SourceError(name, f"not YAML: {' '.join(str(error).split())}")


def _entries(top: yaml.Node) -> Iterator[Entry]:
    """Yield what *top* and all below it say; what aliases repeat, once."""
    waiting, seen = [top], {id(top)}
    while waiting:
        node = waiting.pop()
        inner: list[yaml.Node] = []
        if isinstance(node, yaml.MappingNode):
            for key, value in node.value:
                yield from _of_key(getattr(key, "value", None), value)
                inner.append(value)
        elif isinstance(node, yaml.SequenceNode):
            inner = node.value
        for each in inner:
            if id(each) not in seen:
                seen.add(id(each))
                waiting.append(each)


def _of_key(key: object, value: yaml.Node) -> Iterator[Entry]:
    if not isinstance(key, str):
        return
    if key in LISTS:
        listed = value.value if isinstance(value, yaml.SequenceNode) else [value]
        yield from (Entry("joint", *name) for each in listed if (name := _name(each)))
    elif isinstance(value, yaml.MappingNode):
        if key == LIMITS:
            for name, given in _named(value):
                if isinstance(given, yaml.MappingNode):
                    yield Entry("joint_limit", *name, tuple(_bounds(given)))
        elif key == POSITIONS:
            for name, given in _named(value):
                numbers = tuple(_numbers({"value": given}))
                if numbers:
                    yield Entry("initial_position", *name, numbers)


def _named(mapping: yaml.MappingNode) -> Iterator[tuple[tuple[str, Span], yaml.Node]]:
    for key, value in mapping.value:
        if name := _name(key):
            yield name, value


def _bounds(given: yaml.MappingNode) -> Iterator[Number]:
    """Yield the limits of a joint that count."""
    said = {key.value: value for key, value in given.value if isinstance(key, yaml.ScalarNode)}
    counting = {
        name: said[name]
        for name, flag in BOUNDS.items()
        if name in said and (flag not in said or getattr(said[flag], "value", "") in _TRUE)
    }
    yield from _numbers(counting)


_TRUE = frozenset({"true", "True", "TRUE", "yes", "on"})


def _numbers(values: dict[str, yaml.Node]) -> Iterator[Number]:
    for name, node in values.items():
        if isinstance(node, yaml.ScalarNode) and node.tag.endswith((":int", ":float")):
            try:
                yield Number(name, float(node.value), _span(node))
            except ValueError:
                continue


def _name(node: yaml.Node) -> tuple[str, Span] | None:
    """Return a name and its place; None for what is none, or is made by a launch file."""
    if not isinstance(node, yaml.ScalarNode) or not node.tag.endswith(":str"):
        return None
    name = node.value
    if not name or name.isspace() or any(each in name for each in "$<>{}*\n"):
        return None
    return name, _span(node)


def _span(node: yaml.ScalarNode) -> Span:
    start, end = node.start_mark.index, node.end_mark.index
    quoted = node.style in ("'", '"')
    return Span(start + quoted, end - quoted)
