"""Whatever a xacro file expands to is placed in the text that wrote it, in whichever file."""

from __future__ import annotations

from pathlib import Path

import pytest
from expanding import XMLNS, document, names, places, project, robot, said, shown

from kinlint.files.packages import Packages
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.vocabulary import SRC


def test_text_of_the_file_itself(tmp_path: Path) -> None:
    found = document(project(tmp_path, main=robot('<link name="base"/>', "<joint name = 'j'/>")))
    assert places(found, "name", "base") == ["main.xacro:2:13 base"]
    assert places(found, "name", "j") == ["main.xacro:3:16 j"]


def test_an_expression_is_placed_at_itself(tmp_path: Path) -> None:
    main = robot(
        '<xacro:property name="h" value="0.25"/>',
        '<link name="base"><visual><origin xyz="1 ${h * 2} 3" rpy="${h} 0 0"/></visual></link>',
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "xyz-1", "1") == ["main.xacro:3:40 1"]
    assert places(found, "xyz-2", "0.5") == ["main.xacro:3:42 ${h * 2}"]
    assert places(found, "xyz-3", "3") == ["main.xacro:3:51 3"]
    assert places(found, "rpy-1", "0.25") == ["main.xacro:3:59 ${h}"]


def test_what_one_expression_makes_of_several_values(tmp_path: Path) -> None:
    main = robot(
        '<xacro:property name="at" value="1 2 4"/>',
        '<link name="base"><visual><origin xyz="${at}"/></visual></link>',
    )
    found = document(project(tmp_path, main=main))
    for value, name in (("1", "xyz-1"), ("2", "xyz-2"), ("4", "xyz-3")):
        assert places(found, name, value) == ["main.xacro:3:40 ${at}"]


def test_a_macro_is_placed_where_it_is_defined(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="part" params="name">',
        '  <link name="${name}_link"/>',
        "</xacro:macro>",
        '<xacro:part name="left"/>',
        '<xacro:part name="right"/>',
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "name", "left_link") == ["main.xacro:3:15 ${name}_link"]
    assert places(found, "name", "right_link") == ["main.xacro:3:15 ${name}_link"]


def test_a_block_is_placed_where_it_is_passed(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="part" params="*shape **more">',
        '  <link name="base"><visual><xacro:insert_block name="shape"/>',
        '    <xacro:insert_block name="more"/></visual></link>',
        "</xacro:macro>",
        "<xacro:part>",
        '  <origin xyz="7 8 9"/>',
        '  <some><geometry><sphere radius="${1+1}"/></geometry></some>',
        "</xacro:part>",
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "xyz-2", "8") == ["main.xacro:7:18 8"]
    assert places(found, "radius", "2") == ["main.xacro:8:35 ${1+1}"]


def test_included_files(tmp_path: Path) -> None:
    path = project(
        tmp_path,
        main=robot(
            '<xacro:include filename="parts.xacro"/>',
            '<xacro:part name="a"/>',
            '<xacro:include filename="more.xacro" ns="more"/>',
            '<xacro:more.wheel name="${more.side}"/>',
        ),
        parts=robot(
            "<!-- a part -->",
            '<xacro:macro name="part" params="name"><link name="${name}1"/></xacro:macro>',
            '<link name="fixed"/>',
        ),
        more=robot(
            '<xacro:property name="side" value="left"/>',
            '<xacro:macro name="wheel" params="name"><link name="${name}_wheel"/></xacro:macro>',
        ),
    )
    found = document(path)
    assert places(found, "name", "fixed") == ["parts.xacro:4:13 fixed"]
    assert places(found, "name", "a1") == ["parts.xacro:3:52 ${name}1"]
    assert places(found, "name", "left_wheel") == ["more.xacro:3:53 ${name}_wheel"]
    assert [Path(text.name).name for text in found.sources] == [
        "main.xacro",
        "parts.xacro",
        "more.xacro",
    ]


def test_conditions_and_loops(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="row" params="n">',
        '  <xacro:if value="${n > 0}">',
        '    <link name="link${n}"/>',
        '    <xacro:row n="${n - 1}"/>',
        "  </xacro:if>",
        '  <xacro:unless value="${n > 0}"><link name="end"/></xacro:unless>',
        "</xacro:macro>",
        '<xacro:row n="3"/>',
    )
    found = document(project(tmp_path, main=main))
    for name in ("link1", "link2", "link3"):
        assert places(found, "name", name) == ["main.xacro:4:17 link${n}"]
    assert places(found, "name", "end") == ["main.xacro:7:46 end"]


