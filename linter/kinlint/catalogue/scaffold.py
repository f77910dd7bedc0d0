"""The beginning of a rule file: all that a rule says, with what its author has to fill in."""

from __future__ import annotations

from collections.abc import Iterator
from string import Template
from typing import NamedTuple

from kinlint.formats.records import BY_NAME
from kinlint.vocabulary import COLLADA, METAMODELS, MJCF, SDF, SRDF, URDF, USD, YAML

MARK = "TODO:"
"""The mark of what is to be filled in; no rule is done that has it."""

_RULE = Template('''\
@prefix $prefix: <$namespace> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .

rule:$name a kl:Rule, sh:NodeShape ;
    kl:code "$code" ;
    rdfs:label "TODO: the fault in a few words, lower case" ;
    rdfs:comment """
        TODO: what breaks, in the robot, the simulator or the controller, in two sentences or more.
        """ ;
    kl:format "$formats" ;
    rdfs:seeAlso <https://example.org/> ;  # TODO: what the rule rests on

    sh:severity sh:Warning ;
    $target ;  # TODO: what it is about
    sh:sparql [
        sh:message "TODO: what is wrong with '{$$this}'." ;
        sh:select """
            SELECT $$this WHERE {
                # TODO: what a $thing is like that has the fault$pattern
                FILTER (false)
            }
            """ ] ;

    # [|...|] stands round what is to be flagged$where.
    kl:example [
        kl:bad """
$bad"""^^kl:$format ;
        kl:good """
$good"""^^kl:$format ] .
''')
_FAULT = "TODO: the fault"


class _Example(NamedTuple):
    """The examples of a format, and the rule that they are for."""

    formats: str
    """Format of the rule: that of the examples, or the one that stands for it."""
    vocabulary: tuple[str, str]
    """Prefix and namespace of its target."""
    target: str
    """Target of the rule."""
    thing: str
    """Word for a node that is a target."""
    text: str
    """Text of the examples, with `$id` for the name of the faulty thing."""
    bad: str = f"[|{_FAULT}|]"
    """Marked name in the bad example."""
    good: str = "elbow"
    """Name in the good example."""

    @property
    def where(self) -> str:
        """End of the sentence about what the marks stand round."""
        bare = f"[|{_FAULT}" in self.bad
        return ": of an element its name, without the quotes" if bare else ", with its quotes"


_JOINT = (("kc", f"{METAMODELS}kinematic-chain/structural-entities#"), "sh:targetClass kc:Joint")
_LINKED = """\
              <link name="base"/>
              <link name="arm"/>
              <joint name="$id" type="fixed">
                <parent link="base"/>
                <child link="arm"/>
              </joint>
            </robot>"""
EXAMPLES = {
    "jsonld": _Example(
        "graph",
        *_JOINT,
        "joint",
        """\
            {
              "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
              "@id": $id,
              "@type": "Joint"
            }""",
        f'[|"ex:{_FAULT}"|]',
        '"ex:elbow"',
    ),
    "turtle": _Example(
        "graph",
        *_JOINT,
        "joint",
        """\
            @prefix kc: <"""
        + _JOINT[0][1]
        + """> .
            @prefix ex: <https://example.org/arm#> .
            $id a kc:Joint .""",
        f"[|ex:elbow|]  # {_FAULT}\n              ",
        "ex:elbow",
    ),
    "urdf": _Example(
        "urdf",
        ("urdf", URDF),
        "sh:targetObjectsOf urdf:joint",
        "joint",
        '            <robot name="arm">\n' + _LINKED,
    ),
    "xacro": _Example(
        "urdf",
        ("urdf", URDF),
        "sh:targetObjectsOf urdf:joint",
        "joint",
        '            <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">\n' + _LINKED,
    ),
    "srdf": _Example(
        "srdf",
        ("srdf", SRDF),
        "sh:targetObjectsOf srdf:group",
        "group",
        """\
            <robot name="arm">
              <group name="$id">
                <joint name="shoulder"/>
              </group>
            </robot>""",
    ),
    "sdf": _Example(
        "sdf",
        ("sdf", SDF),
        "sh:targetObjectsOf sdf:joint",
        "joint",
        """\
            <sdf version="1.9">
              <model name="arm">
                <link name="base"/>
                <link name="tip"/>
                <joint name="$id" type="fixed">
                  <parent>base</parent>
                  <child>tip</child>
                </joint>
              </model>
            </sdf>""",
    ),
    "mjcf": _Example(
        "mjcf",
        ("mjcf", MJCF),
        "sh:targetObjectsOf mjcf:joint",
        "joint",
        """\
            <mujoco model="arm">
              <worldbody>
                <body name="forearm">
                  <joint name="$id"/>
                  <geom size="0.1"/>
                </body>
              </worldbody>
            </mujoco>""",
    ),
    "collada": _Example(
        "collada",
        ("collada", COLLADA),
        "sh:targetObjectsOf collada:joint",
        "joint",
        """\
            <COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
              <asset/>
              <library_joints>
                <joint name="$id"><revolute sid="axis"><axis>0 0 1</axis></revolute></joint>
              </library_joints>
            </COLLADA>""",
    ),
    "usd": _Example(
        "usd",
        ("usd", USD),
        "sh:targetObjectsOf usd:prim",
        "prim",
        """\
            #usda 1.0
            def Xform $id
            {
            }""",
        f'[|"elbow"|]  # {_FAULT}',
        '"elbow"',
    ),
    "yaml": _Example(
        "yaml",
        ("yaml", YAML),
        "sh:targetObjectsOf yaml:joint_limit",
        "joint",
        """\
            joint_limits:
              $id:
                has_velocity_limits: true""",
        f'"[|{_FAULT}|]"',
    ),
}
"""The examples for each format."""


def scaffold(name: str, code: str, form: str) -> str:
    """Return the text of a file for the rule *name* with examples in the format *form*."""
    example = EXAMPLES[form]
    text = Template(example.text)
    tree = BY_NAME[form].is_tree
    prefix, namespace = example.vocabulary
    return _RULE.substitute(
        name=name,
        code=code,
        prefix=prefix,
        namespace=namespace,
        target=example.target,
        thing=example.thing,
        pattern="\n                $this at:name [] ." if tree else "",
        where=example.where,
        formats=example.formats,
        format=form,
        bad=text.substitute(id=example.bad),
        good=text.substitute(id=example.good),
    )


def unfilled(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines of *text*, counted from one, that wait for being filled in."""
    for number, line in enumerate(text.splitlines(), 1):
        if MARK in line:
            yield number, line.strip()
