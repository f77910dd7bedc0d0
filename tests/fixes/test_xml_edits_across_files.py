"""Changes of robots whose text is generated, or comes from several files."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Any

import pytest
from editing_xml import Triples, delta, edited, term
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from random_changes import Changer

from kinlint.edits import NotExpressible
from kinlint.files.packages import Packages
from kinlint.formats.decoding import decode, encode
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xml.editing import element_tree

MAIN = """\
<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts.xacro"/>
  <xacro:property name="length" value="0.50"/>
  <xacro:property name="frame">
    <origin xyz="0 0 1"/>
  </xacro:property>
  <xacro:macro name="finger" params="side y">
    <link name="${side}_finger"/>
    <joint name="${side}" type="prismatic">
      <parent link="base"/>
      <child link="${side}_finger"/>
      <origin xyz="0 ${y} 0.10" rpy="0 0 0"/>
    </joint>
  </xacro:macro>
  <link name="base">
    <visual>
      <origin xyz="0  ${length / 2}  0.250"/>
      <geometry><box size="1 1 ${length}"/></geometry>
    </visual>
  </link>
  <xacro:if value="true">
    <link name="tool"/>
  </xacro:if>
  <joint name="fixed" type="fixed">
    <parent link="base"/>
    <child link="tool"/>
    <xacro:insert_block name="frame"/>
  </joint>
  <xacro:finger side="left" y="0.1"/>
  <xacro:finger side="right" y="-0.1"/>
  <xacro:camera/>
</robot>
"""
PARTS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="camera">
    <link name="camera"><xacro:attribute name="note" value="x"/></link>
  </xacro:macro>
</robot>
"""


def change(
    directory: Path, files: dict[str, str], removed: Triples, added: Triples
) -> dict[str, str]:
    """The texts that a change of the first of *files* changes; reading has shown that it does."""
    for name, text in files.items():
        path = directory / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    main = directory / next(iter(files))
    options = _options()
    document = read(decode(str(main), main.read_bytes()), options)
    wanted = delta(document, removed, added)
    texts = edited(document, wanted)
    for name, source in texts.items():
        Path(name).write_text(source.text, encoding="utf-8")
    after = read(decode(str(main), main.read_bytes()), _options())
    assert element_tree.tree(after) == element_tree.changed(document, wanted)
    return {Path(name).name: source.text for name, source in texts.items()}


def _options() -> ReadOptions:
    return ReadOptions(packages_of=lambda _: Packages(environment={}))


def xacro(directory: Path, removed: Triples, added: Triples) -> dict[str, str]:
    return change(directory, {"arm.urdf.xacro": MAIN, "parts.xacro": PARTS}, removed, added)


@pytest.mark.parametrize(
    ("triple", "before", "after"),
    [
        (("#/link/base/visual/origin", "at:xyz-3", 2.0), "0.250", "2"),
        (("#/link/base/visual/origin", "at:xyz-1", 0.125), '"0  ${', '"0.125  ${'),
        (("#/joint/fixed/origin", "at:xyz-3", 2.0), '"0 0 1"', '"0 0 2"'),
        (("#/link/tool", "at:name", "hand"), '"tool"/>\n  </xacro', '"hand"/>\n  </xacro'),
    ],
)
def test_xacro_is_changed_where_it_was_written_literally(
    tmp_path: Path, triple: tuple[Any, ...], before: str, after: str
) -> None:
    texts = xacro(tmp_path, [triple[:2]], [triple])
    assert texts == {"arm.urdf.xacro": MAIN.replace(before, after)}


def test_elements_of_xacro_come_and_go(tmp_path: Path) -> None:
    base = "#/link/base"
    added = [(base, "urdf:inertial", "_:i"), ("_:i", "urdf:mass", "_:m"), ("_:m", "at:value", 1.0)]
    inertial = '    <inertial>\n      <mass value="1"/>\n    </inertial>\n'
    assert xacro(tmp_path, [], added) == {
        "arm.urdf.xacro": MAIN.replace("    </visual>\n", f"    </visual>\n{inertial}")
    }
    assert xacro(tmp_path, [("#", "urdf:link", "#/link/tool")], []) == {
        "arm.urdf.xacro": MAIN.replace('    <link name="tool"/>\n', "")
    }


def test_xacro_of_another_file(tmp_path: Path) -> None:
    added = [("#/link/camera", "urdf:visual", "_:v")]
    text = PARTS.replace("</link>", "<visual/></link>")
    assert xacro(tmp_path, [], added) == {"parts.xacro": text}


