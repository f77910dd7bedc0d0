"""What is shown about a place."""

import json
from pathlib import Path

from navigating import NON_BMP, Model

CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]
LIMIT = {
    "@id": "ex:limit",
    "@type": "JointPositionLimit",
    "of-joint": "ex:elbow",
    "quantity-kind": "Angle",
    "unit": "DEG",
    "lower": 90.0,
    "upper": -90.0,
}
ELBOW = {"@id": "ex:elbow", "@type": ["Joint", "RevoluteJoint"], "http://e.org/note": NON_BMP}
URDF = """<robot name="cart">
  <link name="base"/>
  <link name="arm">
    <inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <joint name="lift" type="prismatic">
    <parent link="base"/><child link="arm"/><limit lower="0" upper="-1.5" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def graph(*nodes, **more):
    return json.dumps({"@context": CONTEXT, "@graph": nodes, **more}, indent=1, ensure_ascii=False)


def test_a_node_shows_types_unit_kind_and_values_in_si(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, LIMIT)})
    shown = model.hover('a.jsonld: "ex:lim|it"')
    assert shown.startswith("**ex:limit**: `JointPositionLimit`")
    assert "- unit: `DEG`" in shown
    assert "- quantity kind: `Angle`" in shown
    assert "90 ° = 1.5708 rad" in shown


def test_a_number_shows_whom_it_is_of(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, {**LIMIT, "upper": 120.0})})
    assert "**ex:limit**" in model.hover('a.jsonld: "lower": 9|0')
    assert model.hovered('a.jsonld: "lower": 9|0') == "90.0"


def test_a_finding_shows_its_message_and_a_link_first(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, LIMIT)})
    finding = next(f for f in model.examination.report.findings if f.rule.code == "LIM001")
    at = finding.location.span.start
    shown = model.navigator.hover(finding.location.source.name, at)
    assert shown is not None
    assert shown.markdown.startswith(f"**error**: {finding.message}")
    first = shown.markdown.split("\n\n---\n\n")[0]
    assert "[LIM001](https://" in first
    assert len(first.splitlines()) <= 3
    assert "# LIM001" not in shown.markdown


def test_an_ignore_entry_shows_the_rule_that_it_silences(tmp_path):
    ignore = {"kl:rule": "LIM001", "kl:reason": "set at run time"}
    context = [*CONTEXT, {"kl": "https://w3id.org/kinlint/ns#"}]
    nodes = [ELBOW, {**LIMIT, "kl:ignore": ignore}]
    text = json.dumps({"@context": context, "@graph": nodes}, indent=1)
    shown = Model(tmp_path, {"a.jsonld": text}).hover('a.jsonld: "LIM|001"')
    assert shown.startswith("Ignored here: set at run time")
    assert "# LIM001" in shown


def test_a_comment_that_ignores_shows_the_rule(tmp_path):
    text = URDF.replace("    <parent", "    <!-- kinlint: ignore[LIM001] later -->\n    <parent", 1)
    model = Model(tmp_path, {"cart.urdf": text})
    assert "# LIM001" in model.hover("cart.urdf: ignore[LI|M001]")


def test_an_entry_that_names_no_rule_says_so(tmp_path):
    context = [*CONTEXT, {"kl": "https://w3id.org/kinlint/ns#"}]
    nodes = [{**ELBOW, "kl:ignore": "LIM999"}]
    text = json.dumps({"@context": context, "@graph": nodes}, indent=1)
    shown = Model(tmp_path, {"a.jsonld": text}).hover('a.jsonld: "LIM|999"')
    assert "names no rule" in shown


def test_a_joint_of_a_urdf_shows_what_it_joins_and_its_limits(tmp_path):
    shown = Model(tmp_path, {"cart.urdf": URDF}).hover('cart.urdf: <joint name="li|ft"')
    assert "**joint lift**: prismatic along x, 0 to -1.5 m, moves arm on base" in shown
    assert "Joint`" not in shown


def test_a_link_shows_its_mass_even_where_it_is_referred_to(tmp_path):
    shown = Model(tmp_path, {"cart.urdf": URDF}).hover('cart.urdf: child link="a|rm"')
    assert "**link arm**: 2 kg" in shown
    assert "`RigidBody`" not in shown
    assert "Described at" in shown


def test_an_element_shows_what_was_made_of_it(tmp_path):
    shown = Model(tmp_path, {"cart.urdf": URDF}).hover('cart.urdf: <limit low|er="0"')
    assert "`JointPositionLimit`" in shown
    assert "- unit: `M`" in shown


def test_coordinates_show_the_frames_of_their_relation(tmp_path):
    relation = {"@id": "ex:p", "@type": "Position", "of": "ex:tip", "with-respect-to": "ex:root"}
    coordinates = {
        "@id": "ex:c",
        "@type": ["PositionReference", "PositionCoordinate", "VectorXYZ"],
        "of-position": "ex:p",
        "as-seen-by": "ex:frame",
        "unit": "CentiM",
        "x": 5.0,
        "y": 0.0,
        "z": 0.0,
    }
    model = Model(tmp_path, {"a.jsonld": graph(relation, coordinates)})
    shown = model.hover('a.jsonld: "@id": "ex:|c"')
    assert "- as seen by: `ex:frame`" in shown
    assert "- of: `ex:tip`" in shown
    assert "- with respect to: `ex:root`" in shown
    assert "- x: 5 cm = 0.05 m" in shown


def test_units_and_kinds_are_explained(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, LIMIT)})
    shown = model.hover('a.jsonld: "unit": "D|EG"')
    assert shown.startswith("**DEG**: unit")
    assert "1 ° = 0.0174532925199 rad" in shown
    assert "units: " in model.hover('a.jsonld: "quantity-kind": "An|gle"')


def test_classes_and_properties_are_explained(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, {**LIMIT, "upper": 120.0})})
    assert model.hover('a.jsonld: "RevoluteJo|int"').startswith("**RevoluteJoint**: class")
    assert model.hover('a.jsonld: "of-jo|int"').startswith("**of-joint**: property")


def test_an_iri_that_nobody_describes_is_told(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(LIMIT)})
    assert "described nowhere" in model.hover('a.jsonld: "ex:elb|ow"')


def test_nothing_is_shown_where_nothing_is_said(tmp_path):
    """Behind the last node, and in a file that is not in the model."""
    text = graph(ELBOW) + "\n\n\n"
    model = Model(tmp_path, {"a.jsonld": text})
    assert model.navigator.hover(str(tmp_path / "a.jsonld"), len(text)) is None
    assert model.navigator.hover(str(tmp_path / "elsewhere.jsonld"), 0) is None


def test_an_empty_file_shows_what_is_wrong_with_it(tmp_path):
    model = Model(tmp_path, {"e.urdf": ""})
    found = model.navigator.hover(str(tmp_path / "e.urdf"), 0)
    assert found is not None
    assert "[SRC019](https://" in found.markdown


def test_a_number_in_a_list_shows_who_has_the_list(tmp_path):
    """Cells of lists are nobody's business, however long the list."""
    chain = {"@id": "ex:c", "@type": "RigidBodyInertiaCoordinate", "http://e.org/l": {"@list": []}}
    chain["http://e.org/l"]["@list"] = [float(i) for i in range(2000)]
    model = Model(tmp_path, {"a.jsonld": graph(chain)})
    assert model.hover("a.jsonld: 19|99.0").startswith("**ex:c**")
    assert model.hover("a.jsonld: 19|98.0").startswith("**ex:c**")


