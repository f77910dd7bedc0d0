"""Renaming: every place of a name changes, and nothing else that the model says."""

import pytest
from navigating import NON_BMP, Model
from support.linting import book

from kinlint import lint
from kinlint.configuration.settings import Settings
from kinlint.edits import Edit, applied
from kinlint.fixes.texts import Texts
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.text import SourceText

URDF = f"""<robot name="leg"><!-- {NON_BMP} -->
  <link name="hip"/>
  <link name="shin"><visual name="shin"/></link>
  <joint name="shin" type="revolute"><parent link="hip"/><child link="shin"/></joint>
  <gazebo reference="hip"/>
</robot>
"""
SRDF = f"""<robot name="leg"><!-- {NON_BMP} -->
  <group name="all"><link name="shin"/><joint name="shin"/></group>
  <group_state name="home" group="all"><joint name="shin" value="0"/></group_state>
  <disable_collisions link1="hip" link2="shin" reason="Adjacent"/>
</robot>
"""
PARTS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="radius" value="0.05"/>
  <xacro:macro name="wheel" params="prefix width:=1 *pose">
    <link name="${prefix}_wheel"><visual><geometry><sphere radius="${radius * width}"/></geometry>
      </visual></link>
    <joint name="${prefix}_spin" type="continuous">
      <parent link="base"/><child link="${prefix}_wheel"/><xacro:insert_block name="pose"/>
    </joint>
  </xacro:macro>
</robot>
"""
CART = """<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:include filename="parts.xacro"/>
  <link name="base"/>
  <xacro:wheel prefix="left"><origin xyz="0 ${radius} 0"/></xacro:wheel>
  <xacro:wheel prefix='right' width="2"><origin xyz="0 1 0"/></xacro:wheel>
</robot>
"""
WORLD = """<sdf version="1.9">
  <world name="hall">
    <include><uri>box.sdf</uri></include>
    <model name="arm">
      <link name="base"/>
      <model name="hand"><link name="palm"/></model>
      <joint name="wrist" type="fixed"><parent>base</parent><child>hand::palm</child></joint>
    </model>
    <frame name="table" attached_to="arm::hand::palm"/>
    <frame name="side" attached_to="box::side"/>
  </world>
</sdf>
"""
BOX = """<sdf version="1.9">
  <model name="box"><link name="side"><pose relative_to="__model__">0 0 0 0 0 0</pose></link>
  </model>
</sdf>
"""
JSON = """{
  "@context": [
    "https://w3id.org/kinlint/composable.json",
    { "ex": "https://example.org/arm#", "arm": "https://example.org/" }
  ],
  "@graph": [
    { "@id": "ex:base", "@type": "Frame", "origin": "https://example.org/arm#base-origin" },
    { "@id": "ex:base-origin", "@type": "Point", "simplices": ["arm:arm#base"] },
    { "@id": "ex:p", "@type": ["PositionReference"], "as-seen-by": {"@id": "ex:base"} }
  ]
}
"""


class Renamed(Model):
    """A model in which something is renamed."""

    def __init__(self, folder, files, given=()) -> None:
        super().__init__(folder, files, given)
        self.given = given or tuple(files)
        self.ours = folder

    def rename(self, where: str, new: str) -> dict[str, str]:
        """The texts that differ once what is named at *where* is called *new*."""
        renamer = self.navigator.renamer(lambda path: path.is_relative_to(self.ours))
        renaming, span = renamer.prepare(*self._asked(where))
        name, _ = self._asked(where)
        assert self.files[self.own(name)][slice(*span)] in renaming.name
        texts = [SourceText(str(self.folder / name), self.files[name]) for name in self.given]
        edits = renamer.edits(renaming, new, self.examination, Texts(texts), Settings())
        changed: dict[str, list[Edit]] = {}
        for each in edits:
            own = self.own(each.location.source.name)
            changed.setdefault(own, []).append(Edit(each.location.span, each.text))
        return {name: applied(self.files[name], own) for name, own in changed.items()}

    def refused(self, where: str, new: str = "other") -> str:
        with pytest.raises(NotRenamable) as error:
            self.rename(where, new)
        return str(error.value)


@pytest.fixture
def leg(tmp_path):
    return Renamed(tmp_path, {"leg.urdf": URDF, "leg.srdf": SRDF})


def test_a_link_is_renamed_in_urdf_and_srdf(leg):
    """The joint and the visual of the same name keep theirs."""
    found = leg.rename('leg.urdf: <link name="sh|in">', "calf")
    assert found == {
        "leg.urdf": URDF.replace('<link name="shin"', '<link name="calf"').replace(
            'child link="shin"', 'child link="calf"'
        ),
        "leg.srdf": SRDF.replace('<link name="shin"', '<link name="calf"').replace(
            'link2="shin"', 'link2="calf"'
        ),
    }


def test_a_joint_and_a_group(leg):
    found = leg.rename('leg.srdf: <group name="all"><link name="shin"/><joint name="|shin"', "knee")
    assert found["leg.urdf"] == URDF.replace('joint name="shin"', 'joint name="knee"')
    assert found["leg.srdf"] == SRDF.replace('joint name="shin"', 'joint name="knee"')
    found = leg.rename('leg.srdf: group="a|ll"', "every part")
    assert found == {"leg.srdf": SRDF.replace('"all"', '"every part"')}


def test_a_joint_in_yaml(tmp_path):
    limits = "joint_limits:\n  shin:\n    has_velocity_limits: true\n    max_velocity: 1.0\n"
    model = Renamed(tmp_path, {"leg.urdf": URDF, "joint_limits.yaml": limits})
    found = model.rename('leg.urdf: <joint name="sh|in"', "knee")
    assert found["joint_limits.yaml"] == limits.replace("shin", "knee")


MJCF = """<mujoco>
  <worldbody><body name="torso"><joint name="hip"/><geom size="1"/></body></worldbody>
  <actuator><motor name="hip" joint="hip" gear="100"/></actuator>
  <sensor><framepos objtype="body" objname="torso"/></sensor>
