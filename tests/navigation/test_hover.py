"""What is shown about a place."""

import json

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


def test_a_finding_shows_the_page_of_its_rule_first(tmp_path):
    model = Model(tmp_path, {"a.jsonld": graph(ELBOW, LIMIT)})
    finding = next(f for f in model.examination.report.findings if f.rule.code == "LIM001")
    at = finding.location.span.start
    shown = model.navigator.hover(finding.location.source.name, at)
    assert shown is not None
    assert shown.markdown.startswith(f"**error**: {finding.message}")
    assert "# LIM001" in shown.markdown
    assert "For one run" in shown.markdown or "--ignore LIM001" in shown.markdown


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
    assert "`PrismaticJoint`" in shown
    assert "joins: `arm`, `base`" in shown
    assert "JointPositionLimit: lower 0 m, upper -1.5 m" in shown


def test_a_link_shows_its_mass_even_where_it_is_referred_to(tmp_path):
    shown = Model(tmp_path, {"cart.urdf": URDF}).hover('cart.urdf: child link="a|rm"')
    assert "`RigidBody`" in shown
    assert "mass 2 kg" in shown
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
    assert "# SRC019" in found.markdown


def test_a_number_in_a_list_shows_who_has_the_list(tmp_path):
    """Cells of lists are nobody's business, however long the list."""
    chain = {"@id": "ex:c", "@type": "RigidBodyInertiaCoordinate", "http://e.org/l": {"@list": []}}
    chain["http://e.org/l"]["@list"] = [float(i) for i in range(2000)]
    model = Model(tmp_path, {"a.jsonld": graph(chain)})
    assert model.hover("a.jsonld: 19|99.0").startswith("**ex:c**")
    assert model.hover("a.jsonld: 19|98.0").startswith("**ex:c**")
