"""Changes of URDF, SRDF and SDF are written as their author would have."""

from __future__ import annotations

import pytest
from editing_xml import Triples, change, edited

from kinlint.edits import Delta, NotExpressible
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xml.editing import element_tree
from kinlint.terms import XSD, iri
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

JOINT = """\
<robot name="arm">
  <joint name="elbow" type="revolute">
    <parent link="a"/>  <!-- the upper arm -->
    <child link="b"/>
    <axis xyz="0  0   1.0"/>
    <limit lower="-1.570"
           upper="1.570"
           velocity="2"/>
  </joint>
</robot>
"""
ELBOW, LIMIT, AXIS = "#/joint/elbow", "#/joint/elbow/limit", "#/joint/elbow/axis"


def changed(removed: Triples, added: Triples) -> list[str]:
    """The lines of the joint that a change takes away and those that it puts there."""
    before, after = JOINT.splitlines(), change(JOINT, removed, added).splitlines()
    while before and after and before[0] == after[0]:
        before, after = before[1:], after[1:]
    while before and after and before[-1] == after[-1]:
        before, after = before[:-1], after[:-1]
    return ["\n".join(before), "\n".join(after)]


def test_a_value_is_replaced() -> None:
    assert changed([(LIMIT, "at:velocity")], [(LIMIT, "at:velocity", 0.1)]) == [
        '           velocity="2"/>',
        '           velocity="0.1"/>',
    ]


def test_a_component_is_replaced_and_the_space_around_it_stays() -> None:
    assert changed([(AXIS, "at:xyz-2")], [(AXIS, "at:xyz-2", -1.0)]) == [
        '    <axis xyz="0  0   1.0"/>',
        '    <axis xyz="0  -1   1.0"/>',
    ]


def test_a_vector_is_replaced_as_one_string() -> None:
    gone = [(AXIS, f"at:xyz-{number}") for number in (1, 2, 3)]
    assert changed(gone, [(AXIS, "at:xyz", "1 0 0")])[1] == '    <axis xyz="1 0 0"/>'


def test_values_that_move_keep_their_spelling() -> None:
    lower, upper = (f'"{value}"^^<{XSD}double>' for value in ("-1.570", "1.570"))
    swapped = [(LIMIT, "at:lower", upper), (LIMIT, "at:upper", lower)]
    text = change(JOINT, [(LIMIT, "at:lower"), (LIMIT, "at:upper")], swapped)
    assert text == JOINT.replace('lower="-1.570"', 'lower="1.570"').replace(
        'upper="1.570"', 'upper="-1.570"'
    )


@pytest.mark.parametrize(
    ("number", "datatype", "written"),
    [
        ("1.0E-6", "double", "1e-06"), ("1.5707963267948966E0", "double", "1.5707963267948966"),
        ("-0.0E0", "double", "0"), ("1.0E22", "double", "1e+22"), ("INF", "double", "inf"),
        ("3", "integer", "3"), ("2.50", "decimal", "2.5"), ("1.0", "decimal", "1"),
        ("true", "boolean", "true"),
    ],
)  # fmt: skip
def test_new_numbers_have_as_many_digits_as_they_need(
    number: str, datatype: str, written: str
) -> None:
    added = [(AXIS, "at:note", f'"{number}"^^<{XSD}{datatype}>')]
    assert f' note="{written}"/>' in change(JOINT, [], added)


def test_an_attribute_is_put_behind_the_others_in_their_manner() -> None:
    assert changed([], [(LIMIT, "at:effort", 10.0)]) == [
        '           velocity="2"/>',
        '           velocity="2"\n           effort="10"/>',
    ]
    assert changed([], [(ELBOW, "at:note", 'say "<&>"')])[1] == (
        '  <joint name="elbow" type="revolute" note="say &quot;&lt;&amp;>&quot;">'
    )


def test_a_vector_that_was_not_there_is_written_whole() -> None:
    added = [("#/joint/elbow/child", f"at:xyz-{number}", float(number)) for number in (3, 1, 2)]
    assert changed([], added)[1] == '    <child link="b" xyz="1 2 3"/>'


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("lower", '    <limit upper="1.570"\n           velocity="2"/>'),
        ("upper", '    <limit lower="-1.570"\n           velocity="2"/>'),
        ("velocity", '    <limit lower="-1.570"\n           upper="1.570"/>'),
    ],
)
def test_an_attribute_goes_with_its_space(name: str, expected: str) -> None:
    text = change(JOINT, [(LIMIT, f"at:{name}")], [])
    assert expected in text
    assert len(text.splitlines()) == len(JOINT.splitlines()) - 1


