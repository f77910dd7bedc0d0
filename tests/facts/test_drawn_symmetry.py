"""Joints that mirror each other, also where they lie in the plane between them."""

import pytest
from support.linting import lint, source

LEG = """
<link name="{0}_thigh"/><link name="{0}_shin"/><link name="{0}_foot"/><link name="{0}_toe"/>
<joint name="{0}_hip" type="revolute"><parent link="trunk"/><child link="{0}_thigh"/>
 <origin xyz="0 {1}0.1 0"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="9" velocity="4"/>
</joint>
<joint name="{0}_knee" type="revolute"><parent link="{0}_thigh"/><child link="{0}_shin"/>
 <origin xyz="0.02 {2} -0.4"/><axis xyz="0 1 0"/>
 <limit lower="0" upper="2" effort="9" velocity="4"/></joint>
<joint name="{0}_ankle" type="revolute"><parent link="{0}_shin"/><child link="{0}_foot"/>
 <origin xyz="0 0 -0.4"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="4"/>
</joint>
<joint name="{0}_ball" type="revolute"><parent link="{0}_foot"/><child link="{0}_toe"/>
 <origin xyz="0.1 {1}0.01 0"/><axis xyz="0 1 0"/>
 <limit lower="0" upper="1" effort="9" velocity="4"/></joint>
"""


@pytest.mark.parametrize(("knee", "found"), [("0", 0), ("0.05", 1)])
def test_only_what_is_not_mirrored_is_told(knee, found):
    left, right = LEG.format("left", "", knee), LEG.format("right", "-", "0")
    report = lint([source(f'<robot name="biped"><link name="trunk"/>{left}{right}</robot>')])
    assert [each.rule.code for each in report.findings].count("FRM069") == found
