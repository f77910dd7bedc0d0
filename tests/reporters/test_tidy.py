"""Trees are laid out so that parents are centred and neighbours are apart, however deep."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.reporters.picture.tidy_tree import tidy

GAP = 5.0


@st.composite
def forests(draw: st.DrawFn) -> tuple[list[int], list[float]]:
    """The parent of each node, which comes before it, and sizes."""
    size = draw(st.integers(1, 40))
    above = [draw(st.integers(-1, index - 1)) for index in range(size)]
    return above, [draw(st.floats(1, 60)) for _ in range(size)]


@given(forests())
def test_nothing_overlaps_and_parents_are_centred(made: tuple[list[int], list[float]]) -> None:
    above, breadths = made
    middles = tidy(above, breadths, GAP)
    below: dict[int, list[int]] = {}
    for node, parent in enumerate(above):
        below.setdefault(parent, []).append(node)
    level = below[-1]
    while level:
        for one, other in itertools.pairwise(level):
            least = (breadths[one] + breadths[other]) / 2 + GAP
            assert middles[other] - middles[one] >= least - 1e-6
        level = [child for node in level for child in below.get(node, ())]
    for parent, children in below.items():
        if parent >= 0:
            middle = (middles[children[0]] + middles[children[-1]]) / 2
            assert abs(middles[parent] - middle) < 1e-6
    assert abs(min(at - breadths[i] / 2 for i, at in enumerate(middles))) < 1e-6


def test_nothing_is_laid_out_nowhere() -> None:
    assert tidy([], [], GAP) == []


@pytest.mark.slow
def test_a_chain_is_a_line_and_needs_no_recursion() -> None:
    middles = tidy([index - 1 for index in range(20_000)], [10.0] * 20_000, GAP)
    assert set(middles) == {5.0}


def test_equal_leaves_are_spread_evenly() -> None:
    assert tidy([-1, 0, 0, 0], [10.0] * 4, GAP)[1:] == [5.0, 20.0, 35.0]