</mujoco>
"""


def test_names_of_mjcf(tmp_path):
    """An actuator keeps the name that its joint has, too; sensors say what kind they name."""
    model = Renamed(tmp_path, {"w.xml": MJCF})
    found = model.rename('w.xml: joint name="h|ip"', "knee")
    assert found == {
        "w.xml": MJCF.replace('joint name="hip"', 'joint name="knee"').replace(
            'joint="hip"', 'joint="knee"'
        )
    }
    found = model.rename('w.xml: objname="tor|so"', "trunk")
    assert found == {"w.xml": MJCF.replace("torso", "trunk")}


CLASSES = """<mujoco>
  <default><default class="leg"><geom size="1"/><default class="foot"/></default></default>
  <worldbody>
    <body name="leg" childclass="leg"><geom class="leg"/><geom class="foot"/></body>
  </worldbody>
</mujoco>
"""


def test_a_default_class_of_mjcf(tmp_path):
    """The body of its name keeps it."""
    model = Renamed(tmp_path, {"w.xml": CLASSES})
    found = model.rename('w.xml: geom class="l|eg"', "shank")
    assert found == {"w.xml": CLASSES.replace('class="leg"', 'class="shank"')}
    assert model.refused('w.xml: default class="f|oot"', "leg") == "class 'leg' exists already"
    assert "default class" in model.hover('w.xml: childclass="l|eg"')


def test_refused_names(leg):
    where = 'leg.urdf: <link name="sh|in">'
    assert leg.refused(where, "hip") == "link 'hip' exists already"
    assert leg.refused(where, 'a"b') == "'a\"b' cannot be the name of a link"
    assert leg.refused(where, "") == "'' cannot be the name of a link"
    leg.ours = leg.folder / "elsewhere"
    assert "outside of the workspace" in leg.refused(where)


@pytest.fixture
def cart(tmp_path):
    files = {"cart.urdf.xacro": CART, "parts.xacro": PARTS}
    return Renamed(tmp_path, files, ["cart.urdf.xacro"])


def test_a_macro_with_its_calls(cart):
    found = cart.rename('parts.xacro: <xacro:macro name="whe|el"', "roller")
    assert found == {
        "cart.urdf.xacro": CART.replace("xacro:wheel", "xacro:roller"),
        "parts.xacro": PARTS.replace('macro name="wheel"', 'macro name="roller"'),
    }


def test_parameters_blocks_and_properties(cart):
    found = cart.rename('parts.xacro: params="pre|fix', "side")
    assert found == {
        "cart.urdf.xacro": CART.replace("prefix=", "side="),
        "parts.xacro": PARTS.replace("prefix", "side"),
    }
    found = cart.rename('parts.xacro: *po|se">', "place")
    assert found == {"parts.xacro": PARTS.replace("pose", "place")}
    found = cart.rename("cart.urdf.xacro: ${rad|ius}", "r")
    assert found == {
        "cart.urdf.xacro": CART.replace("${radius}", "${r}"),
        "parts.xacro": PARTS.replace('name="radius"', 'name="r"').replace("${radius", "${r"),
    }


def test_a_literal_name_in_xacro(cart):
    found = cart.rename('cart.urdf.xacro: <link name="ba|se"/>', "frame")
    assert found["parts.xacro"] == PARTS.replace('link="base"', 'link="frame"')


def test_names_of_which_a_prefix_is_computed(tmp_path):
    """What a macro makes at its other calls is renamed alike, wherever it is named."""
    srdf = '<robot name="cart"><group name="{0}">{1}</group></robot>'
    group = srdf.format("all", '<link name="left_wheel"/><link name="right_wheel"/>')
    files = {"cart.urdf.xacro": CART, "parts.xacro": PARTS, "cart.srdf": group}
    cart = Renamed(tmp_path, files, ["cart.urdf.xacro", "cart.srdf"])
    made = {
        "parts.xacro": PARTS.replace("}_wheel", "}_roller"),
        "cart.srdf": group.replace("_wheel", "_roller"),
    }
    assert cart.rename('parts.xacro: <link name="${prefix}_wh|eel">', "left_roller") == made
    assert cart.rename('cart.srdf: "right_wh|eel"', "right_roller") == made
    assert "begins with 'right'" in cart.refused('cart.srdf: "right_wh|eel"', "roller")
    assert "exists already" not in cart.refused('cart.srdf: "right_wh|eel"', "right")


def test_a_name_of_nothing_but_what_is_computed(tmp_path):
    """It is refused, with the place where it is put together."""
    text = """<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:property name="p" value="base"/><link name="${p}"/><link name="tip"/>
      <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint></robot>"""
    robot = Renamed(tmp_path, {"a.xacro": text})
    assert "is put together by '${p}' at" in robot.refused('a.xacro: <parent link="ba|se"/>')


def test_what_is_not_safe_in_xacro(cart):
    reason = cart.refused('parts.xacro: <link name="${prefix}_wh|eel">')
    assert "begins with 'left', which is computed at" in reason
    assert "parts.xacro:4" in reason
    assert "launch files" in cart.refused('cart.urdf.xacro: <xacro:arg name="si|de"')
    assert "exists already" in cart.refused('parts.xacro: params="pre|fix', "width")
    assert "cannot be" in cart.refused('parts.xacro: params="pre|fix', "a b")


def test_a_property_that_another_name_would_hide(cart):
    """In the macro, the property would be taken for the parameter."""
    assert "meaning would change" in cart.refused("cart.urdf.xacro: ${rad|ius}", "width")


@pytest.fixture
def hall(tmp_path):
    return Renamed(tmp_path, {"hall.world": WORLD, "box.sdf": BOX})


def test_nested_models_in_sdf(hall):
    found = hall.rename('hall.world: <link name="pa|lm"/>', "grip")
    assert found == {"hall.world": WORLD.replace("palm", "grip")}
    found = hall.rename('hall.world: <model name="ha|nd">', "tool")
    assert found == {"hall.world": WORLD.replace("hand", "tool")}
    found = hall.rename('hall.world: <model name="a|rm">', "robot")
    assert found["hall.world"] == WORLD.replace('"arm', '"robot')


def test_a_link_of_an_included_model(hall):
    found = hall.rename('box.sdf: <link name="si|de">', "wall")
    assert found == {
        "box.sdf": BOX.replace('"side"', '"wall"'),
        "hall.world": WORLD.replace("box::side", "box::wall"),
    }


def test_nodes_of_json_ld(tmp_path):
    model = Renamed(tmp_path, {"arm.jsonld": JSON})
    found = model.rename('arm.jsonld: { "@id": "ex:ba|se", "@type": "Frame"', "root")
    assert found == {
        "arm.jsonld": JSON.replace('"ex:base"', '"ex:root"').replace('arm#base"', 'arm#root"')
    }
    for whole in ("ex:root", "https://example.org/arm#root"):
        assert model.rename('arm.jsonld: { "@id": "ex:ba|se", "@type": "Frame"', whole) == found
    assert "cannot be" in model.refused('arm.jsonld: "@id": "ex:|p"', "other:q")
    assert "exists already" in model.refused('arm.jsonld: "@id": "ex:|p"', "base")
    assert "described in no file" in model.refused('arm.jsonld: "Po|int"')
    assert "cannot be" in model.refused('arm.jsonld: "@id": "ex:|p"', "a b")


def test_the_model_is_the_same_but_for_the_name(leg, tmp_path):
    texts = {**leg.files, **leg.rename('leg.urdf: <link name="sh|in">', "calf")}
    sources = [SourceText(str(tmp_path / name), text) for name, text in texts.items()]
    again = lint.examine(sources, [], Settings(), book())
    before = {each for one in leg.examination.documents for each in one.statements}
    after = {each for one in again.documents for each in one.statements}
    gone = {each for triple in before - after for each in triple}
    assert any("link/shin" in each for each in gone)
    assert all("shin" in " ".join(triple) or "offset" in triple[1] for triple in before - after)
    assert all("calf" in " ".join(triple) or "offset" in triple[1] for triple in after - before)
