"""What could be written instead of a tensor of inertia that is wrong."""

import math

import pytest
from described import amended, found, inertial, link

HERE = '<origin xyz="0 0 0.1" rpy="0 0.2 0"/>'
TENSOR = '<inertia ixx="{}" iyy="{}" izz="{}" ixy="{}" ixz="{}" iyz="{}"/>'


def tensor(*entries, origin="", mass=1.2):
    zeros = [0.0] * (6 - len(entries))
    inner = TENSOR.format(*entries, *zeros)
    return link("hand", f'<inertial>{origin}<mass value="{mass}"/>{inner}</inertial>')


def solid(shape, *, inertia_at="", shape_at="", mass=2.0):
    drawn = f"<collision>{shape_at}<geometry><{shape}/></geometry></collision>"
    inner = TENSOR.format(9.0, 9.0, 9.0, 0.5, 0.0, 0.0)
    return amended(
        "solid",
        link("hand", f'<inertial>{inertia_at}<mass value="{mass}"/>{inner}</inertial>', drawn),
    )


def test_one_decimal_point_in_the_wrong_place_is_moved():
    """By as many places as it takes, to either side; the digits stay."""
    assert amended("decimal-slip", tensor(0.02, 0.025, 0.3)) == {"izz": 0.03}
    assert amended("decimal-slip", tensor(0.00203, 0.00205, 1037.0)) == {}
    assert amended("decimal-slip", tensor(0.00203, 0.00281, 1037.0)) == {"izz": 0.001037}
    assert amended("decimal-slip", tensor(0.0002, 0.02, 0.025)) == {"ixx": 0.02}


@pytest.mark.parametrize(
    "entries",
    [
        (0.02, 0.02, 0.3),
        (0.02, 0.025, 0.046),
        (0.02, 0.025, 0.03),
        (-0.02, 0.025, 0.3),
        (0.02, 0.02, 0.02, 0.015),
    ],
)
def test_no_decimal_point_is_moved_where_that_is_not_the_one_way(entries):
    """Two powers of ten do, or the tensor is nearly right, or more than that is wrong."""
    assert amended("decimal-slip", tensor(*entries)) == {}


def test_signs_that_no_body_can_have_are_changed():
    """Those of negative moments, or those of all products."""
    assert amended("sign-slip", tensor(0.02, -0.02, 0.02)) == {"iyy": 0.02}
    assert amended("sign-slip", tensor(0.02, 0.02, 0.02, 0.008, 0.008, 0.008)) == {
        "ixy": -0.008,
        "ixz": -0.008,
        "iyz": -0.008,
    }


def test_signs_stay_where_other_signs_make_no_body():
    """Or where the tensor is that of a body as it is."""
    assert amended("sign-slip", tensor(0.02, -0.9, 0.02)) == {}
    assert amended("sign-slip", tensor(0.02, 0.02, 0.02, 0.03)) == {}
    assert amended("sign-slip", tensor(0.02, 0.02, 0.02, 0.008, -0.008, 0.008)) == {}


@pytest.mark.parametrize(
    ("shape", "moments"),
    [
        ('box size="1 2 3"', (13 / 6, 10 / 6, 5 / 6)),
        ('sphere radius="0.5"', (0.2, 0.2, 0.2)),
        ('cylinder radius="1" length="6"', (6.5, 6.5, 1.0)),
        ('capsule radius="1" length="1e-9"', (0.8, 0.8, 0.8)),
        ('capsule radius="1e-9" length="6"', (6.0, 6.0, 0.0)),
    ],
)
def test_a_solid_has_the_inertia_of_the_textbooks(shape, moments):
    """About its centre, with six digits, and no products."""
    found = solid(shape)

    assert [found[name] for name in ("ixx", "iyy", "izz")] == pytest.approx(moments, rel=1e-5)
    assert found["ixy"] == 0.0
    assert "ixz" not in found


def test_a_capsule_is_what_thin_slices_of_it_add_up_to():
    """Each a disc about the axis, moved from its own centre to that of the capsule."""
    radius, long, slices = 0.3, 0.8, 20000
    half = long / 2 + radius
    discs = [
        (z, radius**2 - max(abs(z) - long / 2, 0.0) ** 2)
        for z in (-half + (2 * at + 1) * half / slices for at in range(slices))
    ]
    whole = sum(square for _, square in discs)
    across = sum(square * (square / 4 + z * z) for z, square in discs) / whole
    along = sum(square * square / 2 for _, square in discs) / whole
    found = solid(f'capsule radius="{radius}" length="{long}"', mass=1.0)

    assert found["ixx"] == pytest.approx(across, rel=1e-5)
    assert found["izz"] == pytest.approx(along, rel=1e-5)