def test_the_only_attribute_goes() -> None:
    gone = [(AXIS, f"at:xyz-{number}") for number in (1, 2, 3)]
    assert changed(gone, [])[1] == "    <axis/>"


def test_an_attribute_is_renamed_where_it_stands() -> None:
    text = JOINT.replace("lower", "lowr")
    assert change(text, [(LIMIT, "at:lowr")], [(LIMIT, "at:lower", "-1.570")]) == JOINT


def test_several_attributes_are_renamed_each_to_the_one_that_says_the_same() -> None:
    text = '<robot name="r"><limit lowr="1" uper="2" efort="1"/></robot>'
    gone = [("#/limit", f"at:{name}") for name in ("lowr", "uper", "efort")]
    come = [
        ("#/limit", "at:upper", "2"),
        ("#/limit", "at:lower", "1"),
        ("#/limit", "at:effort", "1"),
    ]
    assert change(text, gone, come) == (
        '<robot name="r"><limit lower="1" upper="2" effort="1"/></robot>'
    )


def test_an_attribute_takes_the_place_of_another() -> None:
    text = JOINT.replace('<axis xyz="0  0   1.0"/>', '<origin quat_xyzw="0 0 0 1" xyz="0 0 1"/>')
    origin = f"{ELBOW}/origin"
    gone = [(origin, f"at:quat_xyzw-{number}") for number in (1, 2, 3, 4)]
    come = [(origin, f"at:rpy-{number}", 0.0) for number in (1, 2, 3)]
    assert '<origin rpy="0 0 0" xyz="0 0 1"/>' in change(text, gone, come)


def test_a_name_comes_first() -> None:
    assert change('<robot><link a="1"/></robot>', [], [("#/link", "at:name", "l")]) == (
        '<robot><link name="l" a="1"/></robot>'
    )


def test_quotes_are_those_of_the_neighbours() -> None:
    text = "<robot name='r'><link name = 'a' /></robot>"
    assert change(text, [("#/link/a", "at:name")], [("#/link/a", "at:name", "it's")]) == (
        "<robot name='r'><link name = 'it&apos;s' /></robot>"
    )
    added = [("#/link/a", "urdf:visual", "_:v"), ("_:v", "at:name", 'a"b')]
    assert change(text, [], added) == (
        "<robot name='r'><link name = 'a'><visual name='a\"b' /></link></robot>"
    )


def test_a_namespace_is_declared() -> None:
    assert change(JOINT, [], [("#", "at:xmlns:gz", "http://gz.org")]).startswith(
        '<robot name="arm" xmlns:gz="http://gz.org">\n'
    )


def test_an_element_goes_with_its_line() -> None:
    assert changed([(ELBOW, "urdf:axis")], []) == ['    <axis xyz="0  0   1.0"/>', ""]


def test_an_element_goes_with_all_within_even_if_that_is_listed() -> None:
    gone = [("#", "urdf:joint"), (ELBOW, "at:name"), (ELBOW, "urdf:axis"), (AXIS, "at:xyz-1")]
    assert change(JOINT, gone, []) == '<robot name="arm">\n</robot>\n'


def test_a_comment_behind_an_element_stays() -> None:
    assert changed([(ELBOW, "urdf:parent")], []) == [
        '    <parent link="a"/>  <!-- the upper arm -->',
        "    <!-- the upper arm -->",
    ]


def test_neighbours_in_one_line_go_together() -> None:
    text = '<robot name="r">\n  <a/> <b/>\n  <c/> <d/> <e/>\n</robot>\n'
    assert change(text, [("#", "urdf:a"), ("#", "urdf:b")], []) == (
        '<robot name="r">\n  <c/> <d/> <e/>\n</robot>\n'
    )
    assert "  <c/> <e/>\n" in change(text, [("#", "urdf:d")], [])
    assert "  <d/> <e/>\n" in change(text, [("#", "urdf:c")], [])
    assert "  <c/> <d/>\n" in change(text, [("#", "urdf:e")], [])


def test_an_element_is_renamed_in_both_tags() -> None:
    text = '<robot name="r"><colision a="1" ><b/></colision ><link name="colision"/></robot>'
    change_ = [("#", "urdf:colision", "#/colision")]
    assert change(text, change_, [("#", "urdf:collision", "#/colision")]) == (
        '<robot name="r"><collision a="1" ><b/></collision ><link name="colision"/></robot>'
    )


