"""SRDF, SDF, Turtle and JSON-LD files that grow in one respect."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable
from typing import Any

from benchmarks import robot
from benchmarks.growth.growing import Growing, numbered

Text = Callable[[int], str]
Node = dict[str, Any]
AXIS = "<axis><xyz>0 0 1</xyz></axis>"
CONTEXT = [*robot.CONTEXTS, {"rob": "https://example.org/chain#"}]


def srdf(line: str, after: str = "") -> Text:
    """Return the SRDF with numbered copies of *line*, and *after* them."""
    return lambda count: f'<robot name="r">\n{numbered(line, count)}{after}</robot>\n'


def sdf(line: str) -> Text:
    """Return the model of a link and numbered copies of *line*."""
    return lambda count: _model(f'<link name="l"/>\n{numbered(line, count)}')


def jointed(*, closed: bool = False) -> Text:
    """Return the model of a chain of links, or of a ring."""

    def text(count: int) -> str:
        joints = "".join(
            f'<joint name="j{n}" type="revolute"><parent>k{n}</parent>'
            f"<child>k{(n + 1) % count}</child>{AXIS}</joint>\n"
            for n in range(count if closed else count - 1)
        )
        return _model(numbered('<link name="k@"/>', count) + joints)

    return text


def framed(other: Callable[[int, int], object], kind: str = "frame") -> Text:
    """Return the model whose frames or links lie in the *other* for their number and all's."""

    def text(count: int) -> str:
        return _model(
            '<link name="k-1"/>\n'
            + "".join(
                f'<{kind} name="k{n}"><pose relative_to="k{other(n, count)}">1 0 0 0 0 0</pose>'
                f"</{kind}>\n"
                for n in range(count)
            )
        )

    return text


def graph(nodes: Callable[[int], Iterable[Node]]) -> Text:
    """Return the JSON-LD document with *nodes*."""
    return lambda count: json.dumps({"@context": CONTEXT, "@graph": [*nodes(count)]}, indent=1)


def turtle(text: Text) -> Text:
    """Return *text* after its prefix."""
    return lambda count: f"@prefix ex: <https://example.org/> .\n{text(count)}\n"


def _model(content: str) -> str:
    return f'<sdf version="1.11">\n<model name="m">\n{content}</model>\n</sdf>\n'


def _ring(count: int) -> list[Node]:
    """The chain whose last joint leads back to its first body."""
    return _rejoined(count, f"rob:joint{count - 1}", f"rob:link{count}-")


def _star(count: int) -> list[Node]:
    """The chain whose joints all begin at its first body."""
    return _rejoined(count, "rob:joint", r"rob:link\d+-tip", "rob:link0-tip")


def _rejoined(count: int, joints: str, old: str, new: str = "rob:link0-") -> list[Node]:
    """The chain whose *joints* have *new* for *old*."""
    nodes = json.loads(robot.chain(count))["@graph"]
    return [
        json.loads(re.sub(old, new, json.dumps(node))) if node["@id"].startswith(joints) else node
        for node in nodes
    ]


def _quantities(count: int) -> Iterable[Node]:
    """Limits whose quantities have a unit each of four kinds."""
    for number in range(count):
        yield {
            "@id": f"rob:limit{number}",
            "@type": "JointPositionLimit",
            "quantity-kind": "Angle",
            "unit": ("RAD", "DEG", "M", "KiloGM")[number % 4],
            "lower": 1.0,
            "upper": -1.0,
        }


