"""An SRDF is joined to the URDF whose links and joints it names."""

import pytest

from kinlint.files.pathglob import absolute
from kinlint.formats.dependencies.companions import JOINED_TO, find_companions, join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText

URDF = """
<robot name="{robot}">
  <!-- <link name="commented"/> -->
  <link name="{prefix}base"/><link name='{prefix}tip'/>
  <joint name="{prefix}elbow" type="continuous">
    <parent link="{prefix}base"/><child link="{prefix}tip"/>
  </joint>
</robot>"""
SRDF = """
<robot name="{robot}">
  <group name="arm"><chain base_link="{prefix}base" tip_link="{prefix}tip"/></group>
  <passive_joint name="{prefix}elbow"/>
</robot>"""


def urdf(name, robot="arm", prefix=""):
    return SourceText(name, URDF.format(robot=robot, prefix=prefix))


def srdf(name, robot="arm", prefix=""):
    return SourceText(name, SRDF.format(robot=robot, prefix=prefix))


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


@pytest.mark.parametrize(
    ("robot", "prefix", "joined"),
    [("leg", "", True), ("arm", "l_", True), ("leg", "l_", False)],
)
def test_two_alone_belong_together(robot, prefix, joined):
    """If the robot's name or the links agree."""
    sources = [srdf("a.srdf"), urdf("a.urdf", robot, prefix)]
    assert find_companions(sources) == ({"a.srdf": "a.urdf"} if joined else {})


def test_as_told(tmp_path):
    """What is told counts most, even if it is not there."""
    sources = [srdf("a.srdf"), urdf("a.urdf"), urdf(f"{tmp_path}/b.urdf", "leg")]
    told = {"a.srdf": (tmp_path / "b.urdf").as_posix()}
    assert find_companions(sources, told.get) == {"a.srdf": f"{tmp_path}/b.urdf"}
    assert find_companions(sources[:2], told.get) == {}


def test_what_is_not_expanded_is_no_partner():
    """Its names are not known."""
    assert find_companions([srdf("a.srdf"), urdf("a.urdf", prefix="${p}")]) == {}
    assert find_companions([srdf("a.srdf", prefix="${p}"), urdf("a.urdf")]) == {}


def joins(*sources):
    documents = [read(source, ReadOptions()) for source in sources]
    made = join_companions(documents, {"a.srdf": absolute("a.urdf").as_posix()}.get)
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
