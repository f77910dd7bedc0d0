"""Which space behind numbers urdfdom takes, as `check_urdf` of urdfdom 6 says it."""

import pytest
from support import linting

from kinlint.vocabulary import SRC

TEXT = (
    '<robot name="arm"><link name="base"><inertial><origin xyz="{}"/><mass value="{}"/>'
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link></robot>"
)


def unread(text, form="urdf"):
    """The texts whose space is stated, each with its quotes."""
    document = linting.document(text, "arm.xml", form)
    stated = [s for s, _, o in document.statements if o == f"<{SRC}UnreadSpace>"]
    return [text[slice(*document.map.nodes[node].best)] for node in stated]


@pytest.mark.parametrize(
    ("vector", "taken"),
    [
        ("0 0 1", True),
        (" 0  0 1", True),
        ("0 0 1 ", True),
        ("0 0 \t1", True),
        ("\t0 0 1", True),
        ("0\t0\t1", False),
        ("0\n0 1", False),
        ("0 0 1\n", False),
        ("0 0 1 \n", False),
        ("0 \n 0 1", False),
        ("0 0\t 1", False),
    ],
)
def test_numbers_of_a_vector_are_parted_by_blanks(vector, taken):
    """Space before a number is read past, whatever it is."""
    assert unread(TEXT.format(vector, "1")) == ([] if taken else [vector])


@pytest.mark.parametrize(
    ("number", "taken"), [("1", True), (" 1", True), ("\n1", True), ("1 ", False), ("1\n", False)]
)
def test_nothing_may_stand_behind_a_single_number(number, taken):
    assert unread(TEXT.format("0 0 1", number)) == ([] if taken else [number])


def test_other_quotes_are_quotes_too():
    text = TEXT.format("0 0 1", "1").replace("ixx='1'", "ixx='1 '")

    assert unread(text) == ["1 "]


@pytest.mark.parametrize(
    "text",
    [
        '<!-- <mass value="1 "/> --><robot name="arm"><link name="base"/></robot>',
        '<robot name="1 "><link name="base"/></robot>',
        '<robot name="arm"><link name="base" mass="1 "/></robot>',
        '<robot name="arm"><gazebo><mass value="1 "/></gazebo><link name="base"/></robot>',
        '<!-- value="1 " -->',
    ],
)
def test_only_numbers_that_the_format_knows_are_spoken_of(text):
    assert unread(text) == []


def test_other_formats_take_any_space():
    assert unread('<robot name="arm"><group name="1 "/></robot>', "srdf") == []


def test_xacro_writes_blanks_for_tabs_and_line_ends():
    """As any reader of XML takes them; space behind a single number stays what it is."""
    xmlns = 'name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"'
    text = TEXT.format("0\t0\n1", "1 ").replace('name="arm"', xmlns)
    document = linting.document(text, "arm.xacro")
    stated = [s for s, _, o in document.statements if o == f"<{SRC}UnreadSpace>"]

    assert [text[slice(*document.map.nodes[node].best)] for node in stated] == ["1 "]
