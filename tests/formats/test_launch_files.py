"""Arguments that launch files pass to xacro, in Python, XML and YAML; nothing is run."""

import pytest
from support.linting import source

from kinlint.formats.launch.reader import calls

PYTHON = """
import os
from ament_index_python.packages import get_package_share_directory
from launch.substitutions import Command, FindExecutable, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

share = get_package_share_directory("arm_description")
{}
"""


def found(text, name):
    """File and arguments of each call, each argument as it stands at its place."""
    made = source(text, name)
    return [
        (call.file, [(name, made[span]) for name, span in call.arguments]) for call in calls(made)
    ]


FILE = "package://arm_description/urdf/arm.urdf.xacro"


@pytest.mark.parametrize(
    "code",
    [
        'a = Command(["xacro ", share, "/urdf/arm.urdf.xacro", " prefix:=", "x_", " sim:=true"])',
        'a = Command(f"xacro {share}/urdf/arm.urdf.xacro prefix:={1} sim:=true")',
        """a = Command([PathJoinSubstitution([FindExecutable(name='xacro')]), ' ',
            PathJoinSubstitution([FindPackageShare('arm_description'), 'urdf', 'arm.urdf.xacro']),
            ' ', 'prefix:=', prefix, ' ', 'sim:=', LaunchConfiguration('sim')])""",
        """path = os.path.join(share, 'urdf', 'arm.urdf.xacro')
import xacro
a = xacro.process_file(path, mappings={'prefix': 'x_', 'sim': 'true'}).toxml()""",
        """from pathlib import Path
import xacro
a = xacro.process_file(str(Path(share) / "urdf" / "arm.urdf.xacro"),
                       mappings=dict_of) if 0 else xacro.process(
    Path(share).joinpath("urdf", "arm.urdf.xacro"), mappings={"prefix": p, "sim": "1"})""",
        """a = MoveItConfigsBuilder("arm", package_name="arm_description").robot_description(
    file_path="urdf/arm.urdf.xacro", mappings={"prefix": "", "sim": ""}).to_moveit_configs()""",
    ],
    ids=["parts", "f-string", "substitutions", "process_file", "pathlib", "moveit"],
)
def test_python(code):
    arguments = [("prefix", "prefix"), ("sim", "sim")]
    text = PYTHON.format(code)
    if '(f"' in code:
        arguments = [(name, code.partition("= ")[2]) for name, _ in arguments]
    assert found(text, "arm.launch.py") == [(FILE, arguments)]


@pytest.mark.parametrize(
    "code",
    [
        'a = Command(["xacro ", path(), " prefix:=x"])',
        'share = other\na = Command(["xacro ", share, "/arm.xacro prefix:=x"])',
        'a = Command(["cat ", share, "/arm.xacro prefix:=x"])',
        "a = Command([",
        "a = Command(" + "[" * 5_000,
        "a = b\nb = a\nc = Command(['xacro ', a, '/arm.xacro prefix:=x'])",
    ],
    ids=["call", "twice", "other program", "broken", "deep", "circle"],
)
def test_what_only_running_tells_is_passed_over(code):
    assert found(PYTHON.format(code), "arm.launch.py") == []


ROS1 = """<launch>
  <!-- <param command="$(find xacro)/xacro $(find arm_description)/a.xacro old:=1"/> -->
  <param name="robot_description"
    command="$(find xacro)/xacro '$(find arm_description)/urdf/arm.urdf.xacro' prefix:=$(arg p)"/>
</launch>
"""
ROS2 = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
  <param name="robot_description" value="$(command
    'xacro $(find-pkg-share arm_description)/urdf/arm.urdf.xacro prefix:=$(var p)')"/>
</node></launch>
"""
YAML = """launch:
- node:
    pkg: robot_state_publisher
    # value: "$(command 'xacro $(find-pkg-share arm_description)/a.xacro old:=1')"
    param:
    - name: robot_description
      value: "$(command 'xacro $(find-pkg-share arm_description)/urdf/arm.urdf.xacro prefix:=x')"
"""


@pytest.mark.parametrize(
    ("text", "name"),
    [(ROS1, "arm.launch"), (ROS2, "arm.launch.xml"), (YAML, "arm.launch.yaml")],
)
def test_markup(text, name):
    assert found(text, name) == [(FILE, [("prefix", "prefix")])]


def test_columns_count_characters():
    """Python counts bytes."""
    code = '"\U0001f916ä"; a = Command(["xacro ", share, "/arm.xacro", " prefix:=x"])'
    (call,) = found(PYTHON.format(code), "arm.launch.py")
    assert call[1] == [("prefix", "prefix")]
