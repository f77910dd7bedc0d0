"""What xacro defines, and what is left of it in the robot."""

import pytest
from navigating import NON_BMP, Model

PARTS = f"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><!-- {NON_BMP} -->
  <xacro:property name="r" value="0.05"/>
  <xacro:macro name="wheel" params="prefix r2:=1 *pose">
    <link name="${{prefix}}_wheel"><visual><geometry><sphere radius="${{r * r2}}"/></geometry>
      </visual></link>
    <joint name="${{prefix}}_spin" type="continuous">
      <parent link="base"/><child link="${{prefix}}_wheel"/><xacro:insert_block name="pose"/>
    </joint>
  </xacro:macro>
</robot>
"""
MAIN = f"""<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:include filename="$(find cart)/parts.xacro"/>
  <link name="base"/><!-- {NON_BMP} -->
  <xacro:wheel prefix="left"><origin xyz="0 ${{r}} 0"/></xacro:wheel>
  <xacro:wheel prefix="right"><origin xyz="0 -1 0"/></xacro:wheel>
  <link name="$(arg side)_flag"/>
</robot>
"""
SRDF = '<robot name="cart"><group name="g"><joint name="left_spin"/></group></robot>'
PACKAGE = "<package><name>cart</name></package>"


@pytest.fixture
def cart(tmp_path):
    files = {
        "cart.urdf.xacro": MAIN,
        "parts.xacro": PARTS,
        "package.xml": PACKAGE,
        "cart.srdf": SRDF,
    }
    return Model(tmp_path, files, ["cart.urdf.xacro", "cart.srdf"])


def test_a_call_leads_to_the_macro_in_the_included_file(cart):
    where = 'cart.urdf.xacro: <xacro:wh|eel prefix="left"'
    assert cart.definitions(where) == ["parts.xacro:3: wheel"]
    assert "params=" in cart.hover(where)


def test_a_macro_leads_to_its_calls(cart):
    found = cart.references('parts.xacro: <xacro:macro name="whe|el"')
    assert found == ["cart.urdf.xacro:5: wheel", "cart.urdf.xacro:6: wheel"]


def test_properties_and_parameters_are_told_apart(cart):
    """`r` is a property of the file, `r2` a parameter of the macro."""
    assert cart.definitions("parts.xacro: ${|r * r2}") == ["parts.xacro:2: r"]
    assert cart.definitions("parts.xacro: ${r * r|2}") == ["parts.xacro:3: r2"]
    assert cart.definitions("cart.urdf.xacro: ${r|}") == ["parts.xacro:2: r"]


def test_blocks_and_arguments(cart):
    assert cart.definitions('parts.xacro: insert_block name="po|se"') == ["parts.xacro:3: pose"]
    assert cart.definitions("cart.urdf.xacro: $(arg si|de)_flag") == ["cart.urdf.xacro:2: side"]


def test_the_name_of_an_included_file_leads_to_it(cart):
    assert cart.definitions('cart.urdf.xacro: filename="$(find cart)/pa|rts') == ["parts.xacro:1: "]


def test_an_srdf_leads_into_the_included_file(cart):
    """The joint is made by a macro, so its name is only half there."""
    found = cart.definitions('cart.srdf: name="left_sp|in"')
    assert found == ["parts.xacro:6: ${prefix}_spin"]
    assert cart.references('parts.xacro: <joint name="${prefix}_sp|in"') == [
        "cart.srdf:1: left_spin"
    ]


def test_a_name_in_a_macro_is_all_that_it_becomes(cart):
    shown = cart.hover('parts.xacro: <link name="${prefix}_wh|eel"')
    assert "**link left_wheel**" in shown
    assert "**link right_wheel**" in shown


def test_broken_xacro_is_answered_with_nothing(tmp_path):
    model = Model(tmp_path, {"a.urdf.xacro": MAIN.replace("</robot>", "")})
    assert model.definitions('a.urdf.xacro: <xacro:wh|eel prefix="left"') == []


def test_a_file_that_is_called_in_two_ways_is_one(tmp_path):
    """The robot says `../parts.xacro`, and the file itself is read, too."""
    main = MAIN.replace("$(find cart)/parts.xacro", "../b/../parts.xacro")
    (tmp_path / "b").mkdir()
    files = {"a/cart.urdf.xacro": main, "parts.xacro": PARTS}
    model = Model(tmp_path, files)
    assert model.definitions('a/cart.urdf.xacro: <xacro:wh|eel prefix="left"') == [
        "parts.xacro:3: wheel"
    ]
    found = model.references('parts.xacro: <xacro:macro name="whe|el"')
    assert found == ["a/cart.urdf.xacro:5: wheel", "a/cart.urdf.xacro:6: wheel"]
