"""What fixed joints make one body, and what it weighs."""

from described import found, inertial, joint, link

BASE = link("base")


def test_what_is_fixed_weighs_with_the_rest():
    """Each node that states mass or inertia knows the mass of the others."""
    parts = (
        *(BASE, link("hand", inertial(2.0)), link("tip", inertial(0.5)), link("frame")),
        joint("wrist", "base", "hand"),
        *(joint("f", "hand", "frame", "fixed"), joint("g", "frame", "tip", "fixed")),
    )

    weights = dict(found("welded-mass", *parts))

    assert weights["link/hand/inertia/mass"] == weights["link/hand/inertia/moments"] == 0.5
    assert weights["link/tip/inertia/mass"] == 2.0


def test_moving_joints_part_bodies():
    """Nothing is fixed to the hand, and it does not rest."""
    parts = BASE, link("hand", inertial()), joint("wrist", "base", "hand")

    assert found("welded-mass", *parts) == []
    assert found("rests-on", *parts) == []


def test_the_root_rests():
    """With what is fixed to it."""
    parts = BASE, link("foot", inertial(0.0)), joint("f", "base", "foot", "fixed")

    assert {subject for subject, _ in found("rests-on", *parts)} == {
        "link/foot/inertia/mass",
        "link/foot/inertia/moments",
    }


def test_bodies_that_move_and_weigh_nothing():
    """An inertia anywhere in what moves will do, and so will standing still."""
    bare = BASE, link("arm"), link("hand"), joint("a", "base", "arm")
    parts = (*bare, joint("b", "arm", "hand"))

    assert found("moved-by", *parts) == [("link/arm", "joint/a"), ("link/hand", "joint/b")]
    assert found("moved-by", *bare, joint("b", "arm", "hand", "fixed")) == [("link/arm", "joint/a")]
    weight = link("weight", inertial()), joint("c", "arm", "weight", "fixed")
    assert found("moved-by", *parts, *weight) == [("link/hand", "joint/b")]
