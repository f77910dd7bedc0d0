"""One arm in three formats makes programs of the same numbers, in metres or centimetres."""

from __future__ import annotations

import pytest
from programs import module, program

pytest.importorskip("jinja2")
np = pytest.importorskip("numpy")
pytestmark = [pytest.mark.slow]

INERTIAL = """<inertial><origin xyz="0 0 0.15"/><mass value="1.5"/>
<inertia ixx="0.0135" iyy="0.0125" izz="0.0017" ixy="0" ixz="0" iyz="0"/></inertial>"""
URDF = f"""<robot name="arm">
<link name="base"/>
<link name="upper">{INERTIAL}</link>
<link name="rod">{INERTIAL}</link>
<joint name="turn" type="revolute">
  <parent link="base"/><child link="upper"/>
  <origin xyz="0.1 0 0.2" rpy="0 0 1.8545904360032244"/><axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/>
</joint>
<joint name="slide" type="prismatic">
  <parent link="upper"/><child link="rod"/>
  <origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
  <limit lower="0" upper="0.2" effort="1" velocity="1"/>
</joint>
</robot>"""
BODY = 'prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]'
MASS = """float physics:mass = 1500
    point3f physics:centerOfMass = (0, 0, 15)
    float3 physics:diagonalInertia = (135000, 125000, 17000)
    quatf physics:principalAxes = (1, 0, 0, 0)"""
USD = f"""#usda 1.0
(
    defaultPrim = "arm"
    kilogramsPerUnit = 0.001
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Xform "arm" (prepend apiSchemas = ["PhysicsArticulationRootAPI"])
{{
  def Xform "base" ({BODY})
  {{
    {MASS}
  }}
  def Xform "upper" ({BODY})
  {{
    {MASS}
    double3 xformOp:translate = (10, 0, 20)
    quatd xformOp:orient = (0.6, 0, 0, 0.8)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
  }}
  def Xform "rod" ({BODY})
  {{
    {MASS}
    double3 xformOp:translate = (10, 0, 60)
    quatd xformOp:orient = (0.6, 0, 0, 0.8)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
  }}
  def PhysicsRevoluteJoint "turn"
  {{
    uniform token physics:axis = "Y"
    rel physics:body0 = </arm/base>
    rel physics:body1 = </arm/upper>
    point3f physics:localPos0 = (10, 0, 20)
    quatf physics:localRot0 = (0.6, 0, 0, 0.8)
  }}
  def PhysicsPrismaticJoint "slide"
  {{
    uniform token physics:axis = "Z"
    rel physics:body0 = </arm/upper>
    rel physics:body1 = </arm/rod>
    point3f physics:localPos0 = (0, 0, 30)
    point3f physics:localPos1 = (0, 0, -10)
  }}
}}
"""
COLLADA = """<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_joints>
  <joint id="turn" name="turn"><revolute sid="axis0"><axis>0 3 0</axis></revolute></joint>
  <joint id="slide" name="slide"><prismatic sid="axis0"><axis>0 0 1</axis></prismatic></joint>
</library_joints>
<library_kinematics_models><kinematics_model id="arm"><technique_common>
  <instance_joint url="#turn" sid="turn"/>
  <instance_joint url="#slide" sid="slide"/>
  <link sid="base" name="base">
    <attachment_full joint="arm/turn">
      <translate>10 0 20</translate>
      <rotate>0 0 1 106.26020470831196</rotate>
      <link sid="upper" name="upper">
        <attachment_full joint="arm/slide">
          <translate>0 0 40</translate>
          <link sid="rod" name="rod"/>
        </attachment_full>
      </link>
    </attachment_full>
  </link>
</technique_common></kinematics_model></library_kinematics_models>
</COLLADA>"""


@pytest.mark.parametrize(("name", "text"), [("arm.usda", USD), ("arm.dae", COLLADA)])
def test_moves_as_the_same_arm_in_urdf(tmp_path_factory, name, text):
    kept = tmp_path_factory.getbasetemp() / "rules"
    made = [
        program({n: t}, "numpy", kept, general=False) for n, t in ((name, text), ("a.urdf", URDF))
    ]
    assert [errors for errors, _ in made] == [[], []]
    ours, theirs = (module(files["robot.py"]) for _, files in made)
    assert [each.rpartition("/")[2] for each in ours.POSITIONS] == list(theirs.POSITIONS)
    for q, v, a in np.random.default_rng(24).uniform(-3.0, 3.0, (20, 3, 2)):
        for function, state in (("forward_position", (q,)), ("forward_velocity", (q, v))):
            found = getattr(ours, function)(*state)
            for link, number in getattr(theirs, function)(*state).items():
                (own,) = (each for key, each in found.items() if key.rpartition("/")[2] == link)
                assert own == pytest.approx(number, abs=1e-9)
        if name.endswith(".usda"):
            forces = theirs.inverse_dynamics(q, v, a)
            assert ours.inverse_dynamics(q, v, a) == pytest.approx(forces, abs=1e-9)
