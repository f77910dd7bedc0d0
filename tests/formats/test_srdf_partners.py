"""An SRDF is joined to the URDF whose links and joints it names."""

from dataclasses import replace

import pytest

from kinlint.configuration.settings import Settings
from kinlint.files.pathglob import absolute
from kinlint.formats.dependencies.companions import pair, paired_among
from kinlint.formats.dependencies.joined_documents import JOINED_TO, join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.source_layer import src
from kinlint.terms import literal
from kinlint.text import SourceText

URDF = """
<robot name="{robot}">
  <!-- <link name="commented"/> -->
  <link name="{prefix}base"/><link name='{prefix}tip'/>
  <joint name="{prefix}elbow" type="continuous">
    <parent link="{prefix}base"/><child link="{prefix}tip"/>
  </joint>
</robot>"""
MORE = '<link name="hand"/></robot>'
SRDF = """
<robot name="{robot}">
  <group name="arm"><chain base_link="{prefix}base" tip_link="{prefix}tip"/></group>
  <passive_joint name="{prefix}elbow"/>
</robot>"""


def urdf(name, robot="arm", prefix=""):
    return SourceText(name, URDF.format(robot=robot, prefix=prefix))


def srdf(name, robot="arm", prefix=""):
    return SourceText(name, SRDF.format(robot=robot, prefix=prefix))


def find_companions(sources, configured=lambda _: None):
    """The URDF by which each SRDF is judged, by their names."""
    found = paired_among(sources, configured)
    return {name: pairing.partner for name, pairing in found.items() if pairing.certain}


def test_by_the_name_of_the_robot():
    """Others in the run are other robots."""
    sources = [srdf("a.srdf"), urdf("b.urdf", "leg"), urdf("c.urdf"), srdf("d.srdf", "leg")]
    assert find_companions(sources) == {"a.srdf": "c.urdf", "d.srdf": "b.urdf"}


def test_by_what_is_in_it():
    """Of robots of one name, the one that has the links; one that lacks most is another robot."""
    sources = [srdf("a.srdf", prefix="l_"), urdf("b.urdf"), urdf("c.urdf", prefix="l_")]
    assert find_companions(sources) == {"a.srdf": "c.urdf"}
    assert find_companions([srdf("a.srdf", prefix="r_"), *sources[1:]]) == {}


def test_the_nearest_of_several():
    """Equal ones are told apart by where they lie."""
    sources = [urdf("x/urdf/a.urdf"), urdf("y/urdf/a.urdf"), srdf("y/config/a.srdf")]
    assert find_companions(sources) == {"y/config/a.srdf": "y/urdf/a.urdf"}


@pytest.mark.parametrize(("robot", "prefix"), [("leg", ""), ("arm", "l_"), ("leg", "l_")])
def test_two_that_are_named_together_belong_together(robot, prefix):
    """Whatever they are called and whatever is in them."""
    sources = [srdf("a.srdf"), urdf("x/b.urdf", robot, prefix)]
    assert find_companions(sources) == {"a.srdf": "x/b.urdf"}


def test_as_told(tmp_path):
    """What is told counts most, even if it is not there."""
    sources = [srdf("a.srdf"), urdf("a.urdf"), urdf(f"{tmp_path}/b.urdf", "leg")]
    told = {"a.srdf": (tmp_path / "b.urdf").as_posix()}
    assert find_companions(sources, told.get) == {"a.srdf": f"{tmp_path}/b.urdf"}
    assert joined(sources[:2], told.get) == []


def test_what_is_not_expanded_is_no_partner():
    """Its names are not known."""
    assert find_companions([srdf("a.srdf"), urdf("a.urdf", prefix="${p}")]) == {}
    assert find_companions([srdf("a.srdf", prefix="${p}"), urdf("a.urdf")]) == {}


def joins(*sources):
    return joined(sources, {"a.srdf": absolute("a.urdf").as_posix()}.get)


def joined(sources, configured=lambda _: None):
    made = join_companions([read(source, ReadOptions()) for source in sources], configured)
    return [triple for each in made for triple in each.statements if triple[1] == JOINED_TO]


def test_the_roots_are_joined():
    """The statement stands in the document of the SRDF."""
    document = "urn:kinlint:document:"
    expected = (f"<{document}a.srdf#>", JOINED_TO, f"<{document}a.urdf#>")
    assert joins(srdf("a.srdf"), urdf("a.urdf")) == [expected]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.urdf", URDF.format(robot="arm", prefix="").replace('"continuous"', '"$(arg t)"')),
        ("a.srdf", SRDF.format(robot="arm", prefix="").replace('"arm"', '"${x}"')),
    ],
)
def test_what_is_incomplete_is_not_joined(name, text):
    """What is missing in a file of which a part was not read is nobody's fault."""
    texts = {"a.srdf": srdf("a.srdf"), "a.urdf": urdf("a.urdf"), name: SourceText(name, text)}
    assert joins(*texts.values()) == []


