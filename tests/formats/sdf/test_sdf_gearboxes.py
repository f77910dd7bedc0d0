"""A gearbox relates the angles of the hinges between its reference body and what it joins."""

import pytest
from reading_sdf import model, numbers, paths, said

GEAR = "/model/arm/joint/gear"
PLUS, MINUS, ASIDE = "0 0 1", "0 0 -1", "0 1 0"


def hinge(name, parent, child, xyz=PLUS, type_="revolute"):
    return (
        f'<joint name="{name}" type="{type_}"><parent>{parent}</parent><child>{child}</child>'
        f"<axis><xyz>{xyz}</xyz></axis></joint>"
    )


def gearbox(motor, elbow, reference="base", axis=PLUS, axis2=f"<xyz>{PLUS}</xyz>", pose=""):  # noqa: PLR0913, PLR0917
    return model(
        f'<link name="base"/><link name="rotor">{pose}</link><link name="forearm"/>{motor}{elbow}'
        '<joint name="gear" type="gearbox"><parent>rotor</parent><child>forearm</child>'
        f"<gearbox_reference_body>{reference}</gearbox_reference_body>"
        f"<axis><xyz>{axis}</xyz></axis><axis2>{axis2}</axis2></joint>"
    )


MOTOR, ELBOW = hinge("motor", "base", "rotor"), hinge("elbow", "base", "forearm")


@pytest.mark.parametrize(
    ("motor", "elbow", "sense"),
    [
        (MOTOR, ELBOW, 1),
        (MOTOR, hinge("elbow", "base", "forearm", MINUS), -1),
        (MOTOR, hinge("elbow", "forearm", "base"), -1),
        (hinge("motor", "rotor", "base", MINUS), ELBOW, 1),
    ],
)
def test_the_hinges_and_their_senses_are_found(motor, elbow, sense):
    read = gearbox(motor, elbow)
    assert paths(read, said(read, GEAR, "leader")) == ["/model/arm/joint/motor"]
    assert paths(read, said(read, GEAR, "follower")) == ["/model/arm/joint/elbow"]
    assert numbers(read, GEAR, "", "sense") == [sense]


def test_directions_are_compared_in_the_world():
    """The rotor is turned by a half about x: its own z points down."""
    turned = "<pose degrees='true'>0 0 0 180 0 0</pose>"
    read = gearbox(MOTOR, ELBOW, pose=turned)
    assert numbers(read, GEAR, "", "sense") == [-1]


def test_an_axis_that_is_not_written_is_z():
    assert numbers(gearbox(MOTOR, ELBOW, axis2=""), GEAR, "", "sense") == [1]


@pytest.mark.parametrize(
    "read",
    [
        gearbox(hinge("motor", "base", "rotor", ASIDE), ELBOW),
        gearbox(MOTOR, ELBOW, axis=ASIDE),
        gearbox(MOTOR, hinge("elbow", "base", "forearm", type_="prismatic")),
        gearbox(MOTOR, ""),
        gearbox(MOTOR, ELBOW, reference=""),
        gearbox(MOTOR, ELBOW, reference="nothing"),
        gearbox(MOTOR, ELBOW, reference="rotor"),
    ],
)
def test_a_gearbox_without_such_hinges_couples_nothing(read):
    assert said(read, GEAR, "leader") == said(read, GEAR, "sense") == []
