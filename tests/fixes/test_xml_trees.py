"""Trees are equal if what is written means the same, however it is written."""

from __future__ import annotations

from collections.abc import Hashable

import pytest
from support.linting import document

from kinlint.formats.xml.editing import element_tree

ROBOT = """\
<robot name="a b">
  <link name="l"><visual/><visual/></link>
  <joint name="j" type="fixed"><origin xyz="0 1 2.50"/><colision>  a  b </colision></joint>
</robot>
"""


def built(text: str, name: str = "arm.urdf") -> Hashable:
    return element_tree.tree(document(text, name))


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("2.50", "2.5"),
        ('"0 1 2.50"', "' 0.0  1e0 2.5 '"),
        ("  a  b ", "a b"),
        ("<visual/><visual/>", "<!-- c --><visual></visual>\n<visual />"),
        ('name="j" type="fixed"', 'type="fixed" name="j"'),
        ("<robot ", '<robot xmlns:gz="http://gz" '),
        ('<link name="l"><visual/><visual/></link>', ""),
    ],
)
def test_the_same_robot(before: str, after: str) -> None:
    text = ROBOT.replace(before, after, 1)
    if not after:
        text = text.replace("</robot>", f"{before}</robot>")
    assert text != ROBOT
    assert built(text) == built(ROBOT)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("2.50", "2.51"),
        ("0 1 2.50", "1 0 2.50"),
        ("a  b", "b a"),
        ("<visual/><visual/>", "<visual/>"),
        ("<visual/><visual/>", "<visual><visual/></visual>"),
        ('name="j"', 'names="j"'),
        ("</joint>", "<x/></joint>"),
        ("<visual/>", "<visual>text</visual>"),
        ('"a b"', '"ab"'),
    ],
)
def test_another_robot(before: str, after: str) -> None:
    assert built(ROBOT.replace(before, after, 1)) != built(ROBOT)


def test_truths_are_numbers() -> None:
    text = '<sdf version="1.9"><model name="m"><static>{}</static></model></sdf>'
    assert built(text.format("true"), "m.sdf") == built(text.format("1"), "m.sdf")
    assert built(text.format("true"), "m.sdf") != built(text.format("0"), "m.sdf")


def test_depth_is_no_matter() -> None:
    deep = "<x>" * 190 + "</x>" * 190
    assert built(f'<robot name="r">{deep}</robot>') == built(f'<robot name="r">\n{deep}</robot>')
