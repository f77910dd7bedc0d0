"""What tags, attributes and text state."""

from __future__ import annotations

import pytest
from reading_xml import graph, model, remarks, short

ARM = """\
<robot name="arm" version="1.2">
  <link name="base &amp; foot">
    <inertial>
      <origin xyz="0 0 1.50" rpy="0 -.5\t1e-3"/>
      <mass value=" 2.0 "/>
    </inertial>
    <visual><geometry><mesh filename="a.stl"/></geometry></visual>
    <visual><geometry/></visual>
    <visual name="hat"/>
  </link>
  <link name="base &amp; foot"/>
  <transmission name="t">
    <actuator><mechanicalReduction> 50 </mechanicalReduction></actuator>
  </transmission>
  <gazebo reference="base"><mu1 u="1">0.2</mu1><drake:x drake:y="2"/></gazebo>
</robot>
"""


def test_elements_attributes_and_text_are_stated() -> None:
    link, twin = "#/link/base%20%26%20foot", "#/link/base%20%26%20foot;2"
    reduction = "#/transmission/t/actuator/mechanicalReduction"
    assert graph(model(ARM)) == [
        ("", "robot", "#"),
        ("#", "@name", "arm"),
        ("#", "@version", "1.2"),
        ("#", "link", link),
        (link, "@name", "base & foot"),
        (link, "inertial", f"{link}/inertial"),
        (f"{link}/inertial", "origin", f"{link}/inertial/origin"),
        (f"{link}/inertial/origin", "@xyz-1", "0"),
        (f"{link}/inertial/origin", "@xyz-2", "0"),
        (f"{link}/inertial/origin", "@xyz-3", "1.50"),
        (f"{link}/inertial/origin", "@rpy-1", "0"),
        (f"{link}/inertial/origin", "@rpy-2", "-.5"),
        (f"{link}/inertial/origin", "@rpy-3", "1e-3"),
        (f"{link}/inertial", "mass", f"{link}/inertial/mass"),
        (f"{link}/inertial/mass", "@value", "2.0"),
        (link, "visual", f"{link}/visual"),
        (f"{link}/visual", "geometry", f"{link}/visual/geometry"),
        (f"{link}/visual/geometry", "mesh", f"{link}/visual/geometry/mesh"),
        (f"{link}/visual/geometry/mesh", "@filename", "a.stl"),
        (link, "visual", f"{link}/visual;2"),
        (f"{link}/visual;2", "src:order", "2"),
        (f"{link}/visual;2", "geometry", f"{link}/visual;2/geometry"),
        (link, "visual", f"{link}/visual/hat"),
        (f"{link}/visual/hat", "@name", "hat"),
        ("#", "link", twin),
        (twin, "@name", "base & foot"),
        ("#", "transmission", "#/transmission/t"),
        ("#/transmission/t", "@name", "t"),
        ("#/transmission/t", "actuator", "#/transmission/t/actuator"),
        ("#/transmission/t/actuator", "mechanicalReduction", reduction),
        (reduction, "src:text", "50"),
        ("#", "gazebo", "#/gazebo"),
        ("#/gazebo", "@reference", "base"),
        ("#/gazebo", "mu1", "#/gazebo/mu1"),
        ("#/gazebo/mu1", "@u", "1"),
        ("#/gazebo/mu1", "src:text", "0.2"),
        ("#/gazebo", "ext:drake:x", "#/gazebo/drake:x"),
        ("#/gazebo/drake:x", "@drake:y", "2"),
        ("#/gazebo", "ref:reference", "#/link/base"),
        ("#/gazebo", "src:dangling", "#/gazebo;reference"),
        ("#/gazebo;reference", "src:property", "@reference"),
        ("#/gazebo;reference", "src:written", "base"),
        ("#/gazebo;reference", "src:tag", "link"),
        ("#/gazebo;reference", "src:target", "#/link/base"),
    ]


def test_numbers_are_typed_and_keep_their_spelling() -> None:
    stated = model(ARM).statements
    assert any(o == '"1.50"^^<http://www.w3.org/2001/XMLSchema#double>' for _, _, o in stated)


