"""JSON as the samples are written."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from kinlint.conversion.json_layout import WIDTH, format_json

SAMPLES = Path(__file__).resolve().parents[2] / "samples"


@pytest.mark.parametrize(
    "name", ["six-axis/arm", "gripper/geometry", "gripper/skeleton", "joint-kinds/joints"]
)
def test_samples_are_laid_out_like_this(name):
    text = (SAMPLES / f"{name}.jsonld").read_text(encoding="utf-8")
    assert format_json(json.loads(text)) + "\n" == text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ({}, "{}"),
        ([], "[]"),
        ([[1.0, 2], "é"], '[ [ 1.0, 2 ], "é" ]'),
        ({"a": None, "b": [True]}, '{ "a": null, "b": [ true ] }'),
    ],
)
def test_what_fits_is_on_one_line(value, text):
    assert format_json(value) == text


def test_no_line_is_wider_unless_a_word_is():
    value = {"names": [f"robot:link/{number}" for number in range(40)], "nested": [{"a": "b" * 98}]}
    lines = format_json(value).splitlines()
    assert json.loads("\n".join(lines)) == value
    assert [line for line in lines if len(line) > WIDTH] == ['      "a": "' + "b" * 98 + '"']
