"""Tells robots in XML apart by what they say; the name of a file is only a hint."""

from __future__ import annotations

import re

from kinlint.file_format import Format
from kinlint.formats.records import BY_NAME, TREES, by_suffix
from kinlint.formats.xml.tag_scanner import LOST, first_tag, tags

SDF, XACRO = BY_NAME["sdf"], BY_NAME["xacro"]

ROOT = re.compile(r"<([A-Za-z_][\w.-]*+(?::[\w.-]++)?)(?=[\s/>])")
VERSION = re.compile(r"\bversion\s*=")

OLD_ROOT = "gazebo"
"""The root of SDF files before SDF had its name; URDF has an element of that tag."""

HEAD = 1024
MOST_TAGS = 10_000
"""Nobody looks further to find out what a file is."""


def root(text: str) -> tuple[str, int] | None:
    """Return the name of the root element and where its tag begins; None if this is no XML."""
    lost = LOST.match(text)
    if lost is not None and lost["tag"]:
        return lost["tag"], lost.start("tag")
    at = first_tag(text)
    match = ROOT.match(text, at) if at >= 0 else None
    return (match[1], at) if match and _may_be_xml(text[:at] or "<") else None


def robot_root(text: str, suffix: str) -> bool:
    """Tell whether *text* begins as a robot of a format that shares *suffix* with others does."""
    found = root(text)
    sharing = (each for each in TREES if suffix in each.shared_suffixes)
    return found is not None and any(found[0] == each.robot_path[0] for each in sharing)


def recognise_xml(text: str, name: str = "") -> Format | None:
    """Return the format of an XML *text*, None if it is no robot that is read.

    A file called `.xacro` is a source of xacro. One called otherwise after a format is of that
    family even if macros were left in it, for that is what its readers take it for. `.sdf` and
    `.world` are also what other people call files.
    """
    by_name = by_suffix(name)
    hint = by_name if by_name in TREES else None
    found = root(text)
    if found is None:
        return hint if hint != SDF or _may_be_xml(text) or "</sdf>" in text else None
    tag, at = found
    if hint == XACRO or (hint is None and _is_xacro(text, at)):
        return XACRO
    sharing = [each for each in TREES if tag in each.roots]
    if len(sharing) > 1:
        return _by_children(text, at, sharing, hint)
    if tag == OLD_ROOT and hint is None:
        return SDF if VERSION.search(text, at, text.find(">", at)) else None
    return sharing[0] if sharing else hint


def _may_be_xml(text: str) -> bool:
    head = text[:HEAD].lstrip()
    return head[:1] in ("<", "") or LOST.match(head) is not None


def _is_xacro(text: str, at: int) -> bool:
    """Tell whether macros are used.

    Texts that they were expanded to often declare their prefix still.
    """
    if "<xacro:" not in text:
        return False
    return any(match[2].startswith("xacro:") for match in tags(text, at, MOST_TAGS))


def _by_children(text: str, at: int, sharing: list[Format], hint: Format | None) -> Format:
    """Return the one of the formats *sharing* a root that has the first telling child of it."""
    telling = {tag: each for each in sharing for tag in each.root_children}
    depth = 0
    for match in tags(text, at, MOST_TAGS):
        closing, tag, rest = match.groups()
        if depth == 1 and tag in telling:
            return telling[tag]
        if closing:
            depth -= 1
        elif not rest.endswith("/"):
            depth += 1
    return hint if hint in sharing else sharing[0]
