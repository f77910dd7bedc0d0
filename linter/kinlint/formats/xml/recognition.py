"""Tells robots in XML apart by what they say; the name of a file is only a hint."""

from __future__ import annotations

import re

from kinlint.formats.xml.markup import first_tag, tags

SUFFIXES = {
    "urdf": "urdf",
    "srdf": "srdf",
    "sdf": "sdf",
    "world": "sdf",
    "xacro": "xacro",
}
"""What files with these endings are called that are XML; their content may say otherwise."""

OTHERS = {
    "mujoco": "MJCF (MuJoCo)",
    "COLLADA": "COLLADA",
}
"""Robots in XML that are not read yet, by root element."""

ROOT = re.compile(r"<([A-Za-z_][\w.-]*+(?::[\w.-]++)?)(?=[\s/>])")
VERSION = re.compile(r"\bversion\s*=")

SEMANTIC = {
    "group", "virtual_joint", "passive_joint", "end_effector", "group_state", "joint_property",
    "disable_collisions", "enable_collisions", "disable_default_collisions",
    "link_sphere_approximation",
}  # fmt: skip
"""What stands in an SRDF directly below the robot."""

PHYSICAL = {"link", "joint", "material", "transmission", "gazebo", "ros2_control"}
"""What stands in a URDF directly below the robot."""

HEAD = 1024
MOST_TAGS = 10_000
"""Nobody looks further to find out what a file is."""


def root(text: str) -> tuple[str, int] | None:
    """The name of the root element and where its tag begins; None if this is no XML."""
    at = first_tag(text)
    match = ROOT.match(text, at) if at >= 0 else None
    return (match[1], at) if match and _may_be_xml(text[:at] or "<") else None


def sniff(text: str, name: str = "") -> str | None:
    """The format of *text*: urdf, srdf, sdf or xacro; None if it is no robot that is read.

    A file called `.xacro` is a source of xacro. One called otherwise after a format is of that
    family even if macros were left in it, for that is what its readers take it for. `.sdf` and
    `.world` are also what other people call files.
    """
    hint = SUFFIXES.get(name.lower().rpartition(".")[2])
    found = root(text)
    if found is None:
        return hint if hint != "sdf" or _may_be_xml(text) else None
    tag, at = found
    if hint == "xacro" or (hint is None and _is_xacro(text, at)):
        return "xacro"
    if tag == "robot":
        return _robot(text, at, hint)
    if tag == "gazebo" and hint is None:
        return "sdf" if VERSION.search(text, at, text.find(">", at)) else None
    return "sdf" if tag == "sdf" else None if tag in OTHERS else hint


def unread(text: str) -> str | None:
    """What *text* is, if it is a robot in a kind of XML that is not read yet."""
    found = root(text)
    return OTHERS.get(found[0]) if found else None


def _may_be_xml(text: str) -> bool:
    return text[:HEAD].lstrip()[:1] in ("<", "")


def _is_xacro(text: str, at: int) -> bool:
    """Whether macros are used; what they were expanded to often declares their prefix still."""
    if "<xacro:" not in text:
        return False
    return any(match[2].startswith("xacro:") for match in tags(text, at, MOST_TAGS))


def _robot(text: str, at: int, hint: str | None) -> str:
    """Whether a robot is a URDF or an SRDF: what stands directly below it decides."""
    depth = 0
    for match in tags(text, at, MOST_TAGS):
        closing, tag, rest = match.groups()
        if depth == 1 and tag in SEMANTIC:
            return "srdf"
        if depth == 1 and tag in PHYSICAL:
            return "urdf"
        if closing:
            depth -= 1
        elif not rest.endswith("/"):
            depth += 1
    return "srdf" if hint == "srdf" else "urdf"
