"""The record of launch files of ROS (https://design.ros2.org/articles/roslaunch.html)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import LAUNCH as NAMESPACE

LAUNCH = Format(
    name="launch",
    title="roslaunch",
    suffixes=(
        *(".launch", ".launch.py", ".launch.xml", ".launch.yaml", ".launch.yml"),
        *("_launch.py", "_launch.xml", "_launch.yaml", "_launch.yml"),
    ),
    shape=Shape.TREE,
    reader="kinlint.formats.launch.reader",
    fence="python",
    namespace=NAMESPACE,
    schema="formats/launch.ttl",
    speaks_of="xacro",
    lifted=False,
)
FORMATS = (LAUNCH,)