INPUTS: tuple[tuple[str, str, Text, int], ...] = (
    (
        "SRDF: disabled collisions",
        "r.srdf",
        srdf('<disable_collisions link1="a@" link2="b@" reason="Never"/>'),
        500,
    ),
    (
        "SRDF: one pair disabled again",
        "r.srdf",
        srdf('<disable_collisions link1="a" link2="b" reason="Never"/>'),
        500,
    ),
    (
        "SRDF: groups in groups",
        "r.srdf",
        lambda n: srdf(
            "", "".join(f'<group name="g{k}"><group name="g{k - 1}"/></group>\n' for k in range(n))
        )(0),
        500,
    ),
    (
        "SRDF: groups twice in groups",
        "r.srdf",
        lambda n: srdf(
            "",
            "".join(
                f'<group name="g{k}"><group name="g{k - 1}"/><group name="g{k - 1}"/></group>\n'
                for k in range(n)
            ),
        )(0),
        250,
    ),
    (
        "SRDF: states",
        "r.srdf",
        srdf('<group_state name="s@" group="g"><joint name="j" value="@"/></group_state>'),
        500,
    ),
    (
        "SRDF: links of a group",
        "r.srdf",
        lambda n: srdf(
            "", "<group>".replace(">", ' name="g">') + numbered('<link name="l@"/>', n) + "</group>"
        )(0),
        1000,
    ),
    ("SDF: chain", "m.sdf", jointed(), 250),
    ("SDF: ring", "m.sdf", jointed(closed=True), 250),
    ("SDF: frames", "m.sdf", framed(lambda k, _: k - 1), 250),
    (
        "SDF: frames, the last one first",
        "m.sdf",
        framed(lambda k, n: k + 1 if k < n - 1 else -1),
        250,
    ),
    ("SDF: ring of frames", "m.sdf", framed(lambda k, n: (k + 1) % n), 250),
    ("SDF: links that lie in each other", "m.sdf", framed(lambda k, _: k - 1, "link"), 250),
    ("SDF: missing frames", "m.sdf", framed(lambda k, _: f"{k}-missing"), 250),
    ("SDF: missing frames of links", "m.sdf", framed(lambda k, _: f"{k}-missing", "link"), 250),
    ("SDF: links", "m.sdf", sdf('<link name="k@"/>'), 500),
    (
        "SDF: models",
        "m.sdf",
        sdf('<model name="n@"><link name="l"><pose>@ 0 0 0 0 0</pose></link></model>'),
        150,
    ),
    (
        "JSON-LD: one ring",
        "r.jsonld",
        graph(_ring),
        50,
    ),
    ("JSON-LD: star of joints", "r.jsonld", graph(_star), 50),
    (
        "JSON-LD: copies of one node",
        "r.jsonld",
        graph(lambda n: [{"@id": "rob:p", "@type": "Point"}] * n),
        250,
    ),
    (
        "JSON-LD: errors",
        "r.jsonld",
        graph(lambda n: [{"@id": f"rob:f{k}", "@type": "Frame", "origin": "p"} for k in range(n)]),
        250,
    ),
    (
        "JSON-LD: values of one functional property",
        "r.jsonld",
        graph(
            lambda n: [
                {
                    "@id": "rob:f",
                    "@type": ["3D", "Euclidean", "Frame"],
                    "origin": [f"rob:p{k}" for k in range(n)],
                }
            ]
        ),
        250,
    ),
    (
        "JSON-LD: graphs that nobody describes",
        "r.jsonld",
        graph(
            lambda n: [
                {"@id": f"rob:g{k}", "@graph": [{"@id": f"rob:p{k}", "origin": f"rob:q{k}"}]}
                for k in range(n)
            ]
        ),
        250,
    ),
    ("JSON-LD: quantities of four units", "r.jsonld", graph(_quantities), 250),
    (
        "JSON-LD: terms without meaning",
        "r.jsonld",
        graph(
            lambda n: [
                {"@id": f"rob:p{k}", "@type": f"Poimt{k}", f"nothing{k}": k} for k in range(n)
            ]
        ),
        250,
    ),
    ("Turtle: lists in lists", "r.ttl", turtle(lambda n: f"ex:a ex:b {'( ' * n}{') ' * n}."), 100),
    (
        "Turtle: nodes in nodes",
        "r.ttl",
        turtle(lambda n: f"ex:a ex:b {'[ ex:b ' * n}1{']' * n} ."),
        100,
    ),
    ("Turtle: values of a list", "r.ttl", turtle(lambda n: f"ex:a ex:b ( {'1 ' * n}) ."), 1000),
    ("Turtle: lists", "r.ttl", turtle(lambda n: numbered("ex:a@ ex:b ( 1 2 ) .", n)), 250),
    (
        "Turtle: values of a node",
        "r.ttl",
        turtle(lambda n: f"ex:a ex:b {', '.join(map(str, range(n)))} ."),
        1000,
    ),
)
OTHERS = tuple(Growing(*each) for each in INPUTS)