def test_property_blocks_attributes_and_elements(tmp_path: Path) -> None:
    main = robot(
        '<xacro:property name="pose"><origin xyz="4 5 6"/></xacro:property>',
        '<link name="base">',
        "  <xacro:element xacro:name=\"${'vis' + 'ual'}\">",
        '    <xacro:attribute name="name" value="shape${1}"/>',
        '    <xacro:insert_block name="pose"/>',
        "  </xacro:element>",
        "</link>",
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "name", "shape1") == ["main.xacro:5:41 shape${1}"]
    assert places(found, "xyz-1", "4") == ["main.xacro:2:42 4"]


def test_text_of_elements(tmp_path: Path) -> None:
    main = robot(
        '<xacro:property name="kind" value="Effort"/>',
        '<link name="base"/><transmission name="t">',
        "  <type>",
        "    transmission_interface/${kind}Transmission",
        "  </type>",
        "</transmission>",
    )
    found = document(project(tmp_path, main=main))
    (place,) = places(found, "text", "transmission_interface/EffortTransmission")
    assert place == "main.xacro:5:5 transmission_interface/${kind}Transmission"


def test_escapes_entities_and_unicode(tmp_path: Path) -> None:
    main = robot(
        '<!-- ä\U0001f916 --><xacro:property name="p" value="ü"/>',
        "<link name='ä&amp;\"${p}'/><link name=\"$${x}\"/><link name='tail'/>",
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "name", 'ä&"ü') == ['main.xacro:3:13 ä&amp;"${p}']
    assert places(found, "name", "${x}") == ["main.xacro:3:39 $${x}"]
    assert places(found, "name", "tail") == ["main.xacro:3:59 tail"]


def test_line_ends_of_windows(tmp_path: Path) -> None:
    main = robot('<link name="base"/>', '<link name="${1}a"/>').replace("\n", "\r\n")
    path = tmp_path / "main.xacro"
    path.write_bytes(main.encode())
    found = document(path)
    assert places(found, "name", "base") == ["main.xacro:2:13 base"]
    assert places(found, "name", "1a") == ["main.xacro:3:13 ${1}a"]


def test_whole_elements(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="m"><link name="a"><visual/></link></xacro:macro>', "<xacro:m/>"
    )
    found = document(project(tmp_path, main=main))
    node = next(o for _, p, o in found.statements if p.endswith("urdf#link>"))
    location = found.location(found.map.nodes[node].whole)
    assert location.source[location.span] == '<link name="a"><visual/></link>'
    location = found.location(found.map.nodes[node].best)
    assert location.source[location.span] == "a"


def test_offsets_of_the_source_layer_are_places(tmp_path: Path) -> None:
    main = robot('<xacro:macro name="m"><lnik/></xacro:macro>', '<link name="a"/>', "<xacro:m/>")
    found = document(project(tmp_path, main=main))
    ((offset, place),) = said(found, "UndeclaredElement", "offset")
    assert int(offset) == main.index("lnik")
    assert place == "main.xacro:2:24 lnik"


def test_arguments(tmp_path: Path) -> None:
    main = robot('<xacro:arg name="prefix" default="a"/>', '<link name="$(arg prefix)_base"/>')
    path = project(tmp_path, main=main)
    assert places(document(path), "name", "a_base") == ["main.xacro:3:13 $(arg prefix)_base"]
    assert places(document(path, prefix="b"), "name", "b_base")


def test_a_missing_argument_is_named(tmp_path: Path) -> None:
    found = document(project(tmp_path, main=robot('<link name="$(arg prefix)base"/>')))
    assert said(found, "UnknownArgument", "argument") == [
        ("prefix", "main.xacro:2:13 $(arg prefix)base")
    ]


def test_files_by_package(tmp_path: Path) -> None:
    for package in ("arm_description", "gripper"):
        (tmp_path / package / "urdf").mkdir(parents=True)
        (tmp_path / package / "package.xml").write_text(
            f"<package><name>{package}</name></package>"
        )
    main = robot(
        '<xacro:include filename="$(find gripper)/urdf/hand.xacro"/>', '<link name="base"/>'
    )
    path = project(tmp_path / "arm_description" / "urdf", main=main)
    project(tmp_path / "gripper" / "urdf", hand=robot('<link name="hand"/>'))
    assert places(document(path), "name", "hand") == ["hand.xacro:2:13 hand"]


def test_a_missing_package_is_named(tmp_path: Path) -> None:
    main = robot('<xacro:include filename="$(find gripper_nowhere)/urdf/hand.xacro"/>')
    found = document(project(tmp_path, main=main))
    assert said(found, "UnknownPackage", "package") == [
        ("gripper_nowhere", "main.xacro:2:26 $(find gripper_nowhere)/urdf/hand.xacro")
    ]


