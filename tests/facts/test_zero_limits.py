"""Limits of zero, and those beside them."""

from described import found, joint, link

LINKS = [link(name) for name in "abcd"]


def arm(*efforts, extra=""):
    limits = [f'<limit effort="{each}" velocity="1"/>' for each in efforts]
    ends = zip("abcd", "bcde", limits, strict=False)
    joints = [
        joint(f"j{child}", parent, child, "continuous", limit) for parent, child, limit in ends
    ]
    return (*LINKS, link("e"), *joints, extra)


def test_zeros_and_others_are_counted():
    """At each limit that is zero."""
    assert found("idle", *arm(0, 5, 0)) == [
        ("joint/jb/force-limit", 2),
        ("joint/jd/force-limit", 2),
    ]
    assert found("working", *arm(0, 5, 0)) == [
        ("joint/jb/force-limit", 1),
        ("joint/jd/force-limit", 1),
    ]
    assert found("idle", *arm(5, 5)) == []


def test_joints_that_follow_need_no_effort():
    """They go where their leader takes them."""
    follower = '<limit effort="0" velocity="1"/><mimic joint="jb"/>'

    assert found("idle", *arm(5, extra=joint("je", "d", "e", "continuous", follower))) == []
