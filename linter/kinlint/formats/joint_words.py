"""Words by which a YAML file is about the joints of a robot, without parsing it."""

from __future__ import annotations

import re
from pathlib import Path

LARGEST = 1 << 18
"""Most characters of a file that is looked into: PyYAML reads some 150 000 of them a second."""
LISTS = frozenset(
    {
        "joints", "command_joints", "left_wheel_names", "right_wheel_names",
        "traction_joints_names", "steering_joints_names", "front_wheels_names",
        "rear_wheels_names", "traction_joint_name", "steering_joint_name",
    }
)  # fmt: skip
"""Keys of names of joints, in one list or one by one."""
LIMITS, POSITIONS = "joint_limits", "initial_positions"
NAMING = re.compile(
    rb"(?m)^[ \t-]*[\"']?(?:"
    + "|".join(sorted((*LISTS, LIMITS, POSITIONS))).encode()
    + rb")[\"']?[ \t]*:"
)
"""A key by which a file may be about joints."""


def may_name_joints(path: Path) -> bool:
    """Tell whether the YAML file at *path* may be about joints, without decoding or parsing it."""
    if not path.is_file() or path.stat().st_size > LARGEST:
        return False
    data = path.read_bytes()
    if NAMING.search(data) is None:
        return False
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True
