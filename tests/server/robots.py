"""Robots with one thing wrong, where characters before it take more than one unit."""

LEG = """<?xml version="1.0"?>
<robot name="leg">
  <link name="hip"/>
  <link name="shin">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <joint name="knee" type="revolute">
    <parent link="hip"/>
    <child link="shin"/>
    <axis xyz="0 1 0"/>
    <!-- 🦵é --><limit lower="2" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
GOOD = LEG.replace('lower="2" upper="1"', 'lower="-1" upper="1"')
UNSAVED = LEG.replace('lower="2"', 'lower="0"')

XACRO = (
    """<robot name="leg" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macro.xacro"/>
  <xacro:leg/>
</robot>
""",
    UNSAVED.replace(
        '<robot name="leg">',
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="leg">',
    ).replace("</robot>", "</xacro:macro></robot>"),
)
"""A robot, and what it includes."""
