"""The record of xacro (https://wiki.ros.org/xacro), the macro language of ROS for XML."""

from __future__ import annotations

from kinlint.file_format import Format, Shape

XACRO = Format(
    name="xacro",
    title="xacro",
    suffixes=(".xacro",),
    shape=Shape.TREE,
    reader="kinlint.formats.xacro.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    block_comment=("<!--", "-->"),
    expands_to="urdf",
    includes=True,
)
FORMATS = (XACRO,)
