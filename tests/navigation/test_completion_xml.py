"""Completion in URDF, SRDF and SDF, in texts that cannot be parsed at the moment."""

from pathlib import Path

import pytest
from completing import Typing
from navigating import NON_BMP

SAMPLES = Path(__file__).parents[2] / "samples"
URDF = f"""<robot name="leg"><!-- {NON_BMP} -->
  <link name="hip"/>
  <link name="shin"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <joint name="knee" type="revolute">
    <parent link="hip"/>
    <child link="shin"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <gazebo reference="shin"><mu1>1</mu1></gazebo>
</robot>
"""
SRDF = """<robot name="leg">
  <virtual_joint name="base" type="fixed" parent_frame="world" child_link="hip"/>
  <group name="all"><joint name="knee"/></group>
  <group_state name="home" group="all"><joint name="knee" value="0"/></group_state>
  <disable_collisions link1="hip" link2="shin" reason="Adjacent"/>
</robot>
"""


@pytest.fixture(scope="module")
def leg(tmp_path_factory):
    return Typing(tmp_path_factory.mktemp("leg"), {"leg.urdf": URDF, "leg.srdf": SRDF})


def test_links_where_a_joint_refers_to_one(leg):
    assert leg.labels('leg.urdf: <parent link="hip"/> => <parent link="|') == ["hip", "shin"]
    assert leg.replaced('leg.urdf: <parent link="hip"/> => <parent link="h|ip"/>') == "hip"
    assert leg.labels('leg.urdf: <parent link="hip"/> => <parent link="|"') == ["hip", "shin"]


def test_a_link_that_was_just_typed_is_known(leg):
    found = leg.labels('leg.urdf: <link name="hip"/> => <link name="foot"/><joint><child link="|')
    assert found == ["foot", "shin"]


def test_links_and_joints_where_either_may_be(leg):
    assert leg.labels('leg.urdf: reference="shin" => reference="|"') == ["hip", "knee", "shin"]


def test_the_name_of_a_link_itself_is_not_completed(leg):
    assert leg.labels('leg.urdf: <link name="hip"/> => <link name="|"/>') == []


def test_children_that_are_missing_come_first(leg):
    found = leg.candidates('leg.urdf: <parent link="hip"/> => <|')
    labels = [each.label for each in found]
    assert labels[0] == "parent"
    assert "limit" not in labels
    assert "mimic" in labels
    assert found[0].snippet == 'parent link="$1"/>$0'


def test_a_tag_that_has_attributes_is_only_renamed(leg):
    found = leg.candidates('leg.urdf: <parent link="hip"/> => <par|ent link="hip"/>')
    assert (found[0].label, found[0].snippet) == ("parent", None)
    assert leg.replaced('leg.urdf: <parent link="hip"/> => <par|ent link="hip"/>') == "parent"


def test_the_root_of_an_empty_file(tmp_path):
    empty = Typing(tmp_path, {"a.urdf": "<robot name='a'/>"})
    assert empty.labels("a.urdf: <robot name='a'/> => <|") == ["robot"]


def test_an_end_tag_closes_what_is_open(leg):
    found = leg.candidates("leg.urdf: </geometry></visual> => </|")
    assert [each.label for each in found] == ["geometry"]
    assert found[0].text == "geometry>"


def test_attributes_that_are_missing(leg):
    found = leg.candidates('leg.urdf: <link name="hip"/> => <joint |')
    assert [each.label for each in found][:2] == ["name", "type"]
    assert found[0].detail == "text, required"
    found = leg.labels('leg.urdf: <limit lower="-1" upper="1" => <limit lower="-1" | upper="1"')
    assert "upper" not in found
    assert "acceleration" in found


def test_words(leg):
    found = leg.labels('leg.urdf: type="revolute" => type="|')
    assert found[:2] == ["revolute", "continuous"]


def test_codes_of_rules_where_they_are_ignored(leg):
    found = leg.candidates('leg.urdf: <link name="hip"/> => <!-- kinlint: ignore[LIM|] --><link/>')
    assert "LIM001" in {each.label for each in found}
    assert all(each.detail for each in found)
    found = leg.labels('leg.urdf: <link name="hip"/> => <!-- kin| --><link/>')
    assert found == ["kinlint: file-ignore[]", "kinlint: ignore[]"]


