"""Serial chains of any length in XML formats besides URDF, without a fault."""

from __future__ import annotations

MACRO = """<xacro:macro name="part" params="n parent mass">
  <link name="link${n}">
    <inertial>
      <origin xyz="0 0 0.1" rpy="0 0 0"/>
      <mass value="${mass}"/>
      <inertia ixx="${0.00453333 * mass}" iyy="${0.00416667 * mass}" izz="${0.00203333 * mass}"
        ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual name="link${n}-visual">
      <origin xyz="0 0 0.1" rpy="0 0 0"/>
      <geometry><box size="0.1 0.12 0.2"/></geometry>
    </visual>
  </link>
  <joint name="joint${n}" type="revolute">
    <origin xyz="0 0 0.2" rpy="0 0 0"/>
    <parent link="${parent}"/>
    <child link="link${n}"/>
    <axis xyz="0 0 1"/>
    <limit lower="-2.5" upper="2.5" effort="50" velocity="3.1"/>
  </joint>
</xacro:macro>"""


def xacro_chain(joints: int) -> str:
    """The text of a xacro file that calls a macro for each of *joints* and its link."""
    calls = "\n".join(
        f'  <xacro:part n="{number}" parent="link{number - 1}" mass="0.{900 - number}"/>'
        for number in range(1, joints + 1)
    )
    robot = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    first = '  <link name="link0"/>'
    return f'<?xml version="1.0"?>\n{robot}\n{MACRO}\n{first}\n{calls}\n</robot>\n'


def sdf_chain(joints: int) -> str:
    """The text of a model of *joints* revolute joints between *joints* + 1 links."""
    links = (_link(number, joints) for number in range(joints + 1))
    hinges = (_joint(number) for number in range(1, joints + 1))
    head = '<?xml version="1.0"?>', '<sdf version="1.9">', '<model name="arm">'
    return "\n".join((*head, *links, *hinges, "</model>", "</sdf>", ""))


def _link(number: int, joints: int) -> str:
    mass = 2.0 - number / (2 * joints)
    moments = {"ixx": 0.00453333, "iyy": 0.00416667, "izz": 0.00203333}
    inertia = "".join(f"<{name}>{each * mass:.6f}</{name}>" for name, each in moments.items())
    box = "<geometry><box><size>0.1 0.12 0.2</size></box></geometry>"
    return (
        f'  <link name="link{number}">\n    <pose>0 0 {0.25 * number:.2f} 0 0 0</pose>\n'
        f"    <inertial><pose>0 0 0.1 0 0 0</pose><mass>{mass:.4f}</mass>\n"
        f"      <inertia>{inertia}<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>\n"
        f'    <visual name="look"><pose>0 0 0.1 0 0 0</pose>{box}</visual>\n'
        f'    <collision name="hull"><pose>0 0 0.1 0 0 0</pose>{box}</collision>\n  </link>'
    )


def _joint(number: int) -> str:
    axis = "0 0 1" if number % 2 else "0 1 0"
    limits = "<lower>-2.5</lower><upper>2.5</upper><effort>60</effort><velocity>3.1</velocity>"
    return (
        f'  <joint name="joint{number}" type="revolute">\n'
        f"    <parent>link{number - 1}</parent><child>link{number}</child>\n"
        f"    <axis><xyz>{axis}</xyz><limit>{limits}</limit></axis>\n  </joint>"
    )