def test_a_node_is_shown_by_its_name_or_else_by_its_tag() -> None:
    arm = model(ARM)
    shown = [
        arm.source[arm.map.nodes[o].best]
        for _, p, o in arm.statements
        if short(arm, p) in ("link", "visual", "inertial")
    ]
    assert shown == ["base &amp; foot", "inertial", "visual", "visual", "hat", "base &amp; foot"]


def test_an_unnamed_element_and_a_name_never_share_an_address() -> None:
    text = '<robot name="r"><link><inertial/></link><link name="inertial"/></robot>'
    nodes = [o for _, p, o in graph(model(text)) if p in ("link", "inertial")]
    assert nodes == ["#/link", "#/link/inertial", "#/link/inertial;2"]


@pytest.mark.parametrize(
    ("inside", "kind", "place", "details"),
    [
        (
            "<link name='a'><colision/></link>",
            "UndeclaredElement",
            "colision",
            {"tag": "colision", "parentTag": "link", "resembles": "collision"},
        ),
        ("<zzz/>", "UndeclaredElement", "zzz", {"tag": "zzz", "parentTag": "robot"}),
        (
            "<link name='a'><collision><geometry/><material name='m'/></collision></link>",
            "MisplacedElement",
            "material",
            {"tag": "material", "parentTag": "collision", "elsewhere": "robot or visual"},
        ),
        (
            "<link name='a' nme='b'/>",
            "UndeclaredAttribute",
            "nme",
            {"attribute": "nme", "tag": "link"},
        ),
        (
            "<material name='a'><color rgb='1 1 1 1'/></material>",
            "UndeclaredAttribute",
            "rgb",
            {"attribute": "rgb", "tag": "color", "resembles": "rgba"},
        ),
        (
            "<link name='a'><inertial><mass value='1,5'/></inertial></link>",
            "MalformedValue",
            "1,5",
            {
                "attribute": "value",
                "tag": "mass",
                "written": "1,5",
                "expected": "number",
                "reason": "decimal comma in 1,5",
            },
        ),
        (
            "<joint name='a' type='fixed'><axis xyz=' 1 0'/></joint>",
            "MalformedValue",
            " 1 0",
            {
                "attribute": "xyz",
                "tag": "axis",
                "written": " 1 0",
                "expected": "3 numbers",
                "reason": "2 numbers",
            },
        ),
        (
            "<transmission><joint><mechanicalReduction>one</mechanicalReduction></joint></transmission>",
            "MalformedValue",
            "one",
            {
                "tag": "mechanicalReduction",
                "written": "one",
                "expected": "number",
                "reason": "'one' is not a number",
            },
        ),
        (
            "<joint name='a' type='fixed'><axis xyz='nan 0 0'/></joint>",
            "MalformedValue",
            "nan 0 0",
            {
                "attribute": "xyz",
                "tag": "axis",
                "written": "nan 0 0",
                "expected": "3 numbers",
                "reason": "'nan' is not a number",
            },
        ),
        (
            "<joint name='a' type='fixed'><axis xyz='${x} 0 0'/></joint>",
            "Unexpanded",
            "${x} 0 0",
            {"written": "${x} 0 0"},
        ),
        ("<link name='$(arg n)'/>", "Unexpanded", "$(arg n)", {"written": "$(arg n)"}),
        ("<gazebo><x>$(find p)</x></gazebo>", "Unexpanded", "$(find p)", {"written": "$(find p)"}),
        (
            "<xacro:arm xmlns:xacro='x'/>",
            "Unexpanded",
            "xacro:arm",
            {"written": "<xacro:arm>"},
        ),
        ("<link/>", "MissingAttribute", "link", {"attribute": "name", "tag": "link"}),
        (
            "<link name='a'><visual/></link>",
            "MissingElement",
            "visual",
            {"tag": "geometry", "parentTag": "visual", "displayOnly": "true"},
        ),
        (
            "<link name='a'><collision/></link>",
            "MissingElement",
            "collision",
            {"tag": "geometry", "parentTag": "collision"},
        ),
        (
            "<link name='a'><visual><geometry><box/></geometry></visual></link>",
            "MissingAttribute",
            "box",
            {"attribute": "size", "tag": "box", "displayOnly": "true"},
        ),
        ("<link name='a'>\n why </link>", "StrayText", "why", {"written": "why", "tag": "link"}),
        (
            "<link name='a'><inertial/><inertial/></link>",
            "RepeatedElement",
            "inertial",
            {"tag": "inertial", "ordinal": "2", "equal": "true"},
        ),
        (
            "<link name='a'><inertial/><inertial><mass value='1'/></inertial></link>",
            "RepeatedElement",
            "inertial",
            {"tag": "inertial", "ordinal": "2", "equal": "false"},
        ),
        ("<gz:x/>", "UndeclaredPrefix", "gz:x", {"prefix": "gz"}),
        ("<link name='a' gz:x=''/>", "UndeclaredPrefix", "gz:x", {"prefix": "gz"}),
    ],
)
def test_what_departs_from_the_format_is_remarked(
    inside: str, kind: str, place: str, details: dict[str, str]
) -> None:
    arm = model(f"<robot name='r'>{inside}</robot>")
    assert (kind, place, details) in remarks(arm)


