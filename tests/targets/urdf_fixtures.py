"""A URDF for each feature that consumers read differently: a small arm that has it."""

from __future__ import annotations

import struct

INERTIAL = """<inertial><origin xyz="0 0 0.1"/><mass value="2"/>
      <inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial>"""
BOX = '<collision><geometry><box size="0.1 0.1 0.2"/></geometry></collision>'
LIMIT = '<limit lower="-1" upper="2" effort="3" velocity="4"/>'


def robot(  # noqa: PLR0913
    *more: str,
    head: str = '<robot name="arm">',
    base: str = '<link name="base"/>',
    inertial: str = INERTIAL,
    shapes: str = BOX,
    kind: str = "revolute",
    name: str = "elbow",
    origin: str = '<origin xyz="0 0 1"/>',
    axis: str = '<axis xyz="0 0 1"/>',
    limit: str = LIMIT,
    rest: str = "",
    tip: str = "",
) -> str:
    """Return an arm of a base, a link that moves, and one that turns on that."""
    return f"""{head}
  {base}
  <link name="upper">{inertial}{shapes}</link>
  <joint name="{name}" type="{kind}">
    <parent link="base"/><child link="upper"/>{origin}{axis}{limit}{rest}
  </joint>
  <link name="tip">{INERTIAL}{BOX}</link>
  <joint name="wrist" type="revolute">
    <parent link="upper"/><child link="tip"/><origin xyz="0 0 0.5"/><axis xyz="0 1 0"/>{LIMIT}{tip}
  </joint>
  {"".join(more)}
</robot>
"""


def extra(name: str, parent: str, kind: str = "fixed", joint: str = "") -> str:
    """Return a link called *name*, joined to *parent*."""
    return f"""<link name="{name}">{INERTIAL}{BOX}</link>
  <joint name="{joint or f"to_{name}"}" type="{kind}">
    <parent link="{parent}"/><child link="{name}"/>
    <axis xyz="0 0 1"/>{LIMIT if kind in {"revolute", "prismatic"} else ""}</joint>"""


def shape(inner: str, origin: str = "") -> str:
    """Return a collision of the geometry *inner*."""
    return f"<collision>{origin}<geometry>{inner}</geometry></collision>"


def inertia(ixx: float, iyy: float, izz: float, mass: float = 2) -> str:
    """Return an inertial with these principal moments, in kg m²."""
    return f"""<inertial><mass value="{mass}"/>
      <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>"""


def limit(**said: object) -> str:
    """Return a limit with the usual attributes, but for what is *said*; None leaves one out."""
    usual = {"lower": -1, "upper": 2, "effort": 3, "velocity": 4} | said
    words = [f'{name}="{value}"' for name, value in usual.items() if value is not None]
    return f"<limit {' '.join(words)}/>"


VERSION = '<robot name="arm" version="1.1">'
TURNED = '<origin xyz="0 0 1" quat_xyzw="0 0 0.70710678118654752 0.70710678118654752"/>'
MATERIAL = '<visual><geometry><box size="1 1 1"/></geometry><material name="blue"/></visual>'
MASSIVE = f'<link name="base">{INERTIAL}{BOX}</link>'

UNLIKE = """<inertial><origin xyz="0 0 0.1" rpy="{}"/><mass value="2"/>
      <inertia ixx="0.03" iyy="0.04" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial>"""
CORNERS = ((0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
OBJ = "".join(
    [f"v {x} {y} {z}\n" for x, y, z in CORNERS]
    + [f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES]
)
"""A tetrahedron."""
MESHES = {
    "tetrahedron.obj": OBJ.encode(),
    "tetrahedron.stl": bytes(80)
    + struct.pack("<I", len(FACES))
    + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(number for at in face for number in CORNERS[at]), 0)
        for face in FACES
    ),
}
"""Meshes that files name, beside them."""
NUMBERS = " ".join(str(number) for corner in CORNERS for number in corner)
MESHES["tetrahedron.dae"] = f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="12">{NUMBERS}</float_array><technique_common>
      <accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
        <param name="Y" type="float"/><param name="Z" type="float"/></accessor>
    </technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>{" ".join(str(at) for face in FACES for at in face)}</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
