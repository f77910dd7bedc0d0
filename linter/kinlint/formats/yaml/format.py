"""The record of YAML files of ROS (ros2_control, MoveIt, Nav2, RViz)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import YAML as NAMESPACE

YAML = Format(
    name="yaml",
    title="YAML",
    suffixes=(".yaml", ".yml", ".rviz"),
    shape=Shape.TREE,
    reader="kinlint.formats.yaml.reader",
    editor="kinlint.formats.yaml.editor",
    fence="yaml",
    namespace=NAMESPACE,
    schema="formats/yaml.ttl",
    line_comments="kinlint.formats.line_comments",
    speaks_of="urdf",
)
FORMATS = (YAML,)
