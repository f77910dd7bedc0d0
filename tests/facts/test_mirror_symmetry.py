"""Names of twins, what twins state, and bodies that share an inertia."""

import pytest
from described import BOX, found, inertial, joint, link
from support.linting import findings

from kinlint.facts.laterality import twin, without_side

LIMIT = '<limit lower="-1" upper="2" effort="3" velocity="4"/>'


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("left_arm", "right_arm"),
        ("LeftShoulderPitch", "RightShoulderPitch"),
        ("LElbowYaw", "RElbowYaw"),
        ("LEFT_SHIN", "RIGHT_SHIN"),
        ("arm_left_1", "arm_right_1"),
        ("l_hip", "r_hip"),
        ("FL_thigh", "FR_thigh"),
        ("lf_foot", "rf_foot"),
        ("arm%20left", "arm%20right"),
    ],
)
def test_names_have_twins(left, right):
    """Of the left the right one; not the other way, which would tell all twice."""
    assert twin(left) == right
    assert twin(right) is None


@pytest.mark.parametrize(
    "name", ["leftover", "r_gripper_l_finger", "motor_front_leftR", "link_1", "", "wall"]
)
def test_other_names_have_none(name):
    """Several sides in one name leave open which of them is meant."""
    assert twin(name) is None


def test_sides_are_left_out():
    """Front and rear are sides of wheels."""
    assert without_side("left_front_wheel") == without_side("right_rear_wheel")
    assert without_side("link_1") != without_side("link_2")


def test_what_twins_state_is_paired():
    """Mass with mass, moments with moments, each limit with its like."""
    links = link("base"), link("l_arm", inertial()), link("r_arm", inertial())
    joints = (
        joint("left", "base", "l_arm", "revolute", LIMIT),
        joint("right", "base", "r_arm", "revolute", LIMIT),
    )

    assert dict(found("twin", *links, *joints)) == {
        "link/l_arm/inertia/mass": "link/r_arm/inertia/mass",
        "link/l_arm/inertia/moments": "link/r_arm/inertia/moments",
        "joint/left/position-limit": "joint/right/position-limit",
        "joint/left/force-limit": "joint/right/force-limit",
        "joint/left/velocity-limit": "joint/right/velocity-limit",
    }


def test_axes_of_an_arm_are_no_twins():
    """S L U R B T: what is lettered so has a U beside its L."""
    axes = [link(f"link_{letter}", inertial()) for letter in "slurbt"]

    assert found("twin", *axes) == []
    assert len(found("twin", axes[1], axes[3])) == 2


def unlike(masses):
    """The body whose mass differs from that of its siblings."""
    links = [link(name, inertial(mass)) for name, mass in masses.items()]
    return [node.split("/")[1] for node, _ in found("unlike-siblings", *links)]


LEGS = {"FL_foot": 0.5, "FR_foot": 0.5, "RL_foot": 0.501, "RR_foot": 0.5}


@pytest.mark.parametrize("mass", [0.05, 5.0, 0.0, -0.5])
def test_one_leg_may_be_unlike_the_others(mass):
    """Where all others agree to a percent."""
    assert unlike({**LEGS, "FR_foot": mass}) == ["FR_foot"]


@pytest.mark.parametrize(
    "changes", [{}, {"FR_foot": 0.9, "RR_foot": 0.9}, {"FR_foot": 0.9, "RR_foot": 0.8}]
)
def test_several_legs_may_be_unlike_each_other(changes):
    """Then none of them is the odd one."""
    assert unlike({**LEGS, **changes}) == []


def test_two_pairs_make_siblings():
    """Not one pair with another body, and not bodies whose names say no side."""
    assert unlike({"FL_foot": 0.5, "FR_foot": 0.9, "RL_foot": 0.5}) == []
    assert unlike({"foot_a": 0.5, "foot_b": 0.9, "foot_c": 0.5, "foot_d": 0.5}) == []


