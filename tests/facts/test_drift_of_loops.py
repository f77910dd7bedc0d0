"""Joints that close loops are joints, whichever of a loop a file has for that."""

import pytest
from compared import comparison

BODIES = {
    "ground": ((0, 0, 0), (0.2, 0, 0)),
    "crank": ((0, 0, 0), (0, 0, 0.15)),
    "rocker": ((0.4, 0, 0), (0, 0, 0.15)),
    "coupler": ((0, 0, 0.3), (0.2, 0, 0)),
}
"""Place and centre of mass of each bar."""
JOINTS = {
    "a": ("ground", "crank", (0, 0, 0), (0, 0, 0)),
    "b": ("crank", "coupler", (0, 0, 0.3), (0, 0, 0)),
    "c": ("ground", "rocker", (0.4, 0, 0), (0, 0, 0)),
    "d": ("rocker", "coupler", (0, 0, 0.3), (0.4, 0, 0)),
}
"""Bars of each joint, and its place on both."""
MJCF = """<mujoco model="bars"><compiler angle="radian"/><worldbody><body name="ground">
  <inertial pos=".2 0 0" mass="1" diaginertia=".003 .003 .003"/>
  <body name="crank"><joint name="a" axis="0 1 0" range="-1 1"/>
    <inertial pos="0 0 .15" mass="1" diaginertia=".003 .003 .003"/>
    <body name="coupler" pos="0 0 .3"><joint name="b" axis="0 1 0" range="-1 1"/>
      <inertial pos=".2 0 0" mass="1" diaginertia=".003 .003 .003"/></body></body>
  <body name="rocker" pos=".4 0 0"><joint name="c" axis="0 1 0" range="-1 1"/>
    <inertial pos="0 0 .15" mass="1" diaginertia=".003 .003 .003"/></body></body></worldbody>
  <equality><connect name="d" body1="rocker" body2="coupler" anchor="0 0 .3"/></equality>
</mujoco>"""


def spaced(numbers):
    return " ".join(map(str, numbers))


def sdf(order="abcd", kind="revolute"):
    """Return a four-bar linkage with joints in this *order*, the last one of this *kind*."""
    moments = "".join(f"<i{axis}>0.003</i{axis}>" for axis in ("xx", "yy", "zz"))
    text = '<sdf version="1.9"><model name="bars">'
    for name, (place, centre) in BODIES.items():
        text += f"""<link name="{name}"><pose>{spaced(place)} 0 0 0</pose><inertial>
  <pose>{spaced(centre)} 0 0 0</pose><mass>1</mass><inertia>{moments}</inertia></inertial></link>
"""
    for name in order:
        parent, child, _, place = JOINTS[name]
        text += f"""<joint name="{name}" type="{kind if name == "d" else "revolute"}">
  <pose>{spaced(place)} 0 0 0</pose><parent>{parent}</parent><child>{child}</child>
  <axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis></joint>
"""
    return f"{text}</model></sdf>"


def usd(order="abcd"):
    """Return the same linkage with joints in this *order*; the reader chooses what closes it."""
    text = '#usda 1.0\n( defaultPrim = "bars"\n metersPerUnit = 1\n upAxis = "Z" )\n'
    text += 'def Xform "bars" (prepend apiSchemas = ["PhysicsArticulationRootAPI"])\n{\n'
    for name, (place, centre) in BODIES.items():
        text += f"""def Xform "{name}" (
    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"])
{{
    double3 xformOp:translate = {place}
    uniform token[] xformOpOrder = ["xformOp:translate"]
    float physics:mass = 1
    point3f physics:centerOfMass = {centre}
    float3 physics:diagonalInertia = (0.003, 0.003, 0.003)
}}
"""
    for name in order:
        parent, child, place, far = JOINTS[name]
        text += f"""def PhysicsRevoluteJoint "{name}"
{{
    rel physics:body0 = </bars/{parent}>
    rel physics:body1 = </bars/{child}>
    uniform token physics:axis = "Y"
    point3f physics:localPos0 = {place}
    point3f physics:localPos1 = {far}
    float physics:lowerLimit = -57.29577951308232
    float physics:upperLimit = 57.29577951308232
}}
"""
    return text + "}\n"


def told(old, new):
    """Return what differs, and the joints that only one has, of two names with texts."""
    found = comparison(old[1], new[1], (old[0], new[0]))
    differences = [(each.quantity, each.part) for each in found.differences]
    return differences, [[joint.name for joint in each] for each in found.alone()]


@pytest.mark.parametrize(
    "other",
    [("b.sdf", sdf("dcba")), ("b.usda", usd()), ("b.usda", usd("dcba")), ("b.xml", MJCF)],
    ids=["SDF", "USD", "USD from its end", "MJCF"],
)
def test_a_loop_is_the_same_wherever_it_is_closed(other):
    """MJCF closes it at a point: the axis is not told there."""
    assert told(("a.sdf", sdf()), other) == ([], [[], []])


def test_a_loop_that_is_open_is_told():
    """Its last joint is gone."""
    assert told(("a.sdf", sdf()), ("b.sdf", sdf("abc"))) == ([], [["d"], []])


def test_a_loop_that_is_closed_otherwise_is_told():
    """At another place, or by another kind of joint."""
    moved = sdf().replace(
        "<pose>0.4 0 0 0 0 0</pose><parent>", "<pose>0.3 0 0 0 0 0</pose><parent>"
    )
    assert told(("a.sdf", sdf()), ("b.sdf", moved))[0] == [("place of the axis", "d")]
    assert told(("a.sdf", sdf()), ("b.sdf", sdf(kind="ball")))[0] == [("movement", "d")]
    nearer = MJCF.replace('anchor="0 0 .3"', 'anchor="0 0 .2"')
    assert told(("a.xml", MJCF), ("b.xml", nearer))[0] == [("place of the centre", "d")]
