"""A JSON Pointer finds what RFC 6901 says, at its place in the text."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.suppression.json_pointer import locate

RFC = '{"foo": ["bar", "baz"], "": 0, "a/b": 1, "c%d": 2, "i\\\\j": 5, " ": 7, "m~n": 8}'


@pytest.mark.parametrize(
    ("pointer", "text"),
    [
        ("", RFC),
        ("/foo", '["bar", "baz"]'),
        ("/foo/0", '"bar"'),
        ("/foo/1", '"baz"'),
        ("/", "0"),
        ("/a~1b", "1"),
        ("/c%d", "2"),
        ("/i\\j", "5"),
        ("/ ", "7"),
        ("/m~0n", "8"),
    ],
)
def test_the_examples_of_the_standard(pointer, text):
    """RFC 6901, section 5."""
    place = locate(RFC, pointer)

    assert place is not None
    assert RFC[slice(*place.value)] == text


@pytest.mark.parametrize("pointer", ["/bar", "/foo/2", "/foo/-", "/foo/x", "/foo/0/0", "foo"])
def test_what_is_not_there_has_no_place(pointer):
    """Missing members, elements out of range, steps into scalars, pointers that are none."""
    assert locate(RFC, pointer) is None


@pytest.mark.parametrize("text", ["", "{", "[", '{"a"', '{"a": }', "# Turtle", "[[[" * 40_000])
def test_what_is_not_json_has_no_places(text):
    """Broken and foreign texts are no reason to fail."""
    assert locate(text, "/0") is None


def test_the_last_of_equal_keys_counts():
    """As for readers of JSON."""
    text = '{"a": 1, "a": 2}'

    place = locate(text, "/a")

    assert place is not None
    assert text[slice(*place.value)] == "2"


def test_a_member_has_its_key_in_front():
    """An element and the whole have none."""
    text = '{ "a" : [1] }'

    members = [locate(text, pointer).member for pointer in ("/a", "/a/0", "")]

    assert [text[slice(*span)] for span in members] == ['"a" : [1]', "1", text]


_VALUES = st.recursive(
    st.none() | st.integers() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
)


def _places(value, pointer=""):
    yield pointer, value
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _places(inner, f"{pointer}/{key.replace('~', '~0').replace('/', '~1')}")
    if isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _places(inner, f"{pointer}/{index}")


@pytest.mark.slow
@given(_VALUES, st.sampled_from([None, 1]))
def test_every_value_is_found(value, indent):
    """The text at a pointer's place says the value that is there."""
    text = json.dumps(value, indent=indent)

    for pointer, inner in _places(value):
        place = locate(text, pointer)
        assert place is not None
        assert json.loads(text[slice(*place.value)]) == inner
