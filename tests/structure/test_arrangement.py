"""Trees of joints: every joint hangs once, and no body is carried twice."""

from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st

from kinlint.facts.joint_trees import Edge, arrange_joints

ends = st.one_of(st.none(), st.integers(0, 12).map(str))
edges = st.lists(st.tuples(ends, ends, st.booleans()), max_size=20)


@given(edges)
def test_every_graph_becomes_a_forest(pairs: list[tuple[str | None, str | None, bool]]) -> None:
    made = [
        Edge(f"j{index}", parent, child, (), directed)
        for index, (parent, child, directed) in enumerate(pairs)
    ]
    bodies = tuple(dict.fromkeys(end for each in made for end in each.ends))
    found = arrange_joints(bodies, made)
    assert [each.joint for each in found.edges] == [each.joint for each in made]
    for before, after in zip(made, found.edges, strict=True):
        assert set(after.ends) == set(before.ends)
        if before.directed:
            assert (after.parent, after.child) == (before.parent, before.child)
    carried = [each for each in found.edges if not each.closes and each.child is not None]
    assert set(found.roots).isdisjoint(each.child for each in carried)
    reached = set(found.roots)
    reached.update(each.child for each in carried if each.parent is None and each.child)
    while more := {e.child for e in carried if e.parent in reached and e.child not in reached}:
        reached |= {child for child in more if child}
    assert reached == set(bodies)


@given(edges)
def test_no_directed_joints_carry_a_body_twice(
    pairs: list[tuple[str | None, str | None, bool]],
) -> None:
    made = [
        Edge(f"j{i}", parent, child, directed=True) for i, (parent, child, _) in enumerate(pairs)
    ]
    bodies = tuple(dict.fromkeys(end for each in made for end in each.ends))
    open_ = [each for each in arrange_joints(bodies, made).edges if not each.closes]
    counts = Counter(each.child for each in open_ if each.child is not None)
    assert all(count == 1 for count in counts.values())