def test_a_prefix_holds_on_its_element_and_within_and_nowhere_else() -> None:
    arm = model(
        "<robot name='r'><a:x xmlns:a='u'><a:y a:z=''/></a:x>"
        "<a:x/><a:x/><gazebo xml:space=''/></robot>"
    )
    found = remarks(arm, "UndeclaredPrefix")
    assert found == [("UndeclaredPrefix", "a:x", {"prefix": "a"})]
    node = next(s for s, p, _ in arm.statements if p.endswith("source#prefix>"))
    assert arm.map.nodes[node].whole.start == arm.source.text.index("<a:x/>") + 1


@pytest.mark.parametrize(
    ("version", "kinds"),
    [
        ("", ["LaterFeature", "LaterFeature"]),
        ("version='1.0'", ["LaterFeature", "LaterFeature"]),
        ("version='1.1'", []),
        ("version='1.10'", []),
        ("version='one'", []),
    ],
)
def test_features_are_held_against_the_version(version: str, kinds: list[str]) -> None:
    text = (
        f"<robot name='r' {version}><link name='a'><visual><origin quat_xyzw='0 0 0 1'/>"
        "<geometry><capsule radius='1' length='1'/></geometry></visual></link></robot>"
    )
    assert [kind for kind, _, _ in remarks(model(text))] == kinds


def test_what_an_unknown_element_holds_is_no_business_of_the_format() -> None:
    arm = model("<robot name='r'><linke><mesh filename='a'/><zzz a='1'/></linke></robot>")
    assert [kind for kind, _, _ in remarks(arm)] == ["UndeclaredElement"]
    assert ("#/linke", "ext:mesh", "#/linke/mesh") in graph(arm)


def test_text_in_pieces_is_one_text() -> None:
    text = (
        "<sdf version='1.9'><model name='m'><link name='l'><pose>1 <!-- x -->2\n 3"
        "<![CDATA[ 0 0]]> 7</pose></link></model></sdf>"
    )
    world = model(text, "m.sdf")
    pose = "#/model/m/link/l/pose"
    stated = {p: o for s, p, o in graph(world) if s == pose and "text" in p}
    assert stated == {f"src:text-{k}": v for k, v in enumerate("123007", 1)}
    spans = [world.source[world.map.triples[t]] for t in world.statements if "text-" in t[1]]
    assert spans == list("123007")


def test_the_root_may_be_something_else() -> None:
    arm = model("<robt><link name='a'/></robt>")
    assert remarks(arm) == [("UndeclaredElement", "robt", {"tag": "robt", "resembles": "robot"})]
    assert graph(arm)[0] == ("", "robt", "#")
