"""Keys under which YAML files of ROS name joints, links, frames and planning groups.

They are those of ros2_controllers, MoveIt, Nav2, robot_localization, slam_toolbox and RViz. A name
in `ros__parameters` can be dotted: the last part of it counts.
"""

from __future__ import annotations

import re
from pathlib import Path

LARGEST = 1 << 18
"""Most characters of a file that is looked into: PyYAML reads some 150 000 of them a second."""

JOINT, LINK, FRAME, GROUP = "joint", "link", "frame", "group"
"""Kinds of things that are named; a frame can be a link, or a frame of another node."""

_WORDS = {
    JOINT: """
        joints joint command_joints joint_names controller_joint_names dof_names
        reference_and_state_dof_names passive_joints
        left_wheel_names right_wheel_names left_wheel right_wheel traction_joints_names
        steering_joints_names front_wheels_names rear_wheels_names traction_joint_name
        steering_joint_name front_left_wheel_command_joint_name
        front_right_wheel_command_joint_name rear_left_wheel_command_joint_name
        rear_right_wheel_command_joint_name
    """,
    LINK: """
        tip_link root_link base_link ik_link kinematics_solver_ik_links kinematics_solver_ik_link
        end_effector_link robot_base_link compliance_ref_link ft_sensor_ref_link
        robot_base_frame base_frame_id base_link_frame ee_frame ee_frame_name
        robot_link_command_frame
    """,
    FRAME: """
        base_frame fixed_frame planning_frame octomap_frame global_frame frame_id sensor_frame
        footprint_frame
    """,
    GROUP: "move_group_name planning_group planning_group_name group_name joint_model_group_name",
}
KINDS = {word: kind for kind, words in _WORDS.items() for word in words.split()}
"""Kinds of what is named by the value of a key, or by each member of a list there."""
IN_RVIZ = {"Fixed Frame": FRAME, "Target Frame": FRAME, "Reference Frame": FRAME,
           "Planning Group": GROUP}  # fmt: skip
"""The same for configurations of RViz."""
DISPLAYED = "Links"
"""Key of the links that RViz shows of a robot."""
LIMITS, POSITIONS = "joint_limits", "initial_positions"
GAINS = "pid_gains"
"""Key of a table by which alone a file is known to name joints."""
PER_JOINT = frozenset({"gains", GAINS, "constraints", "zeros", "dependent_joints"})
"""Keys of tables with an entry for each joint, beside a list of joints or by themselves."""
SOLVER, CONFIGURATIONS, PROJECTION = (
    "kinematics_solver", "planner_configs", "projection_evaluator"
)  # fmt: skip
"""Keys of the settings for a planning group."""
CHAIN, PLUGIN = ("base", "tip"), "plugin_name"
"""Keys of links in the kinematics of an admittance controller, and of the solver beside them."""
OUTSIDE = frozenset(
    {"map", "odom", "world", "earth", "odom_combined", "utm", "base_footprint", "base_stabilized",
     "navigation", "local_origin", "virtual_frame"}
)  # fmt: skip
"""Frames that other nodes publish, by usual names (REP 105, REP 120, robot_localization)."""

NAMING = re.compile(
    rb"(?m)(?:^[ \t-]*|[{,][ \t]*)[\"']?(?:[\w.]*\.)?(?:"
    + "|".join(
        sorted((*KINDS, *IN_RVIZ, DISPLAYED, LIMITS, POSITIONS, PROJECTION, GAINS, f"{SOLVER}\\w*"))
    ).encode()
    + rb")[\"']?[ \t]*:"
)
"""A key by which a file may name parts of a robot."""


def may_name_parts(path: Path) -> bool:
    """Tell whether the YAML file at *path* may name parts of a robot, without parsing it."""
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
