"""Definitions and references across files and formats."""

import json

from navigating import NON_BMP, Model

URDF = f"""<robot name="cart"><!-- {NON_BMP} -->
  <material name="blue"><color rgba="0 0 1 1"/></material>
  <link name="base"><visual><geometry><sphere radius="1"/></geometry><material name="blue"/>
    </visual></link>
  <link name="arm"/>
  <link name="hand"/>
  <joint name="lift" type="prismatic">
    <parent link="base"/><child link="arm"/><limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="turn" type="revolute">
    <parent link="arm"/><child link="hand"/><limit lower="0" upper="1" effort="1" velocity="1"/>
    <mimic joint="lift"/>
  </joint>
  <transmission name="drive"><joint name="turn"/></transmission>
  <gazebo reference="hand"/>
</robot>
"""
SRDF = f"""<robot name="cart"><!-- {NON_BMP} -->
  <group name="whole"><chain base_link="base" tip_link="hand"/></group>
  <group name="part"><joint name="lift"/><link name="arm"/></group>
  <group_state name="home" group="part"><joint name="lift" value="0"/></group_state>
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
"""


def test_a_link_is_found_from_both_its_joints(tmp_path):
    """A parent and a child lead to the link, and the link to them."""
    model = Model(tmp_path, {"cart.urdf": URDF})
    assert model.definitions('cart.urdf: <child link="ar|m"') == ["cart.urdf:5: arm"]
    assert model.definitions('cart.urdf: <parent link="|arm"') == ["cart.urdf:5: arm"]
    assert model.references('cart.urdf: <link name="|arm"/>') == [
        "cart.urdf:8: arm",
        "cart.urdf:11: arm",
    ]


def test_a_description_comes_before_references_if_asked_for(tmp_path):
    model = Model(tmp_path, {"cart.urdf": URDF})
    found = model.references('cart.urdf: <mimic joint="|lift"', described=True)
    assert found == ["cart.urdf:7: lift", "cart.urdf:12: lift"]


def test_transmissions_and_extensions_lead_to_joints_and_links(tmp_path):
    model = Model(tmp_path, {"cart.urdf": URDF})
    assert model.definitions('cart.urdf: "drive"><joint name="tu|rn"') == ["cart.urdf:10: turn"]
    assert model.definitions('cart.urdf: reference="hand|"') == ["cart.urdf:6: hand"]


def test_a_visual_leads_to_the_material_of_the_robot(tmp_path):
    model = Model(tmp_path, {"cart.urdf": URDF})
    assert model.definitions('cart.urdf: <material name="bl|ue"/>') == ["cart.urdf:2: blue"]
    assert model.references('cart.urdf: <material name="bl|ue"><') == ["cart.urdf:3: blue"]


def test_an_srdf_points_into_its_urdf(tmp_path):
    """Links, joints, pairs and the robot itself; a group into the SRDF."""
    model = Model(tmp_path, {"cart.urdf": URDF, "cart.srdf": SRDF})
    assert model.definitions('cart.srdf: tip_link="|hand"') == ["cart.urdf:6: hand"]
    assert model.definitions('cart.srdf: <group name="part"><joint name="li|ft"') == [
        "cart.urdf:7: lift"
    ]
    assert model.definitions('cart.srdf: link2="a|rm"') == ["cart.urdf:5: arm"]
    assert model.definitions('cart.srdf: <robot name="ca|rt"') == ["cart.urdf:1: cart"]
    assert model.definitions('cart.srdf: group="pa|rt"') == ["cart.srdf:3: part"]


def test_references_of_a_joint_are_in_both_files(tmp_path):
    model = Model(tmp_path, {"cart.urdf": URDF, "cart.srdf": SRDF})
    found = model.references('cart.urdf: <joint name="li|ft"')
    assert found == ["cart.urdf:12: lift", "cart.srdf:3: lift", "cart.srdf:4: lift"]


def test_a_name_that_nothing_has_leads_nowhere(tmp_path):
    text = SRDF.replace('link2="arm"', 'link2="amr"')
    model = Model(tmp_path, {"cart.urdf": URDF, "cart.srdf": text})
    assert model.definitions('cart.srdf: link2="a|mr"') == []
    assert "nothing has this name" in model.hover('cart.srdf: link2="a|mr"')


def test_sdf_names_are_looked_up_in_their_scopes(tmp_path):
    """Two models have a link of one name, and each reference leads to its own."""
    text = f"""<sdf version="1.9"><world name="w"><!-- {NON_BMP} -->
  <model name="one"><link name="base"/>
    <frame name="tool" attached_to="base"><pose relative_to="__model__">0 0 1 0 0 0</pose></frame>
    <link name="hand"><pose relative_to="tool">0 0 0 0 0 0</pose></link>
    <joint name="j" type="revolute"><parent>base</parent><child>hand</child>
      <axis><xyz expressed_in="tool">0 0 1</xyz></axis></joint>
  </model>
  <model name="two" canonical_link="base"><link name="base"/></model>
</world></sdf>
"""
    model = Model(tmp_path, {"w.sdf": text})
    assert model.definitions("w.sdf: <parent>ba|se<") == ["w.sdf:2: base"]
    assert model.definitions('w.sdf: attached_to="ba|se"') == ["w.sdf:2: base"]
    assert model.definitions('w.sdf: canonical_link="ba|se"') == ["w.sdf:8: base"]
    assert model.references('w.sdf: <frame name="to|ol"') == ["w.sdf:4: tool", "w.sdf:6: tool"]


