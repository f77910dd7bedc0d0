"""Robots in the files of workflows."""

GOOD = '<robot name="arm">\n  <link name="base"/>\n</robot>\n'
BAD = """<robot name="arm">
  <link name="base"><inertial><mass value="-1"/>
    <inertia ixx="1" iyy="1" izz="5" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>
"""
AXIS = """<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="elbow" type="continuous">
    <parent link="base"/><child link="hand"/>
  </joint>
</robot>
"""
"""A joint without an axis."""
LONG_AXIS = AXIS.replace('<child link="hand"/>', '<child link="hand"/><axis xyz="2 0 0"/>')
"""A joint whose axis a safe fix makes a unit vector."""
