"""Hints beside values: degrees, and what expressions come to."""

from navigating import NON_BMP, Model

from kinlint.text import Span

URDF = f"""<robot name="leg"><!-- {NON_BMP} -->
  <link name="hip"><visual><origin xyz="1 0 0" rpy="0 0 1.5707963"/></visual></link>
  <link name="shin"/>
  <joint name="knee" type="revolute">
    <parent link="hip"/><child link="shin"/>
    <limit lower="-0.5" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="shin"/><child link="foot"/>
    <limit lower="-0.25" upper="3" effort="1" velocity="1"/>
  </joint>
  <link name="foot"/>
</robot>
"""
XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="a" value="0.5"/>
  <xacro:macro name="m" params="n y">
    <link name="${n}"><visual><origin xyz="0 ${y} ${a * 2}" rpy="${pi/2} 0 0"/></visual></link>
  </xacro:macro>
  <xacro:m n="one" y="1"/><xacro:m n="two" y="2"/>
</robot>
"""
SDF = """<sdf version="1.9"><model name="m">
  <link name="a"><pose>0 0 1 0.1 0 0.2</pose></link>
  <link name="b"><pose degrees="true">0 0 1 90 0 0</pose></link>
  <joint name="j" type="revolute"><parent>a</parent><child>b</child>
    <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>
  </joint>
  <joint name="k" type="prismatic"><parent>a</parent><child>b</child>
    <axis><xyz>0 0 1</xyz><limit><lower>-2</lower><upper>2</upper></limit></axis>
  </joint>
</model></sdf>
"""


def shown(tmp_path, name, text, span=None):
    """The hints in *span*, each behind the last characters before it."""
    model = Model(tmp_path, {name: text})
    span = span or Span(0, len(text))
    found = model.navigator.inlay_hints(str(tmp_path / name), span)
    return [(text[: each.offset].split('"')[-1].split(">")[-1], each.text) for each in found]


def test_degrees_beside_radians_in_urdf(tmp_path):
    assert shown(tmp_path, "leg.urdf", URDF) == [
        ("0 0 1.5707963", "0° 0° 90°"),
        ("-0.5", "-28.65°"),
        ("2", "114.6°"),
    ]


def test_only_where_it_is_asked_for(tmp_path):
    at = URDF.index("upper=")
    assert shown(tmp_path, "leg.urdf", URDF, Span(at, at + 10)) == [("2", "114.6°")]


def test_expressions_of_xacro(tmp_path):
    assert shown(tmp_path, "r.xacro", XACRO) == [
        ("${n}", "= one | = two"),
        ("0 ${y}", "= 1 | = 2"),
        ("0 ${y} ${a * 2}", "= 1"),
        ("${pi/2}", "= 1.5708"),
        ("${pi/2} 0 0", "90° 0° 0°"),
    ]


def test_degrees_in_sdf(tmp_path):
    """A pose that is in degrees has none beside, nor a limit in metres."""
    assert shown(tmp_path, "m.sdf", SDF) == [
        ("0 0 1 0.1 0 0.2", "5.73° 0° 11.46°"),
        ("-1", "-57.3°"),
        ("1", "57.3°"),
    ]