ARM = """<robot name="arm">
  <link name="base"/>
  <link name="forearm">
    <inertial>
      <origin xyz="0 0 0.1"/><mass value="1"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="forearm"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def test_a_link_in_a_sentence(tmp_path):
    model = Model(tmp_path, {"arm.urdf": ARM})
    told = "**link forearm**: 1 kg, centre (0, 0, 0.1) m, moved by elbow about y, -114.6 to 114.6°"
    assert model.hover('arm.urdf: <link name="fore|arm"').startswith(told)
    assert model.hover('arm.urdf: <child link="fore|arm"').startswith(told)
    assert model.hover('arm.urdf: <link name="ba|se"').startswith(
        "**link base**: root, carries elbow"
    )


def test_a_joint_in_a_sentence(tmp_path):
    model = Model(tmp_path, {"arm.urdf": ARM})
    told = "**joint elbow**: revolute about y, -114.6 to 114.6°, moves forearm on base"
    assert model.hover('arm.urdf: <joint name="elb|ow"').startswith(told)
    shown = Model(tmp_path, {"cart.urdf": URDF}).hover('cart.urdf: <joint name="li|ft"')
    assert "**joint lift**: prismatic" in shown
    assert "0 to -1.5 m, moves arm on base" in shown


def test_the_meaning_of_elements_and_attributes(tmp_path):
    model = Model(tmp_path, {"arm.urdf": ARM})
    shown = model.hover("arm.urdf: <li|mit")
    assert "`<limit>` Bounds of the position, the velocity and the effort" in shown
    shown = model.hover('arm.urdf: <limit low|er="-2"')
    assert "`lower` least position in rad, of prismatic joints in m" in shown
    shown = model.hover('arm.urdf: upper="|2"')
    assert "`upper` greatest position" in shown


def test_what_an_element_is_a_part_of_in_a_sentence(tmp_path):
    """Above what is stated of it; a robot is no part."""
    model = Model(tmp_path, {"arm.urdf": ARM})
    joint = "**joint elbow**: revolute about y, -114.6 to 114.6°, moves forearm on base"
    for place in ("<ax|is", 'lower="-|2"', 'type="revo|lute"'):
        assert model.hover(f"arm.urdf: {place}").startswith(joint)
    assert model.hover("arm.urdf: <iner|tial").startswith("**link forearm**: 1 kg")
    assert not model.hover("arm.urdf: <ro|bot").startswith("**link")


def test_an_axis_has_no_unit(tmp_path):
    shown = Model(tmp_path, {"arm.urdf": ARM}).hover("arm.urdf: <ax|is")
    assert "Direction of the axis" in shown
    assert "- y: 1\n" in f"{shown}\n"
    assert "0 1" not in shown


XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="a" value="0.5"/>
  <xacro:property name="b" value="${a * 4 + sin(0)}"/>
  <xacro:macro name="m" params="n y">
    <link name="${n}"><visual><geometry><sphere radius="${b * y}"/></geometry></visual></link>
  </xacro:macro>
  <xacro:m n="one" y="1"/><xacro:m n="two" y="2"/>
</robot>
"""


