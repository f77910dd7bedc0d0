"""Folding and selection in texts, whole or half-written, and names of a workspace."""

from itertools import pairwise

import pytest

from kinlint.navigation.text_structure import parts, selections
from kinlint.navigation.workspace_names import workspace_names
from kinlint.text import SourceText

URDF = """<robot name="leg">
  <!-- the
       parts -->
  <link name="hip"/>
  <joint name="knee" type="revolute">
    <parent link="hip"/>
  </joint>
</robot>
"""
JSON = """{
  "@graph": [
    { "@id": "ex:a", "@type": "Frame",
      "origin": "ex:o" }
  ]
}
"""
TURTLE = """@prefix ex: <https://example.org/#> .

ex:a a ex:Frame ;
    ex:origin ex:o .
ex:o a ex:Point .
"""
XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="a" value="0.5"/>
  <xacro:macro name="m" params="n"><link name="${n}_l"/></xacro:macro>
</robot>
"""
SDF = '<sdf version="1.9"><model name="m"><link name="l"/><frame name="f"/></model></sdf>'
SRDF = '<robot name="leg"><group name="all"><link name="hip"/></group></robot>'


def lines(name, text):
    source = SourceText(name, text)
    found = [tuple(source.position(each).line for each in part.span) for part in parts(source)]
    return [each for each in found if each[0] < each[1]]


def test_what_can_be_folded():
    assert lines("leg.urdf", URDF) == [(1, 8), (2, 3), (5, 7)]
    assert lines("arm.jsonld", JSON) == [(1, 6), (2, 5), (3, 4)]
    assert lines("arm.ttl", TURTLE) == [(3, 4)]


def test_a_text_that_is_not_finished():
    assert lines("leg.urdf", URDF.replace("</joint>", "<par")) == [(1, 8), (2, 3), (5, 8)]
    assert lines("arm.jsonld", JSON.replace('"ex:o" }', '"ex:')) == [(1, 6), (2, 5), (3, 5)]


@pytest.mark.parametrize(
    ("name", "text", "mark", "wanted"),
    [
        (
            "leg.urdf",
            URDF,
            'link="hip"/>\n  </',
            ["hip", '"hip"', '<parent link="hip"/>', '\n    <parent link="hip"/>\n  '],
        ),
        ("arm.jsonld", JSON, 'ex:o"', ["ex:o", '"ex:o"']),
        ("arm.ttl", TURTLE, "ex:origin", ["ex:origin", "ex:a a ex:Frame ;\n    ex:origin ex:o ."]),
    ],
)
def test_selections_grow(name, text, mark, wanted):
    offset = text.index(mark) + (mark.index("hip") + 1 if "hip" in mark else 1)
    spans = selections(SourceText(name, text), offset)
    assert [text[slice(*each)] for each in spans][: len(wanted)] == wanted
    assert spans[-1] == (0, len(text))
    assert all(b.start <= a.start and a.end <= b.end for a, b in pairwise(spans))


@pytest.mark.parametrize(
    ("name", "text", "wanted"),
    [
        (
            "leg.urdf",
            URDF,
            [("leg", "robot", ""), ("hip", "link", "leg"), ("knee", "joint", "leg")],
        ),
        ("leg.srdf", SRDF, [("leg", "robot", ""), ("all", "group", "leg")]),
        (
            "r.xacro",
            XACRO,
            [
                ("r", "robot", ""),
                ("a", "property", "r"),
                ("m", "macro", "r"),
                ("${n}_l", "link", "m"),
            ],
        ),
        ("m.sdf", SDF, [("m", "model", ""), ("l", "link", "m"), ("f", "frame", "m")]),
        ("arm.jsonld", JSON, [("ex:a", "Frame", "")]),
        ("arm.ttl", TURTLE, [("ex:a", "Frame", ""), ("ex:o", "Point", "")]),
    ],
)
def test_names_of_a_text(name, text, wanted):
    found = list(workspace_names(SourceText(name, text)))
    assert [(each.name, each.kind, each.holder) for each in found] == wanted
    for each in found:
        assert each.location.source[each.location.span] == each.name
    assert found[0].fits(found[0].name[0].upper())
    assert not found[0].fits("zzz")
