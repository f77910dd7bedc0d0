"""The record of YAML files of ROS (https://control.ros.org, https://moveit.picknik.ai)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import YAML as NAMESPACE

YAML = Format(
    name="yaml",
    title="YAML",
    suffixes=(".yaml", ".yml"),
    shape=Shape.TREE,
    reader="kinlint.formats.yaml.reader",
    fence="yaml",
    namespace=NAMESPACE,
    schema="formats/yaml.ttl",
    speaks_of="urdf",
)
FORMATS = (YAML,)