def test_the_values_of_xacro(tmp_path):
    model = Model(tmp_path, {"r.xacro": XACRO})
    assert "**b** = 2" in model.hover('r.xacro: name="|b"')
    shown = model.hover("r.xacro: ${|b * y}")
    assert "value 2" in shown
    assert "value 4" in shown
    assert "**b** = 2" in shown


SDF = """<sdf version="1.9"><model name="m">
  <link name="a"/><link name="b"><inertial><mass>2</mass></inertial></link>
  <joint name="j" type="prismatic"><parent>a</parent><child>b</child>
    <axis><xyz>0 0 -1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>
  </joint>
</model></sdf>
"""


def test_sdf_and_srdf(tmp_path):
    model = Model(tmp_path, {"m.sdf": SDF})
    shown = model.hover("m.sdf: <child>|b")
    assert "moved by j along -z, -1 to 1 m" in shown
    assert "`<child>` The frame that the joint moves" in shown
    assert "Least position in rad" in model.hover("m.sdf: <lower>-|1")
    srdf = '<robot name="arm"><group name="all"><link name="forearm"/></group></robot>'
    model = Model(tmp_path, {"arm.urdf": ARM, "arm.srdf": srdf})
    shown = model.hover('arm.srdf: <link name="fore|arm"')
    assert shown.startswith("**link forearm**: 1 kg")
    assert "A link of the group" in shown


def test_parts_of_json_ld_in_a_sentence(tmp_path):
    folder = Path(__file__).parents[2] / "samples" / "one-dof"
    files = {each.name: each.read_text("utf-8") for each in sorted(folder.glob("*.jsonld"))}
    model = Model(tmp_path, files)
    text = files["chain.jsonld"]
    at = text.index('"rob:joint1"') + 3
    shown = model.navigator.hover(str(tmp_path / "chain.jsonld"), at)
    assert shown is not None
    told = "**joint joint1**: revolute about z, moves link2 on link1"
    assert shown.markdown.startswith(told)
