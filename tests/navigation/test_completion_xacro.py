"""Completion in xacro: macros, and names in expressions."""

import pytest
from completing import Typing
from navigating import NON_BMP

PARTS = f"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><!-- {NON_BMP} -->
  <xacro:property name="radius" value="0.05"/>
  <xacro:macro name="wheel" params="prefix width:=1 *pose">
    <link name="${{prefix}}_wheel"><visual><geometry><sphere radius="${{radius * width}}"/>
      </geometry></visual></link>
    <joint name="${{prefix}}_spin" type="continuous">
      <parent link="base"/><child link="${{prefix}}_wheel"/><xacro:insert_block name="pose"/>
    </joint>
  </xacro:macro>
</robot>
"""
CART = """<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:include filename="$(find cart)/urdf/parts.xacro"/>
  <link name="base"/>
  <xacro:wheel prefix="left"><origin xyz="0 1 0"/></xacro:wheel>
  <joint name="$(arg side)_flag" type="fixed"><parent link="base"/><child link="flag"/></joint>
  <link name="flag"/>
</robot>
"""


@pytest.fixture(scope="module")
def cart(tmp_path_factory):
    files = {
        "cart.urdf.xacro": CART,
        "urdf/parts.xacro": PARTS,
        "package.xml": "<package><name>cart</name></package>",
    }
    return Typing(tmp_path_factory.mktemp("cart"), files, ["cart.urdf.xacro"])


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    return Typing(tmp_path_factory.mktemp("parts"), {"parts.xacro": PARTS})


def test_names_that_macros_make_once_they_are_called(cart):
    found = cart.labels('cart.urdf.xacro: <child link="flag"/> => <child link="|')
    assert found == ["base", "flag", "left_wheel"]


def test_names_of_the_same_macro_as_they_are_written(parts):
    found = parts.labels('parts.xacro: <child link="${prefix}_wheel"/> => <child link="|')
    assert found[0] == "${prefix}_wheel"


def test_an_included_file_that_is_broken(tmp_path):
    """What the robot was when both files could be read is remembered."""
    files = {
        "cart.urdf.xacro": CART.replace("$(find cart)/urdf/", ""),
        "parts.xacro": PARTS,
    }
    typing = Typing(tmp_path, files, ["cart.urdf.xacro", "parts.xacro"])
    found = typing.labels('parts.xacro: <parent link="base"/> => <parent link="|')
    assert {"base", "flag", "left_wheel"} <= set(found)


def test_macros_as_elements(cart):
    found = cart.candidates('cart.urdf.xacro: <link name="base"/> => <xacro:wh|')
    wheel = next(each for each in found if each.label == "xacro:wheel")
    assert wheel.snippet == 'xacro:wheel prefix="$1">$0</xacro:wheel>'
    assert wheel.detail == "macro prefix width:=1 *pose"
    assert {"xacro:if", "link", "joint"} <= {each.label for each in found}


def test_parameters_as_attributes(cart):
    found = cart.candidates('cart.urdf.xacro: <xacro:wheel prefix="left"> => <xacro:wheel | ')
    assert [(each.label, each.detail) for each in found] == [
        ("prefix", "required"),
        ("width", "default 1"),
    ]


def test_names_in_expressions(parts, cart):
    found = parts.labels('parts.xacro: "${radius * width}" => "${radius * |')
    assert found[:3] == ["prefix", "width", "radius"]
    assert "sin" in found
    where = 'cart.urdf.xacro: <link name="base"/> => <link name="${|}"/>'
    assert cart.labels(where)[0] == "radius"
    assert "prefix" not in cart.labels(where)


def test_substitutions(cart):
    where = 'cart.urdf.xacro: <link name="base"/> => <link name="'
    assert "find" in cart.labels(f"{where}$(|")
    assert cart.labels(f"{where}$(arg |") == ["side"]
    assert cart.labels(f"{where}$(find |") == ["cart"]


def test_files_to_include(cart):
    where = 'cart.urdf.xacro: filename="$(find cart)/urdf/parts.xacro" => filename="'
    assert "$(find cart)/" in cart.labels(f"{where}|")
    assert "$(find cart)/urdf/" in cart.labels(f"{where}$(find cart)/|")
    assert cart.labels(f"{where}$(find cart)/urdf/p|") == ["$(find cart)/urdf/parts.xacro"]


def test_what_a_macro_may_hold(parts):
    found = parts.labels('parts.xacro: <parent link="base"/> => <|')
    assert "axis" in found
    found = parts.labels('parts.xacro: params="prefix width:=1 *pose"> => params="prefix *pose"><|')
    assert found.index("link") < found.index("inertia")


def test_blocks(parts):
    assert parts.labels('parts.xacro: insert_block name="pose" => insert_block name="|"') == [
        "pose"
    ]
