"""One arm as text in each format: three joints between four links that have mass and shape."""

from __future__ import annotations

import math
from typing import NamedTuple


class Link(NamedTuple):
    """A link, and where it is drawn in the zero configuration."""

    name: str
    mass: float
    centre: float
    """Height of the centre of mass, which is that of the shape, above the frame of the link."""
    moments: tuple[float, float, float]
    kind: str
    size: tuple[float, ...]
    """Edges of a box, radius and length of a cylinder, radius of a sphere."""


class Joint(NamedTuple):
    """A joint between a link and the next one."""

    name: str
    kind: str
    height: float
    axis: tuple[int, int, int]
    lower: float
    upper: float
    effort: float
    speed: float


LINKS = (
    Link("base", 4, 0.05, (0.02, 0.02, 0.03), "box", (0.2, 0.3, 0.1)),
    Link("upper", 2, 0.2, (0.03, 0.03, 0.01), "cylinder", (0.05, 0.4)),
    Link("forearm", 1.5, 0.15, (0.01, 0.01, 0.004), "cylinder", (0.04, 0.3)),
    Link("hand", 0.3, 0.0, (0.001, 0.001, 0.001), "sphere", (0.05,)),
)
JOINTS = (
    Joint("shoulder", "revolute", 0.1, (0, 0, 1), -2, 2, 50, 2),
    Joint("elbow", "revolute", 0.4, (0, 1, 0), -1.5, 1.5, 30, 3),
    Joint("wrist", "prismatic", 0.3, (0, 0, 1), 0, 0.1, 10, 0.5),
)


class Arm(NamedTuple):
    """The arm, with what `with_change` made of it."""

    links: tuple[Link, ...] = LINKS
    joints: tuple[Joint, ...] = JOINTS

    def with_change(self, part: str, **values: object) -> Arm:
        """Return the arm in which the link or joint *part* has other *values*."""
        return Arm(
            tuple(e._replace(**values) if e.name == part else e for e in self.links),
            tuple(e._replace(**values) if e.name == part else e for e in self.joints),
        )

    def heights(self) -> list[float]:
        """Return the height of each link in the zero configuration."""
        return [math.fsum(each.height for each in self.joints[:at]) for at in range(4)]

    def steps(self) -> list[tuple[Joint, str, str]]:
        """Return each joint with the names of the links that it joins."""
        names = [each.name for each in self.links]
        return list(zip(self.joints, names, names[1:], strict=False))


def spaced(numbers: tuple[float, ...]) -> str:
    return " ".join(map(str, numbers))


def urdf(arm: Arm) -> str:
    shapes = {
        "box": lambda size: f'<box size="{spaced(size)}"/>',
        "cylinder": lambda size: f'<cylinder radius="{size[0]}" length="{size[1]}"/>',
        "sphere": lambda size: f'<sphere radius="{size[0]}"/>',
    }
    text = '<robot name="arm">'
    for link in arm.links:
        ixx, iyy, izz = link.moments
        place = f'<origin xyz="0 0 {link.centre}"/>'
        text += f"""<link name="{link.name}">
  <inertial>{place}<mass value="{link.mass}"/>
    <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision>{place}<geometry>{shapes[link.kind](link.size)}</geometry></collision></link>
"""
    for joint, parent, child in arm.steps():
        text += f"""<joint name="{joint.name}" type="{joint.kind}">
  <origin xyz="0 0 {joint.height}"/><parent link="{parent}"/><child link="{child}"/>
  <axis xyz="{spaced(joint.axis)}"/><limit lower="{joint.lower}" upper="{joint.upper}"
    effort="{joint.effort}" velocity="{joint.speed}"/></joint>
"""
    return f"{text}</robot>"