def test_other_documents_stay_as_they_are():
    """Nothing is said of them."""
    document = read(urdf("a.urdf"), ReadOptions())
    assert join_companions([document])[0] is document


def found(*sources):
    """The URDF files by which *sources*, found in a directory, are judged, and the doubts."""
    there = [replace(each, named=False) for each in sources]
    pairings = paired_among(there)
    return {name: (each.partner, each.others, each.certain) for name, each in pairings.items()}


def test_the_same_stem_counts_more_than_the_name_of_the_robot():
    """A name that was copied from another file is what is wrong, then."""
    copied = srdf("srdf/hands.srdf")
    same, other = urdf("robots/hands.urdf", "hands"), urdf("robots/arm.urdf")
    assert found(copied, same, other) == {"srdf/hands.srdf": ("robots/hands.urdf", (), True)}


def test_the_only_one_of_the_package_counts_more_than_the_name_of_the_robot():
    """Others of that name are in other packages."""
    sources = [srdf("x/srdf/a.srdf"), urdf("x/urdf/b.urdf", "leg"), urdf("y/urdf/a.urdf")]
    assert found(*sources) == {"x/srdf/a.srdf": ("x/urdf/b.urdf", (), True)}


def test_one_that_has_nothing_of_it_is_not_taken_for_being_the_only_one():
    """It is another robot."""
    assert found(srdf("a.srdf"), urdf("b.urdf", "leg", "l_")) == {}


def test_several_of_one_name_are_a_doubt():
    """What one of them has is not missing; how it hangs together, nobody knows."""
    more = urdf("c.urdf").text.replace("</robot>", '<link name="hand"/></robot>')
    told = srdf("a.srdf").text.replace("</robot>", '<passive_joint name="gone"/></robot>')
    told = told.replace('tip_link="tip"', 'tip_link="hand"')
    sources = [SourceText("a.srdf", told), urdf("b.urdf"), SourceText("c.urdf", more)]
    there = [replace(each, named=False) for each in sources]
    assert found(*sources) == {"a.srdf": ("c.urdf", ("b.urdf",), False)}
    documents = join_companions([read(each, ReadOptions()) for each in there])
    statements = [triple for each in documents for triple in each.statements]
    written = [o for _, p, o in statements if p == src("written")]
    assert written == [literal("gone")]
    assert not [triple for triple in statements if triple[1] == JOINED_TO]
    assert {o for _, p, o in statements if p == src("namesake")} == {
        literal("b.urdf"),
        literal("c.urdf"),
    }


def test_what_only_a_namesake_has_is_not_missing():
    """The robot with the same stem is one of several builds of it."""
    more = urdf("arm12.urdf").text.replace("</robot>", '<link name="hand"/></robot>')
    told = srdf("arm.srdf").text.replace('tip_link="tip"', 'tip_link="hand"')
    sources = [SourceText("arm.srdf", told), urdf("arm.urdf"), SourceText("arm12.urdf", more)]
    there = [replace(each, named=False) for each in sources]
    assert found(*sources) == {"arm.srdf": ("arm.urdf", ("arm12.urdf",), True)}
    documents = join_companions([read(each, ReadOptions()) for each in there])
    assert not [p for each in documents for _, p, _ in each.statements if p == src("dangling")]


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package with several robots of one name, and another beside it."""
    monkeypatch.chdir(tmp_path)
    files = [
        srdf("arm/srdf/arm.srdf"),
        urdf("arm/robots/arm.urdf"),
        SourceText("arm/robots/arm_hand.urdf", URDF.format(robot="arm", prefix="")[:-8] + MORE),
        srdf("moveit/config/leg.srdf", "leg"),
        SourceText("moveit/package.xml", "<package><name>moveit</name></package>"),
        urdf("description/urdf/one.urdf", "leg"),
    ]
    for each in files:
        path = tmp_path / each.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(each.text, encoding="utf-8")
    return {each.name: replace(each, named=False) for each in files if "xml" not in each.name}


@pytest.mark.parametrize("name", ["arm/srdf/arm.srdf", "moveit/config/leg.srdf"])
def test_the_robot_does_not_depend_on_what_was_searched(package, name):
    """A file alone, its directory, and all of them together."""
    home = name.rpartition("/")[0]
    for walk in ([name], [each for each in package if each.startswith(home)], [*package]):
        paired = pair([package[each] for each in walk], Settings())
        (one,) = (each for each in paired if each.name == name)
        assert one.pairing is not None
        assert absolute(one.pairing.partner) == absolute(
            {"arm/srdf/arm.srdf": "arm/robots/arm.urdf"}.get(name, "description/urdf/one.urdf")
        )
        assert one.pairing.certain
        assert [absolute(each).name for each in one.pairing.others] == (
            ["arm_hand.urdf"] if "arm" in name else []
        )
