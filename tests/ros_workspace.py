"""A colcon workspace: two repositories, a MoveIt configuration, what is built."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from shutil import copytree

XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
BODY = """<inertial><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>"""
GRIPPER = f"""<robot {XMLNS}>
  <xacro:macro name="gripper" params="prefix parent">
    <link name="${{prefix}}hand">{BODY}</link>
    <joint name="${{prefix}}wrist" type="revolute">
      <parent link="${{parent}}"/><child link="${{prefix}}hand"/><axis xyz="0 0 1"/>
      <limit lower="-3" upper="3" effort="10" velocity="2"/>
    </joint>
  </xacro:macro>
</robot>
"""
ARM = f"""<robot name="my_arm" {XMLNS}>
  <xacro:arg name="prefix" default=""/>
  <xacro:property name="prefix" value="$(arg prefix)"/>
  <xacro:include filename="$(find my_gripper_description)/urdf/gripper.xacro"/>
  <link name="${{prefix}}base">{BODY}</link>
  <link name="${{prefix}}forearm">{BODY}</link>
  <joint name="${{prefix}}elbow" type="revolute">
    <parent link="${{prefix}}base"/><child link="${{prefix}}forearm"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="50" velocity="1.5"/>
  </joint>
  <xacro:gripper prefix="${{prefix}}" parent="${{prefix}}forearm"/>
</robot>
"""
SRDF = """<robot name="my_arm">
  <group name="arm"><joint name="elbow"/><joint name="wrist"/></group>
  <group_state name="home" group="arm">
    <joint name="elbow" value="0"/><joint name="wrist" value="0"/>
  </group_state>
</robot>
"""
FILES = {
    "src/arm_repo/my_arm_description/urdf/my_arm.urdf.xacro": ARM,
    "src/gripper_repo/my_gripper_description/urdf/gripper.xacro": GRIPPER,
    "src/arm_repo/my_arm_moveit_config/config/my_arm.srdf": SRDF,
}
PACKAGES = (
    "src/arm_repo/my_arm_description",
    "src/arm_repo/my_arm_moveit_config",
    "src/gripper_repo/my_gripper_description",
)
ARM_FILE, GRIPPER_FILE, SRDF_FILE = FILES


@dataclass(frozen=True)
class RosWorkspace:
    """The workspace at `top`."""

    top: Path

    def write(self, name, text):
        """Write the file *name*; return its path."""
        path = self.top / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
        return path

    def change(self, name, old, new):
        """Replace *old* in the file *name*, where it is, by *new*."""
        path = self.top / name
        text = path.read_text("utf-8")
        assert old in text
        path.write_text(text.replace(old, new), "utf-8")

    def build(self):
        """Make `build`, `install` and `log`, with copies of the packages as colcon makes them."""
        for package in PACKAGES:
            name = Path(package).name
            copytree(self.top / package, self.top / "install" / name / "share" / name)
            copytree(self.top / package, self.top / "build" / name)
        for each in ("build", "install", "log"):
            self.write(f"{each}/COLCON_IGNORE", "")


def make(top):
    """Return a workspace without faults at *top*; each repository has its own git."""
    made = RosWorkspace(top)
    for name, text in FILES.items():
        made.write(name, text)
    for package in PACKAGES:
        name = Path(package).name
        made.write(
            f"{package}/package.xml",
            f'<?xml version="1.0"?>\n<package format="3">\n  <name>{name}</name>\n</package>\n',
        )
    for repository in ("arm_repo", "gripper_repo"):
        made.write(f"src/{repository}/.git/HEAD", "ref: refs/heads/main\n")
    return made
