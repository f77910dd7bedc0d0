"""Entries of YAML files that name parts of a robot, with their places, whatever node reads them.

- names under the keys of `ros_keys`, one by one or in lists;
- `joint_limits: {joint: {max_velocity: ...}}` of MoveIt;
- `initial_positions: {joint: value}` of ros2_control;
- tables with an entry for each joint, such as `gains`;
- settings of planning groups, known by the keys in them, and the links that RViz shows.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from kinlint.formats.yaml.controllers import controllers
from kinlint.formats.yaml.ros_keys import (
    CHAIN,
    CONFIGURATIONS,
    DISPLAYED,
    FRAME,
    GROUP,
    IN_RVIZ,
    JOINT,
    KINDS,
    LIMITS,
    LINK,
    PER_JOINT,
    PLUGIN,
    POSITIONS,
    PROJECTION,
    SOLVER,
)
from kinlint.formats.yaml.yaml_nodes import Entry, Number, floats, list_offset, name_of, said
from kinlint.text import Span

BOUNDS = {
    "min_position": "has_position_limits",
    "max_position": "has_position_limits",
    "max_velocity": "has_velocity_limits",
    "max_acceleration": "has_acceleration_limits",
    "max_effort": "has_effort_limits",
}
"""Limits of a joint, with the key that says whether each counts."""
_TRUE = frozenset({"true", "True", "TRUE", "yes", "on"})
_PROJECTED = re.compile(r"(joints|link)\(([^()]*)\)")
_WORD = re.compile(r"[^\s,]+")


def entries(top: yaml.Node) -> Iterator[Entry]:
    """Yield what *top* and all below it name; what aliases repeat, once."""
    waiting, seen = [top], {id(top)}
    while waiting:
        node = waiting.pop()
        inner: list[yaml.Node] = []
        if isinstance(node, yaml.MappingNode):
            yield from _of_mapping(node)
            inner = [value for _, value in node.value]
        elif isinstance(node, yaml.SequenceNode):
            inner = node.value
        for each in inner:
            if id(each) not in seen:
                seen.add(id(each))
                waiting.append(each)


def _of_mapping(node: yaml.MappingNode) -> Iterator[Entry]:
    yield from controllers(node)
    given = said(node)
    lists_joints = isinstance(given.get("joints"), yaml.SequenceNode)
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            continue
        word = key.value if key.value in IN_RVIZ else key.value.rpartition(".")[2]
        kind = KINDS.get(word) or IN_RVIZ.get(word)
        if kind is not None:
            yield from _listed(kind, value)
        elif word == PROJECTION:
            yield from _projected(value)
        elif word == "group" and "pose" in given:
            yield from _listed(GROUP, value)
        elif isinstance(value, yaml.MappingNode):
            yield from _of_table(key, word, value, lists_joints=lists_joints)


def _of_table(
    key: yaml.ScalarNode, word: str, table: yaml.MappingNode, *, lists_joints: bool
) -> Iterator[Entry]:
    """Yield what the *table* under *key* names, and the *key* itself where it is a group."""
    if word in (LIMITS, POSITIONS):
        yield from _valued(word, table)
    elif word in PER_JOINT and (lists_joints or word not in ("gains", "constraints")):
        yield from _keys(JOINT, table, scalars=word == "zeros")
    elif word == DISPLAYED:
        yield from _keys(FRAME, table)
    elif word == "kinematics":
        told = said(table)
        if PLUGIN in told:
            for end in (each for each in CHAIN if each in told):
                yield from _listed(LINK, told[end])
    elif word == "frame":
        told = said(table)
        if "id" in told and getattr(told.get("external"), "value", "") not in _TRUE:
            yield from _listed(FRAME, told["id"])
    elif _is_group(table) and (group := name_of(key)):
        yield Entry(GROUP, *group)


def _keys(kind: str, table: yaml.MappingNode, *, scalars: bool = False) -> Iterator[Entry]:
    """Yield the keys of *table* that have a table, or any value if these are *scalars*."""
    for name, given in _named(table):
        if scalars or isinstance(given, yaml.MappingNode):
            yield Entry(kind, *name, (), table.start_mark.index)


def _valued(word: str, table: yaml.MappingNode) -> Iterator[Entry]:
    """Yield the joints in a *table* of limits or positions, with their numbers."""
    at = table.start_mark.index
    for name, given in _named(table):
        if word == POSITIONS:
            if numbers := tuple(floats({"value": given})):
                yield Entry("initial_position", *name, numbers, at)
        elif isinstance(given, yaml.MappingNode):
            yield Entry("joint_limit", *name, tuple(_bounds(given)), at)


def _is_group(table: yaml.MappingNode) -> bool:
    """Tell whether *table* has what kinematics.yaml or ompl_planning.yaml says of a group."""
    told = said(table)
    chosen = isinstance(told.get(CONFIGURATIONS), yaml.SequenceNode)
    return chosen or PROJECTION in told or isinstance(told.get(SOLVER), yaml.ScalarNode)


def _listed(kind: str, value: yaml.Node) -> Iterator[Entry]:
    several = isinstance(value, yaml.SequenceNode)
    group = list_offset(value) if several or kind == JOINT else -1
    listed = value.value if several else [value]
    yield from (Entry(kind, *name, (), group) for each in listed if (name := name_of(each)))


def _projected(value: yaml.Node) -> Iterator[Entry]:
    """Yield the joints or the link of `joints(shoulder, elbow)` or `link(tool0)`."""
    if not isinstance(value, yaml.ScalarNode) or (found := name_of(value)) is None:
        return
    text, span = found
    match = _PROJECTED.fullmatch(text)
    if match is None or span.end - span.start != len(text):
        return
    for word in _WORD.finditer(match[2]):
        start = span.start + match.start(2) + word.start()
        kind = JOINT if match[1] == "joints" else LINK
        yield Entry(kind, word[0], Span(start, start + len(word[0])), (), span.start)


def _named(mapping: yaml.MappingNode) -> Iterator[tuple[tuple[str, Span], yaml.Node]]:
    for key, value in mapping.value:
        if name := name_of(key):
            yield name, value


def _bounds(given: yaml.MappingNode) -> Iterator[Number]:
    """Yield the limits of a joint that count."""
    told = {key.value: value for key, value in given.value if isinstance(key, yaml.ScalarNode)}
    counting = {
        name: told[name]
        for name, flag in BOUNDS.items()
        if name in told and (flag not in told or getattr(told[flag], "value", "") in _TRUE)
    }
    yield from floats(counting)
