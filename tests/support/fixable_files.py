"""Small files with a fault that can be fixed."""

from __future__ import annotations

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
LIMIT = '<limit lower="2" upper="1" effort="1" velocity="1"/>'
ENDS = '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
ROBOT = (
    '<robot name="r"{}><link name="a"/><link name="b"/>\n'
    f'<joint name="j" type="revolute">{ENDS}{LIMIT}</joint></robot>\n'
)
AXIS = (
    "<axis><xyz>0 0 1</xyz><limit><lower>2</lower><upper>1</upper><effort>1</effort>"
    "<velocity>1</velocity></limit></axis>"
)
PAIR = '<disable_collisions link1="a" link2="b" reason="Never"/>'
FILES = {
    "urdf": ROBOT.format(""),
    "xacro": ROBOT.format(f" {XACRO}"),
    "sdf": (
        '<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/><joint name="j" '
        f'type="revolute"><parent>a</parent><child>b</child>{AXIS}</joint></model></sdf>\n'
    ),
    "srdf": f'<robot name="s"><group name="g"><link name="a"/></group>{PAIR}\n{PAIR}</robot>\n',
    "jsonld": """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
  "@graph": [
    { "@id": "ex:tool-origin", "@type": "Point" },
    { "@id": "ex:tool", "@type": "Frame", "origin": "ex:tol-origin" }
  ]
}
""",
    "ttl": """@prefix arm: <urn:example:arm:> .
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
arm:tool-origin a geom:Point .
arm:tool a geom:Frame ; geom:origin arm:tol-origin .
""",
}
"""A file of each format that can be fixed."""