def test_a_solid_has_to_be_where_the_inertia_is():
    """The formulas hold about its centre and along its axes."""
    shape = 'sphere radius="0.5"'

    assert solid(shape, inertia_at=HERE, shape_at=HERE)["ixx"] == 0.2
    assert solid(shape, inertia_at=HERE) == {}
    assert solid(shape, shape_at='<origin rpy="0 0.2 0"/>') == {}
    assert solid(shape, shape_at='<origin quat_xyzw="0 0 1 0"/>') == {}
    assert solid(shape, shape_at='<origin quat_xyzw="0 0 0 1"/>')["ixx"] == 0.2
    assert solid(shape, mass=0.0) == {}
    assert solid('mesh filename="hand.stl"') == {}


def test_a_solid_is_one_shape():
    """That which is hit, or else that which is seen."""
    ball = '<{0}><geometry><sphere radius="0.5"/></geometry></{0}>'
    mesh = '<visual><geometry><mesh filename="hand.stl"/></geometry></visual>'
    seen, hit = ball.format("visual"), ball.format("collision")

    assert amended("solid", link("hand", inertial(2.0, 1.0), seen))["ixx"] == 0.2
    assert amended("solid", link("hand", inertial(2.0, 1.0), mesh, hit))["ixx"] == 0.2
    assert amended("solid", link("hand", inertial(2.0, 1.0), hit, hit)) == {}
    assert amended("solid", link("hand", inertial(2.0, 1.0))) == {}


def test_a_tensor_about_the_origin_moves_to_the_centre():
    """By the theorem of parallel axes, without digits that only the computer has."""
    at = '<origin xyz="0.2 0 0.1"/>'

    assert amended("shift", tensor(0.03, 0.11, 0.09, 0.0, -0.04, 0.0, origin=at, mass=2.0)) == {
        "ixx": 0.01,
        "iyy": 0.01,
        "izz": 0.01,
        "ixz": 0.0,
    }
    assert amended("shift", tensor(0.01, 0.01, 0.01, origin=at, mass=2.0)) == {}
    assert amended("shift", tensor(0.03, 0.11, 0.09, origin="", mass=2.0)) == {}
    turned = '<origin xyz="0.2 0 0.1" rpy="0 0.2 0"/>'
    assert amended("shift", tensor(9.0, 9.0, 9.0, origin=turned)) == {}


BOX = '<{0}>{1}<geometry><box size="{2}"/></geometry></{0}>'
SEEN, HIT = (BOX.format(kind, "", "0.1 0.2 0.3") for kind in ("visual", "collision"))


def watery(*parts):
    facts = ("water-mass", "water-ixx", "water-iyy", "water-izz")
    return [value for name in facts for _, value in found(name, *parts)]


def test_a_body_without_inertia_could_be_of_water():
    """Six litres have a mass of six kilograms, and the moments of a box."""
    assert watery(link("hand", SEEN)) == [6.0, 0.065, 0.05, 0.025]
    assert watery(link("hand", SEEN, HIT)) == [6.0, 0.065, 0.05, 0.025]


@pytest.mark.parametrize(
    "parts",
    [
        (),
        (inertial(), SEEN),
        (SEEN, BOX.format("collision", "", "0.1 0.2 0.4")),
        (HIT, '<visual><geometry><mesh filename="hand.stl"/></geometry></visual>'),
        (BOX.format("visual", HERE, "0.1 0.2 0.3"),),
        (BOX.format("visual", "", "0 0.2 0.3"),),
        (BOX.format("visual", "", "1e200 1e200 1e200"),),
        (BOX.format("visual", "", "1e-200 1e-200 1e-200"),),
    ],
)
def test_a_body_is_of_water_only_if_it_is_one_simple_shape(parts):
    """In the frame of its link, of a size that a number can have, and nothing else is stated."""
    assert watery(link("hand", *parts)) == []


def test_numbers_without_bounds_have_no_amendment():
    """Nor any that overflow."""
    assert amended("decimal-slip", tensor(1e300, 1e-300, 1e308)) == {}
    assert math.isinf(float("1e999"))
    assert amended("sign-slip", tensor("1e999", -1.0, 1.0)) == {}
