"""The nearest of the known names is found, and nothing is made up."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.suggestion import did_you_mean, nearest

CODES = ["UNI001", "UNI002", "LD001", "missing-unit", "unit-quantity-mismatch"]


@pytest.mark.parametrize(
    ("word", "choice"),
    [
        ("UNI0022", "UNI002"),
        ("uni002", "UNI002"),
        ("UIN002", "UNI002"),
        ("mising-unit", "missing-unit"),
        ("unit-quantity", "unit-quantity-mismatch"),
    ],
)
def test_a_slip_is_told(word, choice):
    """Letters too many, of the wrong case, swapped or missing, and beginnings."""
    assert nearest(word, CODES) == choice


@pytest.mark.parametrize("word", ["", "zebra", "X"])
def test_nothing_like_it_is_nothing(word):
    """A word unlike all choices gets no suggestion."""
    assert nearest(word, CODES) is None
    assert did_you_mean(word, CODES) == ""


def test_ties_go_to_the_longer_common_beginning():
    """Of two choices one letter away, the one that begins alike is meant."""
    assert nearest("UNI01", ["XNI01", "UNI02"]) == "UNI02"


@given(st.text(min_size=1), st.lists(st.text(min_size=1)))
def test_a_known_word_is_its_own_nearest(word, others):
    """Nothing is nearer to a word than the word, up to case."""
    found = nearest(word, [*others, word])

    assert found is not None
    assert found.casefold() == word.casefold()


@given(st.text(), st.lists(st.text()))
def test_only_choices_are_suggested(word, choices):
    """A suggestion is one of the choices."""
    assert nearest(word, choices) in {None, *choices}