def xacro(arm: Arm) -> str:
    """Return the arm with its masses as properties."""
    text = urdf(arm).replace(
        '<robot name="arm">', '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    )
    for link in arm.links:
        told = f'<xacro:property name="{link.name}_mass" value="{link.mass}"/>'
        text = text.replace(f'<link name="{link.name}">', f'{told}<link name="{link.name}">')
        here = text.index(told) + len(told)
        mass = f'<mass value="{link.mass}"/>'
        text = text[:here] + text[here:].replace(mass, f'<mass value="${{{link.name}_mass}}"/>', 1)
    return text


def sdf(arm: Arm) -> str:
    shapes = {
        "box": lambda size: f"<box><size>{spaced(size)}</size></box>",
        "cylinder": lambda size: (
            f"<cylinder><radius>{size[0]}</radius><length>{size[1]}</length></cylinder>"
        ),
        "sphere": lambda size: f"<sphere><radius>{size[0]}</radius></sphere>",
    }
    text = '<sdf version="1.9"><model name="arm">'
    for link, height in zip(arm.links, arm.heights(), strict=True):
        moments = "".join(
            f"<i{2 * axis}>{value}</i{2 * axis}>"
            for axis, value in zip("xyz", link.moments, strict=True)
        )
        place = f"<pose>0 0 {link.centre} 0 0 0</pose>"
        text += f"""<link name="{link.name}"><pose>0 0 {height} 0 0 0</pose>
  <inertial>{place}<mass>{link.mass}</mass><inertia>{moments}</inertia></inertial>
  <collision name="touch">{place}<geometry>{shapes[link.kind](link.size)}</geometry></collision>
</link>
"""
    for joint, parent, child in arm.steps():
        text += f"""<joint name="{joint.name}" type="{joint.kind}">
  <parent>{parent}</parent><child>{child}</child><axis><xyz>{spaced(joint.axis)}</xyz>
  <limit><lower>{joint.lower}</lower><upper>{joint.upper}</upper><effort>{joint.effort}</effort>
    <velocity>{joint.speed}</velocity></limit></axis></joint>
"""
    return f"{text}</model></sdf>"


def mjcf(arm: Arm) -> str:
    text = '<mujoco model="arm"><compiler angle="radian"/><worldbody>'
    for link, joint in zip(arm.links, (None, *arm.joints), strict=True):
        half = tuple(each / 2 for each in link.size)
        size = {"box": half, "cylinder": (link.size[0], half[-1]), "sphere": link.size}[link.kind]
        text += f'<body name="{link.name}" pos="0 0 {joint.height if joint else 0}">'
        if joint:
            kind = "slide" if joint.kind == "prismatic" else "hinge"
            text += f"""<joint name="{joint.name}" type="{kind}" axis="{spaced(joint.axis)}"
  limited="true" range="{joint.lower} {joint.upper}"
  actuatorfrclimited="true" actuatorfrcrange="-{joint.effort} {joint.effort}"/>"""
        place = f'pos="0 0 {link.centre}"'
        text += f"""
<inertial {place} mass="{link.mass}" diaginertia="{spaced(link.moments)}"/>
<geom type="{link.kind}" size="{spaced(size)}" {place}/>
"""
    return text + "</body>" * 4 + "</worldbody></mujoco>"


def usd(arm: Arm) -> str:
    """Return the arm with unit cubes that are scaled, and angles in degrees."""
    text = """#usda 1.0
(
    defaultPrim = "arm"
    metersPerUnit = 1
    kilogramsPerUnit = 1
    upAxis = "Z"
)
def Xform "arm" (prepend apiSchemas = ["PhysicsArticulationRootAPI"])
{
"""
    moved = 'uniform token[] xformOpOrder = ["xformOp:translate"'
    for link, height in zip(arm.links, arm.heights(), strict=True):
        size = link.size
        prim, sizes, order = {
            "box": (
                "Cube",
                f"double size = 1\ndouble3 xformOp:scale = {size}",
                ', "xformOp:scale"',
            ),
            "cylinder": ("Cylinder", f"double radius = {size[0]}\ndouble height = {size[-1]}", ""),
            "sphere": ("Sphere", f"double radius = {size[0]}", ""),
        }[link.kind]
        text += f"""def Xform "{link.name}" (
    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"])
{{
    double3 xformOp:translate = (0, 0, {height})
    {moved}]
    float physics:mass = {link.mass}
    point3f physics:centerOfMass = (0, 0, {link.centre})
    float3 physics:diagonalInertia = {link.moments}
    quatf physics:principalAxes = (1, 0, 0, 0)
    def {prim} "shape" (prepend apiSchemas = ["PhysicsCollisionAPI"])
    {{
        {sizes}
        double3 xformOp:translate = (0, 0, {link.centre})
        {moved}{order}]
    }}
}}
"""
    for joint, parent, child in arm.steps():
        turns = joint.kind == "revolute"
        unit, way = (180 / math.pi, "angular") if turns else (1, "linear")
        text += f"""def Physics{joint.kind.title()}Joint "{joint.name}" (
    prepend apiSchemas = ["PhysicsDriveAPI:{way}"])
{{
    rel physics:body0 = </arm/{parent}>
    rel physics:body1 = </arm/{child}>
    uniform token physics:axis = "{"XYZ"[joint.axis.index(1)]}"
    point3f physics:localPos0 = (0, 0, {joint.height})
    point3f physics:localPos1 = (0, 0, 0)
    quatf physics:localRot0 = (1, 0, 0, 0)
    quatf physics:localRot1 = (1, 0, 0, 0)
    float physics:lowerLimit = {joint.lower * unit}
    float physics:upperLimit = {joint.upper * unit}
    float drive:{way}:physics:maxForce = {joint.effort}
    float drive:{way}:physics:stiffness = 100
}}
"""
    return text + "}\n"


def collada(arm: Arm) -> str:
    """Return the arm as OpenRAVE writes it: physics in the frame of the base, cylinders along y."""
    nodes = links = joints = bodies = ends = told = ""
    opened = 0
    for at, (link, joint) in enumerate(zip(arm.links, (None, *arm.joints), strict=True)):
        shift = f"<translate>0 0 {joint.height if joint else 0}</translate>"
        place = f"<translate>0 0 {arm.heights()[at] + link.centre}</translate>"
        upright = "<rotate>1 0 0 90</rotate>" if link.kind == "cylinder" else ""
        turn = ""
        if joint:
            turns = joint.kind == "revolute"
            unit = 180 / math.pi if turns else 1
            axis = f"<axis>{spaced(joint.axis)}</axis>"
            turn = (
                f'<rotate sid="move">{spaced(joint.axis)} 0</rotate>'
                if turns
                else '<translate sid="move">0 0 0</translate>'
            )
            joints += f"""<joint sid="j{at}" name="{joint.name}"><{joint.kind} sid="axis0">{axis}
<limits><min>{joint.lower * unit}</min><max>{joint.upper * unit}</max></limits>
</{joint.kind}></joint>
"""
            links += f'<attachment_full joint="arm/j{at}">{shift}'
            told += f"""<bind_joint_axis target="n{at}/move">
<axis><param>axis{at}</param></axis><value><float>0</float></value></bind_joint_axis>
"""
            ends += f'<newparam sid="axis{at}"><SIDREF>moved/it/j{at}/axis0</SIDREF></newparam>\n'
        links += f'<link sid="l{at}" name="{link.name}">'
        nodes += f'<node id="n{at}" name="{link.name}">{shift}{turn}'
        opened += 1
        half = " ".join(str(each / 2) for each in link.size)
        form = {
            "box": f"<box><half_extents>{half}</half_extents></box>",
            "cylinder": f"<cylinder><height>{link.size[-1]}</height>"
            f"<radius>{link.size[0]} {link.size[0]}</radius></cylinder>",
            "sphere": f"<sphere><radius>{link.size[0]}</radius></sphere>",
        }[link.kind]
        bodies += f"""<rigid_body sid="b{at}" name="{link.name}"><technique_common>
<dynamic>true</dynamic><mass>{link.mass}</mass><mass_frame>{place}</mass_frame>
<inertia>{spaced(link.moments)}</inertia><shape>{form}{place}{upright}</shape></technique_common></rigid_body>
"""
    closed = "</link></attachment_full>" * (opened - 1) + "</link>"
    held = "\n".join(
        f'<instance_rigid_body body="b{at}" target="#n{at}"/>' for at in range(len(arm.links))
    )
    return f"""<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_visual_scenes><visual_scene id="drawn">{nodes}{"</node>" * opened}</visual_scene>
</library_visual_scenes>
<library_kinematics_models><kinematics_model id="arm" name="arm"><technique_common>
{joints}{links}{closed}</technique_common></kinematics_model></library_kinematics_models>
<library_kinematics_scenes><kinematics_scene id="moved">
<instance_kinematics_model url="#arm" sid="it">
<newparam sid="model"><SIDREF>moved/it</SIDREF></newparam>
{ends}</instance_kinematics_model></kinematics_scene></library_kinematics_scenes>
<library_physics_models><physics_model id="solid">{bodies}</physics_model></library_physics_models>
<library_physics_scenes><physics_scene id="physics">
<instance_physics_model url="#solid" parent="#n0">{held}</instance_physics_model>
<technique_common><gravity>0 0 -9.81</gravity></technique_common></physics_scene>
</library_physics_scenes>
<scene><instance_visual_scene url="#drawn"/><instance_physics_scene url="#physics"/>
<instance_kinematics_scene url="#moved">
<bind_kinematics_model node="n0"><param>model</param></bind_kinematics_model>
{told}</instance_kinematics_scene></scene></COLLADA>
"""


FORMATS = {
    "urdf": urdf,
    "xacro": xacro,
    "sdf": sdf,
    "xml": mjcf,
    "usda": usd,
    "dae": collada,
}
"""What writes the arm, by the suffix of the file."""
