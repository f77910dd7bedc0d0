"""Symbols, and links to files."""

import json

import pytest
from navigating import NON_BMP, Model

from kinlint.navigation.outline import DEEPEST

URDF = f"""<robot name="cart"><!-- {NON_BMP} -->
  <link name="base"/>
  <link name="arm"/>
  <link name="hand"/>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="arm"/>
    <limit effort="1" velocity="1"/></joint>
  <joint name="grip" type="fixed"><parent link="arm"/><child link="hand"/></joint>
</robot>
"""


def drawn(symbols, depth=0):
    for each in symbols:
        yield "  " * depth + f"{each.name} ({each.detail})"
        yield from drawn(each.below, depth + 1)


def outline(model, name):
    return list(drawn(model.navigator.outline(str(model.folder / name))))


def test_links_and_joints_are_nested_as_the_robot_is(tmp_path):
    assert outline(Model(tmp_path, {"cart.urdf": URDF}), "cart.urdf") == [
        "cart (robot)",
        "  base (link)",
        "    lift (prismatic joint)",
        "      arm (link)",
        "        grip (fixed joint)",
        "          hand (link)",
    ]


def test_the_name_of_a_symbol_lies_in_its_description(tmp_path):
    model = Model(tmp_path, {"cart.urdf": URDF})
    pending = list(model.navigator.outline(str(tmp_path / "cart.urdf")))
    while pending:
        each = pending.pop()
        assert each.whole.start <= each.identifier.start
        assert each.identifier.end <= each.whole.end
        assert URDF[slice(*each.identifier)] == each.name
        pending += each.below


@pytest.mark.slow
def test_what_hangs_too_deep_is_put_beside(tmp_path):
    """Clients recurse through symbols, and robots may be chains of thousands."""
    links = "".join(f'<link name="l{i}"/>' for i in range(300))
    joints = "".join(
        f'<joint name="j{i}" type="fixed"><parent link="l{i}"/><child link="l{i + 1}"/></joint>'
        for i in range(299)
    )
    model = Model(tmp_path, {"c.urdf": f'<robot name="c">{links}{joints}</robot>'})
    lines = outline(model, "c.urdf")
    assert len(lines) == 600
    assert max(len(line) - len(line.lstrip()) for line in lines) <= 2 * DEEPEST


def test_a_file_without_robots_lists_its_names(tmp_path):
    srdf = '<robot name="cart"><group name="g"><joint name="lift"/></group></robot>'
    model = Model(tmp_path, {"cart.urdf": URDF, "cart.srdf": srdf})
    assert outline(model, "cart.srdf") == ["g (group)"]


def test_a_file_of_macros_lists_them(tmp_path):
    text = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="r" value="1"/>
  <xacro:macro name="wheel" params="p"><link name="${p}"/></xacro:macro>
</robot>"""
    model = Model(tmp_path, {"w.xacro": text})
    assert outline(model, "w.xacro") == ["r (property)", "wheel (macro)"]


def test_links_lead_to_contexts_meshes_and_textures(tmp_path):
    mesh = URDF.replace(
        '<link name="base"/>',
        '<link name="base"><visual><geometry><mesh filename="a b.stl"/></geometry></visual></link>',
    )
    context = ["https://w3id.org/kinlint/composable.json", "https://example.org/own.json"]
    graph = json.dumps({"@context": context, "@id": "https://e.org/x", "@type": "Frame"}, indent=1)
    own = tmp_path / "own.json"
    own.write_text('{"@context": {}}')
    files = {"cart.urdf": mesh, "a.jsonld": graph, "a b.stl": "solid"}
    model = Model(
        tmp_path,
        files,
        ["cart.urdf", "a.jsonld"],
        extra_contexts={"https://example.org/own.json": own},
    )
    texts = [str(tmp_path / name) for name in ("cart.urdf", "a.jsonld")]
    every = [each for name in texts for each in model.navigator.links(name)]
    found = {model.shown(each.location): each.target for each in every}
    assert found["cart.urdf:2: a b.stl"] == tmp_path / "a b.stl"
    assert found['a.jsonld:3: "https://w3id.org/kinlint/composable.json"'] == context[0]
    assert found['a.jsonld:4: "https://example.org/own.json"'] == own