@pytest.mark.slow
def test_an_srdf_speaks_of_links_joints_and_groups(leg):
    assert leg.labels('leg.srdf: child_link="hip" => child_link="|') == ["hip", "shin"]
    found = leg.labels('leg.srdf: <group name="all"><joint name="knee"/> => <group><joint name="|')
    assert found == ["base", "knee"]
    assert leg.labels('leg.srdf: group="all" => group="|') == ["all"]
    assert leg.labels('leg.srdf: reason="Adjacent" => reason="|"')[0] == "Adjacent"
    assert leg.labels('leg.srdf: link1="hip" => link1="|') == ["hip", "shin"]


WORLD = """<sdf version="1.9">
  <world name="hall">
    <include><name>crate</name><uri>box.sdf</uri></include>
    <model name="arm">
      <link name="base"/>
      <model name="hand"><link name="palm"/></model>
      <joint name="wrist" type="fixed"><parent>base</parent><child>hand::palm</child></joint>
    </model>
    <frame name="table" attached_to="arm"/>
  </world>
</sdf>
"""
BOX = """<sdf version="1.9">
  <model name="box"><static>true</static><link name="side"><pose relative_to="__model__"/>
  </link></model>
</sdf>
"""


@pytest.fixture(scope="module")
def hall(tmp_path_factory):
    files = {"hall.world": WORLD, "box.sdf": BOX}
    return Typing(tmp_path_factory.mktemp("hall"), files)


@pytest.mark.slow
def test_names_of_the_scope_in_sdf(hall):
    found = hall.labels("hall.world: <parent>base</parent> => <parent>|</parent>")
    assert found == ["base", "hand", "wrist", "hand::palm", "world"]
    assert hall.replaced("hall.world: <parent>base</parent> => <parent>ba|se</parent>") == "base"
    found = hall.labels('hall.world: attached_to="arm" => attached_to="|')
    assert found[:2] == ["arm", "crate"]
    assert "table" not in found
    assert "crate::side" in found
    assert "arm::hand::palm" in found
    assert "palm" not in found


def test_words_and_truth_values_in_sdf(hall):
    assert hall.labels("box.sdf: <static>true => <static>|") == ["false", "true"]
    assert hall.labels('hall.world: type="fixed" => type="|"')[0] == "revolute"
    assert "collision" in hall.labels('box.sdf: <link name="side"> => <link name="side"><|')


@pytest.mark.slow
def test_packages_and_files(tmp_path):
    files = {
        "parts/package.xml": "<package><name>parts</name></package>",
        "parts/meshes/hip.stl": "",
        "parts/urdf/leg.urdf": URDF.replace('<box size="1 1 1"/>', '<mesh filename="a.stl"/>'),
    }
    typing = Typing(tmp_path, files, ["parts/urdf/leg.urdf"])
    where = 'parts/urdf/leg.urdf: filename="a.stl" => filename='
    assert "package://" in typing.labels(f'{where}"|"')
    assert typing.labels(f'{where}"package://|"') == ["package://parts/"]
    assert typing.labels(f'{where}"package://parts/m|') == [
        "package://parts/meshes/",
        "package://parts/urdf/",
    ]
    assert typing.labels(f'{where}"package://parts/meshes/|') == ["package://parts/meshes/hip.stl"]


MJCF = """<mujoco model="walker">
  <default><default class="leg"><geom size="0.05"/></default></default>
  <worldbody>
    <body name="torso">
      <freejoint name="root"/>
      <body name="shin"><joint name="knee"/><geom name="bone" class="leg"/><site name="toe"/></body>
    </body>
  </worldbody>
  <actuator><motor name="pull" joint="knee"/></actuator>
</mujoco>
"""


def test_names_of_mjcf_wherever_they_stand(tmp_path):
    """By the kinds that are meant; classes have their names in another attribute."""
    walker = Typing(tmp_path, {"walker.xml": MJCF})
    assert walker.labels('walker.xml: joint="knee" => joint="|') == ["knee", "root"]
    assert walker.labels('walker.xml: joint="knee" => site="|') == ["toe"]
    assert walker.labels('walker.xml: name="bone" class="leg" => name="bone" class="|') == ["leg"]
    sucker = walker.labels('walker.xml: motor name="pull" joint="knee" => adhesion body="|')
    assert sucker == ["shin", "torso"]


def test_identifiers_in_collada(tmp_path):
    """Of the elements that the address may lead to."""
    text = (SAMPLES / "broken" / "kinematics-not-instanced.dae").read_text("utf-8")
    scene = Typing(tmp_path, {"a.dae": text})
    model = 'a.dae: <instance_kinematics_model url="#arm" => <instance_kinematics_model url="|'
    assert scene.labels(model) == ["#arm"]
    visual = 'a.dae: <instance_visual_scene url="#drawn" => <instance_visual_scene url="|'
    assert scene.labels(visual) == ["#drawn"]
