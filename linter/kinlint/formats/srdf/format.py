"""The record of SRDF (https://wiki.ros.org/srdf)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import SRDF as NAMESPACE

SRDF = Format(
    name="srdf",
    title="SRDF",
    suffixes=(".srdf",),
    shape=Shape.TREE,
    reader="kinlint.formats.xml.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    namespace=NAMESPACE,
    roots=("robot",),
    root_children=frozenset(
        {
            "group", "virtual_joint", "passive_joint", "end_effector", "group_state",
            "joint_property", "disable_collisions", "enable_collisions",
            "disable_default_collisions", "link_sphere_approximation", "rotor_params",
            "specificities",
        }
    ),
    schema="formats/srdf.ttl",
    block_comment=("<!--", "-->"),
    speaks_of="urdf",
)  # fmt: skip
FORMATS = (SRDF,)