LITERALLY = "the value is not written there literally"
SEVERAL = "the text stands for several elements"


@pytest.mark.parametrize(
    ("node", "name", "value", "reason"),
    [
        ("#/link/base/visual/origin", "at:xyz-2", 1.0, LITERALLY),
        ("#/link/base/visual/geometry/box", "at:size-3", 1.0, LITERALLY),
        ("#/link/camera", "at:note", "y", LITERALLY),
        ("#/joint/left/origin", "at:xyz-3", 1.0, SEVERAL),
        ("#/joint/left", "at:type", "fixed", SEVERAL),
    ],
)
def test_xacro_that_cannot_be_changed(
    tmp_path: Path, node: str, name: str, value: float | str, reason: str
) -> None:
    with pytest.raises(NotExpressible, match=reason):
        xacro(tmp_path, [(node, name)], [(node, name, value)])


@pytest.mark.slow
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.randoms(use_true_random=False))
def test_any_change_of_xacro(tmp_path: Path, random: Random) -> None:
    for name, text in (("arm.urdf.xacro", MAIN), ("parts.xacro", PARTS)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    main = tmp_path / "arm.urdf.xacro"
    options = _options()
    document = read(decode(str(main), main.read_bytes()), options)
    wanted = Changer(document, random).delta()
    if term(document, "#") in (subject for subject, _, _ in wanted.removed):
        return
    try:
        texts = edited(document, wanted)
    except NotExpressible:
        return
    for name, source in texts.items():
        Path(name).write_text(source.text, encoding="utf-8")
    after = read(decode(str(main), main.read_bytes()), _options())
    assert element_tree.tree(after) == element_tree.changed(document, wanted)


WORLD = """\
<sdf version="1.9">
  <world name="w">
    <include><uri>part/model.sdf</uri><name>one</name></include>
  </world>
</sdf>
"""
PART = """\
<sdf version="1.9">
  <model name="part">
    <link name="l">
      <inertial><mass>1.50</mass></inertial>
    </link>
  </model>
</sdf>
"""
INCLUDED = "#/world/w/include/sdf"


def test_what_an_sdf_includes_is_changed_there(tmp_path: Path) -> None:
    mass = f"{INCLUDED}/model/part/link/l/inertial/mass"
    files = {"world.sdf": WORLD, "part/model.sdf": PART}
    texts = change(tmp_path, files, [(mass, "src:text")], [(mass, "src:text", 2.0)])
    assert texts == {"model.sdf": PART.replace("1.50", "2")}
    name = "#/world/w/include/name"
    texts = change(tmp_path, files, [(name, "src:text")], [(name, "src:text", "two")])
    assert texts == {"world.sdf": WORLD.replace("one", "two")}


def test_what_is_included_twice_is_left_alone(tmp_path: Path) -> None:
    again = "    <include><uri>part/model.sdf</uri><name>two</name></include>\n"
    twice = WORLD.replace("  </world>", f"{again}  </world>")
    mass = f"{INCLUDED}/model/part/link/l/inertial/mass"
    files = {"world.sdf": twice, "part/model.sdf": PART}
    with pytest.raises(NotExpressible, match=SEVERAL):
        change(tmp_path, files, [(mass, "src:text")], [(mass, "src:text", 2.0)])


def test_the_root_of_what_is_included_cannot_go(tmp_path: Path) -> None:
    files = {"world.sdf": WORLD, "part/model.sdf": PART}
    with pytest.raises(NotExpressible, match="a file has a root element"):
        change(tmp_path, files, [("#/world/w/include", "sdf:sdf")], [])


def test_a_character_that_the_encoding_lacks_is_referred_to(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_bytes('<?xml version="1.0" encoding="latin-1"?><robot name="é"/>'.encode("latin-1"))
    document = read(decode(str(path), path.read_bytes()), _options())
    wanted = delta(
        document,
        [],
        [("#", "at:version", "é漢"), ("#", "urdf:x", "_:x"), ("_:x", "src:text", "漢")],
    )
    (source,) = edited(document, wanted).values()
    assert source.text.endswith('<robot name="é" version="é&#28450;"><x>&#28450;</x></robot>')
    assert element_tree.tree(
        read(decode(str(path), encode(source)), _options())
    ) == element_tree.changed(document, wanted)