def test_an_element_is_put_behind_its_siblings() -> None:
    added = [(ELBOW, "urdf:mimic", "_:m"), ("_:m", "at:joint", "k"), ("_:m", "at:offset", 1e-6)]
    assert changed([], added)[1] == '    <mimic joint="k" offset="1e-06"/>'


def test_an_element_is_put_behind_those_of_its_kind_and_their_comments() -> None:
    added = [(ELBOW, "urdf:parent", "_:p"), ("_:p", "at:link", "c")]
    assert changed([], added) == ["", '    <parent link="c"/>']
    assert '<!-- the upper arm -->\n    <parent link="c"/>\n    <child' in change(JOINT, [], added)


def test_an_element_takes_the_place_of_one_that_goes() -> None:
    added = [(ELBOW, "urdf:mimic", "_:m"), ("_:m", "at:joint", "k")]
    assert changed([(ELBOW, "urdf:axis")], added) == [
        '    <axis xyz="0  0   1.0"/>',
        '    <mimic joint="k"/>',
    ]


def test_an_element_of_one_tag_is_opened() -> None:
    added = [
        ("#/link/a", "urdf:inertial", "_:i"), ("_:i", "urdf:mass", "_:m"), ("_:m", "at:value", 0.5),
    ]  # fmt: skip
    text = '<robot name="r">\n\t<link name="a" />\n</robot>'
    assert change(text, [], added) == (
        '<robot name="r">\n\t<link name="a">\n\t\t<inertial>\n\t\t\t<mass value="0.5" />'
        "\n\t\t</inertial>\n\t</link>\n</robot>"
    )


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        ("", "\n    <v/>\n  "),
        ("\n  ", "\n    <v/>\n  "),
        ("\n    <!-- c -->\n  ", "\n    <!-- c -->\n    <v/>\n  "),
        ("<u/>", "<u/><v/>"),
    ],
)
def test_an_element_is_put_into_one_with_two_tags(inside: str, expected: str) -> None:
    text = '<robot name="r">\n  <link name="a">{}</link>\n</robot>'
    assert change(text.format(inside), [], [("#/link/a", "urdf:v", "_:v")]) == (
        text.format(expected)
    )


def test_blank_lines_between_siblings_are_kept_up() -> None:
    text = '<robot name="r">\n\n  <link name="a"/>\n\n  <link name="b"/>\n</robot>\n'
    added = [("#", "urdf:link", "_:c"), ("_:c", "at:name", "c")]
    assert change(text, [], added) == text.replace('"b"/>', '"b"/>\n\n  <link name="c"/>')


def test_line_ends_and_minified_files_stay_what_they_are() -> None:
    windows = JOINT.replace("\n", "\r\n")
    added = [(ELBOW, "urdf:mimic", "_:m"), ("_:m", "urdf:x", "_:x")]
    text = change(windows, [(ELBOW, "urdf:axis")], [*added, (LIMIT, "at:effort", 1.0)])
    assert text.count("\r\n") == text.count("\n") == windows.count("\n") + 3
    tight = "".join(line.strip() for line in JOINT.splitlines())
    assert "\n" not in change(tight, [(ELBOW, "urdf:axis")], added)


def test_an_element_moves_with_its_lines() -> None:
    text = """\
<robot name="r">
  <link name="a">
    <visual>
      <!-- a box -->
      <box size="1 1 1"/>
    </visual>
  </link>
</robot>
"""
    box = "#/link/a/visual/box"
    assert change(
        text,
        [("#/link/a/visual", "urdf:box")],
        [("#/link/a/visual", "urdf:geometry", "_:g"), ("_:g", "urdf:box", box)],
    ) == text.replace(
        '      <box size="1 1 1"/>\n',
        '      <geometry>\n        <box size="1 1 1"/>\n      </geometry>\n',
    )
    assert (
        change(text, [("#/link/a", "urdf:visual")], [("#", "urdf:visual", "#/link/a/visual")])
        == """\
<robot name="r">
  <link name="a">
  </link>
  <visual>
    <!-- a box -->
    <box size="1 1 1"/>
  </visual>
</robot>
"""
    )


def test_what_moves_is_changed_on_the_way() -> None:
    text = '<robot name="r">\n  <a><mas v="1"/></a>\n  <b/>\n</robot>'
    assert (
        change(
            text,
            [("#/a", "ext:mas"), ("#/a/mas", "at:v")],
            [("#/b", "urdf:mass", "#/a/mas"), ("#/a/mas", "at:value", "1")],
        )
        == '<robot name="r">\n  <a></a>\n  <b>\n    <mass value="1"/>\n  </b>\n</robot>'
    )