def test_yaml(tmp_path: Path) -> None:
    (tmp_path / "limits.yaml").write_text("elbow:\n  lower: !degrees 180\n  names: [a, b]\n")
    main = robot(
        '<xacro:property name="limits" value="${xacro.load_yaml(\'limits.yaml\')}"/>',
        '<link name="${limits.elbow.names[1]}"/>',
        '<joint name="j" type="revolute"><limit lower="${limits[\'elbow\'][\'lower\']}"/></joint>',
    )
    found = document(project(tmp_path, main=main))
    assert places(found, "name", "b") == ["main.xacro:3:13 ${limits.elbow.names[1]}"]
    assert places(found, "lower", "3.141592653589793") == [
        "main.xacro:4:47 ${limits['elbow']['lower']}"
    ]


@pytest.mark.parametrize(
    "text",
    [
        robot('<xacro:macro name="m" params="p"><link name="${p}"/></xacro:macro>'),
        robot('<xacro:property name="p" value="1"/>', '<material name="grey"/>'),
        f'<robot {XMLNS}><link name="part"/></robot>',
        f"<robot {XMLNS}/>",
        f"<launch {XMLNS}><node/></launch>",
    ],
    ids=["macros", "materials", "no name", "nothing", "no robot"],
)
def test_what_only_others_use_is_no_robot(tmp_path: Path, text: str) -> None:
    found = document(project(tmp_path, main=text))
    assert found.format.name == "xacro"
    assert not any("/urdf#" in predicate for _, predicate, _ in found.statements)


def test_an_srdf(tmp_path: Path) -> None:
    main = robot('<xacro:property name="p" value="arm"/>', '<group name="${p}"/>')
    found = document(project(tmp_path, main=main))
    assert found.format.name == "srdf"
    assert places(found, "name", "arm")[-1] == "main.xacro:3:14 ${p}"


def test_an_sdf(tmp_path: Path) -> None:
    main = f'<sdf version="1.9" {XMLNS}>\n<model name="m${{1}}"><link name="l"/></model></sdf>'
    found = document(project(tmp_path, main=main))
    assert found.format.name == "sdf"
    assert places(found, "name", "m1") == ["main.xacro:2:14 m${1}"]


def test_what_is_expanded_is_of_two_formats(tmp_path: Path) -> None:
    """Rules may spare a text that nobody wrote, such as a path to a package."""
    found = document(project(tmp_path, main=robot('<link name="base"/>')))
    said = {value for _, predicate, value in found.statements if predicate == f"<{SRC}format>"}
    assert said == {'"urdf"', '"xacro"'}


def test_comments_that_suppress_are_kept(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="m">',
        "  <!-- kinlint: ignore[INE001] as measured -->",
        '  <link name="base"/>',
        "</xacro:macro>",
        "<xacro:m/>",
    )
    found = document(project(tmp_path, main=main))
    assert any(p.endswith("ns#ignore>") for _, p, _ in found.statements)


def test_a_file_is_read_once_in_a_run(tmp_path: Path) -> None:
    include = '<xacro:include filename="parts.xacro"/>'
    project(tmp_path, one=robot(include), two=robot(include), parts=robot('<link name="part"/>'))
    options = ReadOptions(packages_of=lambda _: Packages(environment={}))
    one, two, parts = (
        read(decode(str(path), path.read_bytes()), options)
        for path in (tmp_path / f"{name}.xacro" for name in ("one", "two", "parts"))
    )
    assert one.sources[1] is two.sources[1]
    assert one.sources[1].name == parts.source.name
    assert names(one)["part"] == names(two)["part"] == 1


def test_an_included_file_is_placed_where_it_is_named(tmp_path: Path) -> None:
    """By the main file, by an included one, and by a wildcard, whose files are sorted."""
    main = robot('<xacro:include filename="one.xacro"/>', '<link name="base"/>')
    one = robot('<xacro:include filename="part_*.xacro"/>')
    path = project(tmp_path, main=main, one=one, part_a=robot(), part_b=robot())
    found = document(path)
    includes = [each for each in found.statements if each[1] == f"<{SRC}includes>"]
    assert [shown(found, each) for each in includes] == [
        "main.xacro:2:26 one.xacro",
        "one.xacro:2:26 part_*.xacro",
        "one.xacro:2:26 part_*.xacro",
    ]
    assert [each[2].rpartition("/")[2] for each in includes] == [
        "one.xacro>", "part_a.xacro>", "part_b.xacro>",
    ]  # fmt: skip
