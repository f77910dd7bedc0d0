"""Whether links and joints make one tree."""

from described import found, joint, link

A, B, C = link("a"), link("b"), link("c")


def test_the_root_is_what_no_joint_carries():
    """There is one, or the others stand beside the first."""
    assert found("root", A, B, joint("j", "a", "b")) == [("", "link/a")]
    assert found("root", A, B) == []
    assert found("root-beside", A, B, C) == [("link/b", "link/a"), ("link/c", "link/a")]


def test_a_link_that_is_missing_leaves_no_second_root():
    """The link that was meant to hang there is no root: its joint says where it hangs."""
    parts = A, link("elbow"), joint("j", "a", "elbo")

    assert found("root-beside", *parts) == []
    assert found("unresolved", *parts) == [("joint/j/child", "elbo")]
    assert found("near-name", *parts) == [("joint/j/child", "elbow")]


def test_names_repeated_or_missing_make_no_root():
    """Other rules tell of those."""
    assert found("root-beside", A, A, "<link/>") == []
    assert found("root", A, A, "<link/>") == [("", "link/a")]


def test_the_first_joint_in_the_text_carries_a_link():
    """Later ones claim what it has."""
    parts = A, B, C, joint("z", "a", "c"), joint("b", "b", "c"), joint("a", "a", "b")

    assert found("claimed-by", *parts) == [("joint/b/child", "joint/z")]


def test_a_circle_is_found_once():
    """At one of its joints, whatever hangs on it."""
    around = joint("x", "b", "c"), joint("y", "c", "b"), joint("tail", "c", "d")

    ((robot, closing),) = found("circle", A, B, C, link("d"), *around)

    assert (robot, closing) in [("", "joint/x"), ("", "joint/y")]
    assert found("circle", A, joint("knot", "a", "a")) == []
    assert found("circle", A, B, joint("j", "a", "b")) == []


def test_nothing_is_said_of_what_is_not_expanded():
    """Names are not known yet."""
    raw = link("${prefix}base"), link("tip"), joint("j", "base", "tip")

    assert found("unresolved", *raw) == []
    assert found("links", *raw) == []
    assert found("links", A, B) == [("", 2)]


def test_transmissions_have_no_joints_of_their_own():
    """They name those of the robot."""
    drive = '<transmission name="t"><joint name="j"/></transmission>'

    assert found("root", A, B, joint("j", "a", "b"), drive) == [("", "link/a")]


def test_names_are_addressed_as_they_are_quoted():
    """A slash in a name is no step in an address."""
    assert found("unresolved", link("a/b"), B, joint("j", "a/b", "b")) == []
