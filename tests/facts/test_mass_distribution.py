"""How large bodies are by their inertia, and by their shapes."""

import math

import pytest
from described import BOX, found, inertial, link

ROD = '<visual><origin xyz="{} 0 0"/><geometry><{}/></geometry></visual>'
SPHERE = 'sphere radius="0.1"'


def only(name, *inner):
    ((_, value),) = found(name, link("hand", inertial(2.0, 0.02), *inner))
    return value


def nothing(name, *inner):
    return found(name, link("hand", inertial(2.0, 0.02), *inner)) == []


def test_the_radius_of_gyration_is_that_of_the_greatest_moment():
    """The square root of moment by mass."""
    ((_, value),) = found("gyration", link("hand", inertial(2.0, 0.02, 0.03)))

    assert value == pytest.approx(math.sqrt(0.015))
    assert found("gyration", link("hand", inertial(2.0, 1.0))) == []
    assert found("gyration", link("hand", inertial(0.0, 0.1))) == []


@pytest.mark.parametrize(
    ("shape", "extent", "volume"),
    [
        ('box size="1 2 2"', 3.0, 4.0),
        ('sphere radius="0.5"', 1.0, math.pi / 6),
        ('cylinder radius="1.5" length="4"', 5.0, 9 * math.pi),
        ('capsule radius="0.5" length="1"', 2.0, math.pi / 4 + math.pi / 6),
    ],
)
def test_a_shape_has_an_extent_and_a_volume(shape, extent, volume):
    """The largest distance between two of its points."""
    drawn = f"<visual><geometry><{shape}/></geometry></visual>"

    assert only("extent", drawn) == pytest.approx(extent)
    assert only("least-density", drawn) == pytest.approx(2.0 / volume)


def test_several_shapes_extend_from_one_to_the_other():
    """At most: twice the radius of a ball about the first that holds them all."""
    apart = ROD.format(0, SPHERE), ROD.format(1, SPHERE)

    assert only("extent", *apart) == pytest.approx(2.2)


def test_what_is_seen_and_what_is_hit_have_volumes_of_their_own():
    """So that there are two densities."""
    both = BOX.format("1 1 1"), ROD.format(0, 'box size="1 1 4"')

    assert only("least-density", *both) == pytest.approx(0.5)
    assert only("greatest-density", *both) == pytest.approx(2.0)


@pytest.mark.parametrize(
    "shape",
    ['mesh filename="hand.dae"', 'box size="1 2"', 'sphere radius="0"', 'sphere radius="-1"'],
)
def test_one_shape_of_unknown_size_leaves_all_open(shape):
    """A mesh may extend beyond the rest."""
    shapes = BOX.format("1 1 1"), ROD.format(0, shape)

    assert nothing("extent", *shapes)
    assert nothing("least-density", *shapes)


@pytest.mark.parametrize(
    ("products", "miss"), [("-0.04", 0.0), ("-0.0355", 0.1125), ("0", None), ("-0.05", None)]
)
def test_a_tensor_about_the_origin_has_the_products_of_a_point_mass_there(products, miss):
    """Nothing is said where no body could have what would be left about its centre."""
    tensor = f'ixx="0.03" iyy="0.11" izz="0.09" ixy="0" ixz="{products}" iyz="0"'
    mass = f'<inertial><origin xyz="0.2 0 0.1"/><mass value="2"/><inertia {tensor}/></inertial>'

    assert [value for _, value in found("transfer", link("hand", mass))] == (
        [] if miss is None else [pytest.approx(miss, abs=1e-9)]
    )


@pytest.mark.parametrize(
    "origin", ['xyz="0.2 0 0.1" rpy="0 0.1 0"', 'xyz="0 0 0.1"', 'xyz="0 0 0"', "", 'xyz="a"']
)
def test_a_tensor_along_other_axes_or_without_products_tells_no_point(origin):
    """As it is about a centre that lies on an axis of the link."""
    tensor = 'ixx="0.03" iyy="0.11" izz="0.09" ixy="0" ixz="-0.04" iyz="0"'
    mass = f'<inertial><origin {origin}/><mass value="2"/><inertia {tensor}/></inertial>'

    assert found("transfer", link("hand", mass)) == []
