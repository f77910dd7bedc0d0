"""The record of URDF (https://wiki.ros.org/urdf/XML)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import URDF as NAMESPACE

URDF = Format(
    name="urdf",
    title="URDF",
    suffixes=(".urdf",),
    shape=Shape.TREE,
    reader="kinlint.formats.xml.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    namespace=NAMESPACE,
    roots=("robot",),
    robot_path=("robot",),
    fixed_root=True,
    root_children=frozenset(
        {"link", "joint", "material", "transmission", "gazebo", "ros2_control"}
    ),
    schema="formats/urdf.ttl",
    block_comment=("<!--", "-->"),
)
FORMATS = (URDF,)