def test_a_bound_may_be_unlike_the_others():
    """Force with force, velocity with velocity."""
    legs = ("FL", "FR", "RL", "RR")
    limits = [LIMIT] * 3 + [LIMIT.replace('effort="3"', 'effort="30"')]
    joints = [
        joint(f"{leg}_hip", "base", f"{leg}_leg", "revolute", limit)
        for leg, limit in zip(legs, limits, strict=True)
    ]
    links = [link(name) for name in ("base", *(f"{leg}_leg" for leg in legs))]

    ((odd, _),) = found("unlike-siblings", *links, *joints)
    assert odd == "joint/RR_hip/force-limit"


def test_bodies_of_several_shapes_that_share_an_inertia():
    """The identity, zero and bodies without mass are other matters, and so are twins."""
    same = [link(f"link{n}", inertial(), BOX.format(f"{n} 1 1")) for n in range(1, 4)]

    assert found("shapes", *same) == [(f"link/link{n}/inertia/moments", 3) for n in range(1, 4)]
    assert found("shapes", *same[:2]) == []
    assert found("shapes", *(each.replace("0.01", "1.0") for each in same)) == []
    assert found("shapes", *(each.replace("0.01", "0.0") for each in same)) == []
    assert (
        found("shapes", *(each.replace('mass value="1.0"', 'mass value="0"') for each in same))
        == []
    )
    wheels = ("left_front", "left_rear", "right_front")
    turned = [each.replace(f"link{n}", f"{wheels[n - 1]}_wheel") for n, each in enumerate(same, 1)]
    assert found("shapes", *turned) == []


def arms(*sides):
    """Links of arms, each with the distances of its centres of mass to the left in m."""
    return tuple(
        link(
            f"{side}_{number}",
            inertial().replace("<mass", f'<origin xyz="0.1 {aside} 0.3"/><mass', 1),
        )
        for number, pair in enumerate(sides)
        for side, aside in zip(("left", "right"), pair, strict=True)
    )


@pytest.mark.parametrize(
    ("sides", "odd"),
    [
        ([(0.1, -0.1), (0.2, -0.2), (0.05, 0.05)], ["link/left_2/inertia-frame/pose/position"]),
        ([(0.1, -0.1), (0.2, -0.2), (0.05, -0.05)], []),
        ([(0.1, -0.1), (0.2, -0.2), (0.001, 0.001)], []),
        ([(0.1, -0.1), (0.05, 0.05)], []),
        ([(0.1, -0.1), (0.2, -0.2), (0.05, 0.05), (0.04, 0.04)], []),
    ],
)
def test_one_centre_of_mass_is_not_mirrored(sides, odd):
    """Two other pairs are, and no other is not; on the plane of symmetry signs mean nothing."""
    assert [node for node, _ in found("unlike-centre", link("base"), *arms(*sides))] == odd


LEG = (
    '<{frame}body name="{side}_hip"{place}><joint name="{side}_swing" axis="0 1 0" range="-1 1"/>'
    '<geom size="0.1" mass="1"/><body name="{side}_calf" pos="0 0 -0.2">'
    '<joint name="{side}_bend" axis="0 1 0" range="0 2"/><geom size="0.1" mass="{mass}"/></body>'
    "</body>{end}"
)


@pytest.mark.parametrize("framed", [False, True])
@pytest.mark.parametrize("mass", [0.2, 2])
def test_twins_are_in_bodies_that_are_twins(framed, mass):
    """In MJCF bodies lie in each other, or in frames without a name."""
    legs = "".join(
        LEG.format(
            side=side,
            mass=heavy,
            frame=f'frame pos="0 {y} 0"><' if framed else "",
            place="" if framed else f' pos="0 {y} 0"',
            end="</frame>" if framed else "",
        )
        for side, y, heavy in (("left", 1, 0.2), ("right", -1, mass))
    )
    world = f'<body name="trunk"><freejoint/><geom size="0.3"/>{legs}</body>'
    text = f'<mujoco><compiler angle="radian"/><worldbody>{world}</worldbody></mujoco>'
    told = [each.message for each in findings(text, "robot.xml") if each.rule.code == "INE007"]

    assert len(told) == (mass == 2)
    assert all("Body 'left_" in each and "of body 'right_" in each for each in told)
