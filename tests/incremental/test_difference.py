from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from kinlint.incremental.difference import AHEAD, triple_difference

STATEMENTS = st.lists(st.integers(0, 30), unique=True).map(
    lambda numbers: tuple((f"<s:{each}>", "<p:>", f'"{each}"') for each in numbers)
)


@given(STATEMENTS, STATEMENTS)
def test_it_turns_one_into_the_other(old, new):
    """What is not removed and what is added is all that is said then, in whatever order."""
    apart = triple_difference(old, new)

    assert set(old) - apart.removed | apart.added == set(new)
    assert apart.removed <= set(old) - set(new)
    assert apart.added <= set(new) - set(old)


def test_what_is_far_apart_is_found():
    """Longer pieces than are looked for ahead differ, too."""
    old = [(f"<s:{each}>", "<p:>", "<o:>") for each in range(6 * AHEAD)]
    new = old[: 2 * AHEAD] + old[5 * AHEAD :]

    assert triple_difference(old, new).removed == frozenset(old[2 * AHEAD : 5 * AHEAD])
    assert triple_difference(new, old).added == frozenset(old[2 * AHEAD : 5 * AHEAD])