def test_an_sdf_leads_into_what_it_includes(tmp_path):
    inner = '<sdf version="1.9"><model name="arm"><link name="base"/></model></sdf>'
    outer = """<sdf version="1.9"><model name="cell"><link name="table"/>
  <include><name>left</name><uri>arm</uri></include>
  <joint name="fix" type="fixed"><parent>table</parent><child>left::base</child></joint>
</model></sdf>"""
    files = {"cell.sdf": outer, "arm/model.sdf": inner}
    model = Model(tmp_path, files, ["cell.sdf"])
    assert model.definitions("cell.sdf: left::|base<") == ["arm/model.sdf:1: base"]
    assert model.definitions("cell.sdf: <uri>a|rm<") == ["arm/model.sdf:1: "]
    assert model.references('arm/model.sdf: <link name="b|ase"/>') == ["cell.sdf:3: left::base"]


CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]


def graph(*nodes):
    return json.dumps({"@context": CONTEXT, "@graph": nodes}, indent=1, ensure_ascii=False)


def test_iris_are_followed_from_file_to_file(tmp_path):
    bodies = graph({"@id": "ex:tip", "@type": "Frame", "http://e.org/note": NON_BMP})
    joints = graph(
        {"@id": "ex:arm", "@type": "RigidBody", "simplices": ["ex:tip"]},
        {"@id": "https://example.org/arm#hand", "@type": "RigidBody", "simplices": ["ex:tip"]},
    )
    model = Model(tmp_path, {"a.jsonld": bodies, "b.jsonld": joints})
    tip = [each for each in model.files["b.jsonld"].splitlines() if "ex:tip" in each]
    assert len(tip) == 2
    found = model.references('a.jsonld: "@id": "ex:|tip"')
    assert [each.partition(":")[0] for each in found] == ["b.jsonld", "b.jsonld"]
    assert model.definitions('a.jsonld: "@id": "ex|:tip"') == ['a.jsonld:10: "ex:tip"']


def test_where_a_node_gets_its_type_comes_first(tmp_path):
    """Both files say something of the node; the second says what it is."""
    more = graph({"@id": "ex:tip", "http://e.org/note": "more"})
    typed = graph({"@id": "ex:tip", "@type": "Frame"})
    model = Model(tmp_path, {"a.jsonld": more, "b.jsonld": typed})
    found = model.definitions('a.jsonld: "@id": "ex:|tip"')
    assert [each.partition(":")[0] for each in found] == ["b.jsonld", "a.jsonld"]


def test_a_node_described_twice_in_a_file_has_two_places(tmp_path):
    text = graph({"@id": "ex:tip", "@type": "Frame"}, {"@id": "ex:tip", "http://e.org/n": "x"})
    model = Model(tmp_path, {"a.jsonld": text})
    spot = model.navigator.definitions(str(tmp_path / "a.jsonld"), text.index("ex:tip"))
    assert [place.start.line for place in spot] == [10, 14]


def test_keys_are_references_of_their_property(tmp_path):
    """A key stands for a property; a context of the file may define it."""
    context = [*CONTEXT, {"note": "https://example.org/arm#note"}]
    nodes = [{"@id": "ex:a", "note": "x"}, {"@id": "ex:b", "note": "y"}]
    text = json.dumps({"@context": context, "@graph": nodes}, indent=1)
    model = Model(tmp_path, {"a.jsonld": text})
    assert model.definitions('a.jsonld: "no|te": "y"') == ['a.jsonld:8: "note"']
    assert len(model.references('a.jsonld: "no|te": "x"')) == 2


def test_units_are_references_across_files(tmp_path):
    node = {"@id": "ex:p", "@type": ["PositionCoordinate", "VectorXYZ"], "unit": "M", "x": 1.0}
    other = {**node, "@id": "ex:q"}
    model = Model(tmp_path, {"a.jsonld": graph(node), "b.jsonld": graph(other)})
    found = model.references('a.jsonld: "unit": "|M"')
    assert [each.partition(":")[0] for each in found] == ["a.jsonld", "b.jsonld"]


def test_turtle_names_are_followed(tmp_path):
    text = """@prefix ex: <https://example.org/arm#> .
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
ex:arm a geom:RigidBody ; geom:simplices ex:tip .
ex:tip a geom:Frame .
"""
    model = Model(tmp_path, {"a.ttl": text})
    assert model.definitions("a.ttl: simplices ex:t|ip") == ["a.ttl:4: ex:tip"]
