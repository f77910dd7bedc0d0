"""Controllers in YAML files: the joints that each claims, in which interfaces, and its wheels.

A controller is a table with joints, or the `ros__parameters` of one: of ros2_control, or of MoveIt,
which sends trajectories to controllers of the same names.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from kinlint.formats.yaml.yaml_nodes import Entry, floats, list_offset, name_of, said
from kinlint.text import Span

PARAMETERS = "ros__parameters"
CLAIMING = {
    "joints": "joints",
    "joint": "joints",
    "left_wheel_names": "left",
    "right_wheel_names": "right",
}
"""Keys of the joints that a controller claims, with the property of the list."""
ONLY = "joint"
"""Key of the one joint of a controller for a gripper, which claims it without more."""
INTERFACES = "command_interfaces"
SIZES = ("wheel_separation", "wheel_radius")
SCALES = ("wheel_separation_multiplier", "left_wheel_radius_multiplier")
"""Factors of a drive; with one of them, its sizes are not those of the model."""
TYPES = re.compile(r"/\w*(?:Controller|Broadcaster)$|^FollowJointTrajectory$")
"""Types of controllers of ros2_control, and of MoveIt."""
CHAINED = ("reference_and_state_dof_names", "dof_names")
"""Keys of controllers that offer interfaces to others."""
SENDING = "controller_names"
"""Key of the controllers that MoveIt sends trajectories to."""


def controllers(table: yaml.MappingNode) -> Iterator[Entry]:
    """Yield the controllers that are entries of *table*, and what a manager lists by type."""
    for each in getattr(said(table).get(SENDING), "value", ()):
        if isinstance(each, yaml.Node) and (listed := name_of(each)) is not None:
            yield Entry("controller_name", *listed)
    for key, value in table.value:
        if not isinstance(value, yaml.MappingNode) or (name := name_of(key)) is None:
            continue
        given = said(value).get(PARAMETERS, value)
        if isinstance(given, yaml.MappingNode) and name[0] != PARAMETERS:
            yield from _controller(*name, given, is_section=given is not value)


def _controller(
    name: str, span: Span, table: yaml.MappingNode, *, is_section: bool
) -> Iterator[Entry]:
    given = said(table)
    kind = _type(given.get("type"))
    lists = {role: given[key] for key, role in CLAIMING.items() if key in given}
    if any(key in given for key in CHAINED) or not (lists or kind or is_section):
        return
    listed = getattr(given.get(INTERFACES), "value", None)
    interfaces = [name_of(each) for each in listed] if isinstance(listed, list) else []
    scaled = any(each.value != 1.0 for each in floats({key: given.get(key) for key in SCALES}))
    sizes = {} if scaled else {key: given.get(key) for key in SIZES}
    told: list[tuple[str, str | int]] = [
        *((role, list_offset(each)) for role, each in lists.items()),
        *(("interface", each[0]) for each in interfaces if each is not None),
        *([("controllerType", kind)] if kind else []),
        *([("drives", only[0])] if (only := name_of(given.get(ONLY))) else []),
    ]
    keys = [name_of(key) for key, _ in table.value if is_section]
    parameters = tuple(key for key in keys if key is not None)
    sized = tuple(floats(sizes))
    yield Entry("controller", name.lstrip("/"), span, sized, -1, tuple(told), parameters)


def _type(node: yaml.Node | None) -> str:
    """Return the type of a controller; empty if *node* is none."""
    kind = node.value if isinstance(node, yaml.ScalarNode) else ""
    return kind if TYPES.search(kind) else ""