SDF = """\
<sdf version="1.9">
  <model name="m">
    <pose>0 0  <!-- high -->1   0 0 0</pose>
    <link name="l"><inertial><mass>1.50</mass></inertial></link>
    <static><![CDATA[true]]></static>
    <frame name="a&amp;b"/>
    <plugin name="p" filename="f"><x>&lt;a</x><y/></plugin>
  </model>
</sdf>
"""
MODEL = "#/model/m"


@pytest.mark.parametrize(
    ("node", "component", "value", "before", "after"),
    [
        ("pose", "src:text-3", 2.5, "-->1   0", "-->2.5   0"),
        ("pose", "src:text-1", 2.0, ">0 0  <", ">2 0  <"),
        ("link/l/inertial/mass", "src:text", 0.25, "1.50", "0.25"),
        ("static", "src:text", "a<b", "<![CDATA[true]]>", "<![CDATA[a<b]]>"),
        ("plugin/p/x", "src:text", "b & c", "&lt;a", "b &amp; c"),
    ],
)
def test_text_is_replaced(
    node: str, component: str, value: str | float, before: str, after: str
) -> None:
    place = f"{MODEL}/{node}"
    text = change(SDF, [(place, component)], [(place, component, value)], "m.sdf")
    assert text == SDF.replace(before, after, 1)


def test_text_comes_and_goes() -> None:
    added = [(f"{MODEL}/plugin/p/y", "src:text", "1 2")]
    assert "<y>1 2</y>" in change(SDF, [], added, "m.sdf")
    gone = [(f"{MODEL}/plugin/p/x", "src:text")]
    assert "<x></x>" in change(SDF, gone, [], "m.sdf")


def test_a_vector_of_text_gets_longer() -> None:
    text = SDF.replace("<pose>0 0  <!-- high -->1   0 0 0</pose>", "<pose>0 0 1</pose>")
    gone, come = [(f"{MODEL}/pose", "src:text")], [(f"{MODEL}/pose", "src:text", "0 0 1 0 0 0")]
    assert "<pose>0 0 1 0 0 0</pose>" in change(text, gone, come, "m.sdf")


def test_a_new_element_has_text() -> None:
    added = [
        (f"{MODEL}/link/l/inertial", "sdf:inertia", "_:i"), ("_:i", "sdf:ixx", "_:x"),
        ("_:x", "src:text", 0.01),
    ]  # fmt: skip
    assert "</mass><inertia><ixx>0.01</ixx></inertia></inertial>" in change(SDF, [], added, "m.sdf")


def test_a_group_of_an_srdf() -> None:
    text = '<robot name="r">\n  <group name="g">\n    <joint name="a"/>\n  </group>\n</robot>\n'
    added = [("#/group/g", "srdf:joint", "_:j"), ("_:j", "at:name", "b")]
    assert change(text, [], added, "r.srdf") == text.replace(
        '"a"/>', '"a"/>\n    <joint name="b"/>'
    )


MENDED = """\
<?xml version="0.0"?>
<!-- two -- hyphens -->
<robot name="a & b">
  <link name="x"a="1"b="2"/> <!-- µ -- 漢 -->
  <link name="µ<y" a="1" a="2"/>
</robot>
"""


@pytest.mark.parametrize(
    ("node", "name", "before", "after"),
    [
        ("#", "at:name", "a & b", "new"),
        ("#/link/x", "at:a", 'a="1"b', 'a="new"b'),
        ("#/link/%C2%B5%3Cy", "at:name", "µ<y", "new"),
    ],
)
def test_places_in_text_that_is_not_well_formed(
    node: str, name: str, before: str, after: str
) -> None:
    assert change(MENDED, [(node, name)], [(node, name, "new")]) == MENDED.replace(before, after)


def test_attributes_go_from_text_that_is_not_well_formed() -> None:
    assert change(MENDED, [("#/link/x", "at:a")], []) == MENDED.replace('"x"a="1"b', '"x"b')
    assert change(MENDED, [("#/link/%C2%B5%3Cy", "at:a")], []) == MENDED.replace(' a="1" a="2"', "")