""".encode()


def mesh(suffix: str, scale: str = "1 1 1") -> str:
    """Return an arm with a mesh that collides."""
    return robot(shapes=shape(f'<mesh filename="tetrahedron.{suffix}" scale="{scale}"/>'))


FIXTURES = {
    "plain": robot(),
    "revolute-joint": robot(),
    "prismatic-joint": robot(kind="prismatic"),
    "position-limits": robot(limit=limit(lower=-0.5, upper=0.5)),
    "effort-limit": robot(limit=limit(effort=6)),
    "inertia": robot(inertial=UNLIKE.format("0 0 0")),
    "turned-inertial": robot(inertial=UNLIKE.format("0 0 1.5707963267948966")),
    "box": robot(),
    "cylinder": robot(shapes=shape('<cylinder radius="0.1" length="0.3"/>')),
    "sphere": robot(shapes=shape('<sphere radius="0.1"/>')),
    "stl-mesh": mesh("stl"),
    "obj-mesh": mesh("obj"),
    "collada-collision": mesh("dae"),
    "scaled-mesh": mesh("obj", "0.5 0.5 0.5"),
    "mirrored-mesh": mesh("obj", "1 -1 1"),
    "gazebo-extension": robot('<gazebo reference="upper"><mu1>0.1</mu1></gazebo>'),
    "ros2-control": robot(
        """<ros2_control name="arm" type="system"><hardware><plugin>acme/Arm</plugin></hardware>
  <joint name="elbow"><command_interface name="position"/></joint></ros2_control>"""
    ),
    "root-not-joined-to-world": robot(base=MASSIVE),
    "root-fixed-to-world": robot(
        '<link name="world"/>',
        '<joint name="stand" type="fixed"><parent link="world"/><child link="base"/></joint>',
        base=MASSIVE,
    ),
    "nested-floating-joint": robot(extra("ball", "tip", "floating")),
    "planar-joint-with-damping": robot(
        kind="planar", limit="", axis='<axis xyz="0 0 1"/>', rest='<dynamics damping="0.1"/>'
    ),
    "mimic-of-another-kind": robot(
        extra("disc", "tip", "planar"),
        tip='<mimic joint="to_disc"/>',
    ),
    "joint-damping": robot(rest='<dynamics damping="0.7"/>'),
    "velocity-limit": robot(limit=limit(velocity=7)),
    "transmission": robot(
        """<transmission name="drive"><type>transmission_interface/SimpleTransmission</type>
  <joint name="elbow"/><actuator name="motor"><mechanicalReduction>50</mechanicalReduction>
  </actuator></transmission>"""
    ),
    "continuous-joint": robot(kind="continuous", limit='<limit effort="3" velocity="4"/>'),
    "continuous-joint-with-range": robot(kind="continuous"),
    "floating-joint": robot(kind="floating", limit="", axis=""),
    "planar-joint": robot(kind="planar", limit=""),
    "mimic": robot(tip='<mimic joint="elbow" multiplier="2" offset="0.1"/>'),
    "mimic-of-unknown-joint": robot(tip='<mimic joint="nobody"/>'),
    "several-roots": robot(f'<link name="loose">{INERTIAL}{BOX}</link>'),
    "several-parents": robot(
        extra("side", "base", "revolute"),
        '<joint name="bar" type="fixed"><parent link="side"/><child link="tip"/></joint>',
    ),
    "repeated-joint-name": robot(extra("side", "base", "revolute", "elbow")),
    "joint-named-like-link": robot(name="upper"),
    "name-with-separator": robot(name="left elbow/1"),
    "moving-link-without-inertial": robot(inertial=""),
    "bare-moving-link": robot(inertial="", shapes=""),
    "massless-leaf": robot(
        f'<link name="leaf">{inertia(0, 0, 0, 0)}</link><joint name="leafy" type="revolute">'
        f'<parent link="tip"/><child link="leaf"/><axis xyz="1 0 0"/>{LIMIT}</joint>'
    ),
    "negative-mass": robot(inertial=inertia(0.02, 0.02, 0.02, -2)),
    "impossible-inertia": robot(inertial=inertia(0.02, 0.02, 0.2)),
    "negative-moment": robot(inertial=inertia(-0.02, 0.02, 0.02)),
    "root-with-inertia": robot(base=MASSIVE),
    "missing-limit": robot(limit=""),
    "inverted-limit": robot(limit=limit(lower=2, upper=-1)),
    "equal-limits": robot(limit=limit(lower=0.5, upper=0.5)),
    "missing-upper-limit": robot(limit=limit(upper=None)),
    "zero-effort": robot(limit=limit(effort=0)),
    "zero-velocity": robot(limit=limit(velocity=0)),
    "negative-effort": robot(limit=limit(effort=-5)),
    "missing-effort": robot(limit=limit(effort=None)),
    "infinite-limit": robot(limit=limit(upper="inf")),
    "safety-controller": robot(
        rest='<safety_controller soft_lower_limit="-0.5" soft_upper_limit="1" k_position="1"'
        ' k_velocity="1"/>'
    ),
    "joint-friction": robot(rest='<dynamics friction="0.5"/>'),
    "damping-element": robot(rest="<dynamics><damping>0.7</damping></dynamics>"),
    "short-axis": robot(axis='<axis xyz="0 0 0.01"/>'),
    "zero-axis": robot(axis='<axis xyz="0 0 0"/>'),
    "missing-axis": robot(axis=""),
    "several-collisions": robot(shapes=BOX + BOX),
    "capsule": robot(head=VERSION, shapes=shape('<capsule radius="0.1" length="0.3"/>')),
    "undeclared-capsule": robot(shapes=shape('<capsule radius="0.1" length="0.3"/>')),
    "quaternion": robot(head=VERSION, origin=TURNED),
    "undeclared-quaternion": robot(origin=TURNED),
    "declared-version": robot(head=VERSION),
    "missing-mesh": robot(shapes=shape('<mesh filename="nowhere.obj"/>')),
    "negative-size": robot(shapes=shape('<box size="0.1 -0.1 0.1"/>')),
    "zero-size": robot(shapes=shape('<cylinder radius="0" length="1"/>')),
    "undefined-material": robot(shapes=BOX + MATERIAL),
    "unknown-element": robot("<colour/>"),
    "repeated-inertial": robot(inertial=INERTIAL + inertia(0.05, 0.05, 0.05, 5)),
    "decimal-comma": robot(origin='<origin xyz="0 0 0,5"/>'),
    "nan-mass": robot(inertial=inertia(0.02, 0.02, 0.02, float("nan"))),
    "fixed-child": robot(extra("camera", "tip")),
    "empty-robot-name": robot(head='<robot name="">'),
}
"""Files by the feature that each has; `plain` has none."""
