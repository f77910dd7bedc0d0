"""JSON with positions."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.errors import SourceError
from kinlint.formats.json_text.json_parser import MAX_DEPTH, parse
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.text import SourceText, Span

scalars = (
    st.none()
    | st.booleans()
    | st.integers(-(10**30), 10**30)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(st.characters(exclude_categories=["Cs"]))
)
values = st.recursive(
    scalars,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=12,
)
layouts = st.sampled_from([None, 0, 2, "\t"])


def source(text: str) -> SourceText:
    return SourceText("arm.json", text)


def check(text: str, value: Any, span: Span) -> None:
    """Every token at every span is the value it is said to be."""
    assert json.loads(text[span.start : span.end]) == value
    if isinstance(value, Object):
        for key, member in value.items():
            assert json.loads(text[key.start : key.end]) == key
            check(text, member, key.value_span)
    elif isinstance(value, Array):
        for index, element in enumerate(value):
            check(text, element, value.element_span(index))
    elif value is not None and not isinstance(value, bool):
        assert value.span == span


@given(
    value=values,
    indent=layouts,
    ascii_only=st.booleans(),
    newline=st.sampled_from(["\n", "\r\n"]),
)
def test_it_reads_what_the_standard_library_reads(
    value: Any, indent: Any, *, ascii_only: bool, newline: str
) -> None:
    text = json.dumps(value, indent=indent, ensure_ascii=ascii_only).replace("\n", newline)
    parsed = parse(source(f" {text}\n"))
    assert parsed.value == value
    check(f" {text}\n", parsed.value, parsed.span)


def test_numbers_keep_kind_and_place() -> None:
    value = parse(source("[1, -0.5e2, 1E3]")).value
    assert [type(number).__name__ for number in value] == ["Integer", "Real", "Real"]
    assert [number.span for number in value] == [Span(1, 2), Span(4, 10), Span(12, 15)]


def test_the_last_of_equal_keys_wins_and_all_keep_their_places() -> None:
    parsed = parse(source('{"a": 1, "b": 0, "a": 2, "a": 3}'))
    assert parsed.value == {"a": 3, "b": 0}
    assert parsed.value.key("a").start == 25
    assert [(m.key.start, m.value) for m in parsed.value.overwritten] == [(1, 1), (17, 2)]
    assert parsed.repeats == [parsed.value]


@pytest.mark.parametrize(
    ("text", "place", "cause"),
    [
        ("", (1, 1), "empty"),
        (" \n\t", (1, 1), "empty"),
        ('{"a": [1, 2', (1, 12), "cut off: expected ',' or ']'"),
        ('{"a": 1,', (1, 9), "cut off: expected a key"),
        ('{"a"', (1, 5), "cut off: expected ':'"),
        ('{\n  "a": "b', (2, 8), "a string is not closed"),
        ("{} x", (1, 4), "'x' after the end"),
        ("[1,]", (1, 4), "expected a value, found ']'"),
        ('{"a": 1,}', (1, 9), "expected a key in double quotes, found '}'"),
        ("{a: 1}", (1, 2), "expected a key in double quotes, found 'a'"),
        ("{'a': 1}", (1, 2), "expected a key"),
        ('{"a" 1}', (1, 6), "expected ':'"),
        ("[1 2]", (1, 4), "expected ',' or ']', found '2'"),
        ('["\\x"]', (1, 3), "escape"),
        ('["a\tb"]', (1, 4), "control character"),
        ("[NaN]", (1, 2), "found 'NaN'"),
        ("[-Infinity]", (1, 2), "found '-Infinity'"),
        ("[nullx]", (1, 2), "found 'nullx'"),
        ("[01]", (1, 2), "found '01'"),
        ("[1.]", (1, 2), "found '1.'"),
        ("[+1]", (1, 2), "found '+1'"),
        ("[1e999]", (1, 2), "too large"),
        ("[" + "9" * 400 + "]", (1, 2), "too large"),
        ("[" + "9" * 5000 + "]", (1, 2), "5000 characters"),
        ('["\\ud800"]', (1, 2), "surrogate"),
        ("[" * (MAX_DEPTH + 1), (1, MAX_DEPTH + 1), "levels deep"),
        ("<robot/>", (1, 1), "found '<robot/>'"),
        ("// hi\n{}", (1, 1), "expected a value"),
    ],
)
def test_errors_say_what_and_where(text: str, place: tuple[int, int], cause: str) -> None:
    with pytest.raises(SourceError) as caught:
        parse(source(text))
    assert (caught.value.line, caught.value.column) == place
    assert cause in caught.value.cause


def test_nesting_up_to_the_limit_is_read() -> None:
    element = parse(source("[" * MAX_DEPTH + "]" * MAX_DEPTH))

    assert element.span.end == 2 * MAX_DEPTH


def test_a_pair_of_surrogates_is_one_character() -> None:
    assert parse(source('"\\ud83e\\udd16"')).value == "\N{ROBOT FACE}"