@pytest.mark.parametrize(
    ("removed", "added", "reason"),
    [
        ([], [(LIMIT, "at:lower", 1.0)], "there is another lower already"),
        ([], [(AXIS, "at:xyz", "1 0 0")], "there is another xyz already"),
        ([(AXIS, "at:xyz-2")], [], "xyz would have no 2. component"),
        ([], [(AXIS, "at:a b", "1")], "a b is not a name in XML"),
        ([], [(ELBOW, "urdf:a b", "_:x")], "a b is not a name in XML"),
        ([], [(AXIS, "at:note", "\x01")], "XML has no such character"),
        ([], [(AXIS, "at:note", "${x}")], "xacro would take the value for an expression"),
        ([], [(AXIS, "at:note", "_:b")], "an attribute or a text cannot be a node"),
        ([], [(ELBOW, "src:text", "a")], "there are elements in place of a text"),
        ([], [(ELBOW, "src:order", "1")], "no element can say it"),
        ([], [("_:a", "urdf:b", "_:b")], "a new element stands nowhere"),
        ([], [(ELBOW, "urdf:axis", LIMIT)], "an element cannot stand in two places"),
        ([("#", "urdf:joint")], [(AXIS, "at:a", "b")], "what is deleted cannot be changed"),
        ([("#", "urdf:joint")], [(AXIS, "urdf:a", "_:b")], "no element is there to hold it"),
        ([("#", "urdf:joint")], [(AXIS, "urdf:x", ELBOW)], "an element cannot stand within itself"),
    ],
)  # fmt: skip
def test_what_cannot_be_said(removed: Triples, added: Triples, reason: str) -> None:
    with pytest.raises(NotExpressible) as caught:
        change(JOINT, removed, added)
    assert str(caught.value) == reason


def test_the_root_cannot_go() -> None:
    with pytest.raises(NotExpressible, match="a file has a root element"):
        change(JOINT, [("", "urdf:robot")], [])


BROKEN = """\
<?xml version="0.0"?>
<!-- two -- hyphens, ------ and more --->
<robot name="a & b">
  <?xml version="1.0"?>
  <link name="x"a="1"/>
  <link name="y<z" a="1"
        a="2" b="&nbsp;"/>
  stray
  <link name="c">text</link>
  <!-- c --><link name="d"/>\x01
</robot>
"""
SOUND = """\
<?xml version="1.0"?>
<!-- two - - hyphens, ====== and more =-->
<robot name="a &amp; b">
  <link name="x" a="1"/>
  <link name="y&lt;z" a="1" b="&amp;nbsp;"/>
  <link name="c"></link>
  <!-- c --><link name="d"/> 
</robot>
"""  # noqa: W291
ABOUT = {"MalformedText": "reason", "RepeatedAttribute": "attribute", "StrayText": "written"}


def test_what_is_not_well_formed_is_written_as_it_was_meant() -> None:
    options = ReadOptions()
    document = read(SourceText("arm.urdf", BROKEN), options)
    kinds = {
        s: iri(f"{SRC}{ABOUT[kind]}")
        for s, _, o in document.statements
        if (kind := o.rpartition("#")[2].removesuffix(">")) in ABOUT
    }
    gone = tuple(each for each in document.statements if kinds.get(each[0]) == each[1])
    texts = edited(document, Delta(gone))
    assert texts["arm.urdf"].text == SOUND
    after = read(texts["arm.urdf"], options)
    assert element_tree.tree(after) == element_tree.changed(document, Delta(gone))
    assert not any(o.rpartition("#")[2].removesuffix(">") in ABOUT for _, _, o in after.statements)


def test_blanks_before_a_declaration_go() -> None:
    text = '\n <?xml version="1.0"?>\n<robot name="r"/>'
    document = read(SourceText("arm.urdf", text), ReadOptions())
    gone = [each for each in document.statements if each[1] == iri(f"{SRC}reason")]
    assert edited(document, Delta(tuple(gone)))["arm.urdf"].text == text.lstrip()


def test_space_that_is_not_read_goes() -> None:
    inertial = '<inertial><origin xyz="0\n\t0  1 "/><mass value=" 1 "/></inertial>'
    text = f'<robot name="r"><link name="l">{inertial}</link></robot>'
    document = read(SourceText("arm.urdf", text), ReadOptions())
    gone = [each for each in document.statements if each[1] == iri(f"{SRC}reason")]
    made = edited(document, Delta(tuple(gone)))["arm.urdf"].text
    assert made == text.replace("0\n\t0  1 ", "0 0  1").replace(" 1 ", "1")


def test_of_two_blank_lines_one_goes() -> None:
    text = '<robot name="r">\r\n  <a/>\r\n\r\n  <b/>\r\n \r\n  <c/>\r\n</robot>\r\n'
    assert change(text, [("#", "urdf:b")], []) == text.replace("  <b/>\r\n \r\n", "")
