"""What reviewdog gets: diagnostics by its schema, and suggestions of whole lines."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reported import (
    BOTH,
    DISPLAY,
    DYNAMICS,
    INERTIA_FINDING,
    PLAIN,
    SAFE,
    SKELETON,
    UNSAFE,
    at,
    edit,
    edits_in,
    fix,
    here,
    report,
    reports,
    texts,
    unit_finding,
)

from kinlint.edits import Edit, applied
from kinlint.errors import SourceError
from kinlint.finding import Fix, TextEdit
from kinlint.report import Report
from kinlint.reporters.excerpt import bounds
from kinlint.reporters.reviewdog import diagnostic_result, lines
from kinlint.reporters.reviewdog.diagnostic import suggestion
from kinlint.reporters.terminal_style import Style
from kinlint.text import Location, SourceText, Span


def exactly(properties: dict[str, Any], *optional: str) -> dict[str, Any]:
    """The schema of an object with just these properties."""
    return {
        "type": "object",
        "properties": properties,
        "required": [name for name in properties if name not in optional],
        "additionalProperties": False,
    }


POSITIVE = {"type": "integer", "minimum": 1}
POSITION = exactly({"line": POSITIVE, "column": POSITIVE}, "column")
RANGE = exactly({"start": POSITION, "end": POSITION}, "end")
LINE = exactly({"line": POSITIVE})
LOCATION = exactly({"path": {"type": "string"}, "range": RANGE}, "range")
SOURCE = exactly({"name": {"const": "kinlint"}, "url": {"type": "string"}})
DIAGNOSTIC = exactly(
    {
        "message": {"type": "string"},
        "location": LOCATION,
        "severity": {"enum": ["ERROR", "WARNING", "INFO"]},
        "source": SOURCE,
        "code": exactly({"value": {"type": "string"}, "url": {"type": "string"}}),
        "suggestions": {
            "type": "array",
            "maxItems": 1,
            "items": exactly(
                {"range": exactly({"start": LINE, "end": LINE}), "text": {"type": "string"}}
            ),
        },
        "related_locations": {
            "type": "array",
            "items": exactly({"message": {"type": "string"}, "location": LOCATION}),
        },
    },
    *("source", "code", "suggestions", "related_locations"),
)
RESULT = exactly({"source": SOURCE, "diagnostics": {"type": "array", "items": DIAGNOSTIC}})
"""What of proto/rdf/jsonschema/DiagnosticResult.jsonschema is made use of, and no more."""


def diagnostics(made: Report, style: Style = PLAIN) -> list[dict[str, Any]]:
    """The diagnostics of the one format; those of the other are the same."""
    whole = json.loads("".join(diagnostic_result.render(made, style)))
    jsonschema.Draft202012Validator(RESULT).validate(whole)
    each = [json.loads(line) for line in "".join(lines.render(made, style)).split("\n")[:-1]]
    source = whole["source"]
    assert each == [{**one, "source": source} for one in whole["diagnostics"]]
    listed: list[dict[str, Any]] = whole["diagnostics"]
    return listed


def test_a_diagnostic_says_what_where_and_where_to_read_on() -> None:
    first, second = diagnostics(BOTH)
    assert second == {
        "message": "Unit 'M' does not fit.",
        "location": {
            "path": "models/dynamics.jsonld",
            "range": {"start": {"line": 8, "column": 15}, "end": {"line": 8, "column": 18}},
        },
        "severity": "WARNING",
        "code": {
            "value": "UNI002",
            "url": "https://w3id.org/kinlint/rules/unit-quantity-mismatch",
        },
    }
    assert first["related_locations"][1]["location"]["path"] == "models/skeleton.jsonld"


def test_columns_count_bytes() -> None:
    """As the format says; everything else of kinlint counts characters."""
    (told,) = diagnostics(report(unit_finding(here('é"😀": 1\nü', 1, 4))))
    assert told["location"]["range"] == {
        "start": {"line": 1, "column": 3},
        "end": {"line": 1, "column": 9},
    }


def test_what_is_suppressed_is_no_comment_and_what_is_unreadable_is() -> None:
    errors = SourceError("a.jsonld", "no JSON", 3, 4), SourceError("b.jsonld", "gone")
    told = diagnostics(report(replace(INERTIA_FINDING, suppressed="known"), errors=errors))
    assert [one["message"] for one in told] == ["no JSON", "gone"]
    assert told[0]["location"]["range"] == {"start": {"line": 3, "column": 4}}
    assert "range" not in told[1]["location"]


@pytest.mark.parametrize(
    ("fixes", "unsafe", "count"),
    [
        ((SAFE,), None, 1),
        ((UNSAFE,), None, 0),
        ((UNSAFE,), True, 1),
        ((SAFE, UNSAFE), True, 1),
        ((DISPLAY,), True, 0),
    ],
)
def test_only_what_fix_would_write_is_suggested(
    fixes: tuple[Fix, ...],
    unsafe: bool | None,  # noqa: FBT001
    count: int,
) -> None:
    """And one of several: reviewdog cannot offer a choice."""
    (told,) = diagnostics(report(replace(INERTIA_FINDING, fixes=fixes), unsafe=unsafe))
    assert len(told.get("suggestions", ())) == count


def test_a_suggestion_is_of_whole_lines() -> None:
    assert suggestion(SAFE, DYNAMICS.name) == {
        "range": {"start": {"line": 7}, "end": {"line": 7}},
        "text": '      "as-seen-by": "rob:link2-root",',
    }


def test_what_is_not_in_reach_of_a_comment_is_not_suggested() -> None:
    """Other files, several files, many lines, and one line that is a whole model."""
    there = edit(SKELETON, '"rob:link1"', '"rob:link2"')
    assert suggestion(fix(there), DYNAMICS.name) is None
    assert suggestion(fix(edit(DYNAMICS, '"M"', '"CM"'), there), DYNAMICS.name) is None
    for text in ("x\n" * 25, "x" * 20_000 + "\n"):
        source = SourceText("m", text)
        whole = TextEdit(Location(source, Span(0, len(text) - 1)), "y")
        assert suggestion(fix(whole), "m") is None


def test_a_line_that_goes_takes_its_neighbour_along() -> None:
    """No text in the place of a line could mean an empty line."""
    source = SourceText("m", "one\ntwo\n")
    assert suggestion(fix(TextEdit(at(source, "one\n"), "")), "m") == {
        "range": {"start": {"line": 1}, "end": {"line": 2}},
        "text": "two",
    }
    assert suggestion(fix(TextEdit(at(source, "one"), "")), "m") == {
        "range": {"start": {"line": 1}, "end": {"line": 2}},
        "text": "\ntwo",
    }


@given(st.data())
def test_a_suggestion_writes_what_the_edits_write(data: st.DataObject) -> None:
    """For any edits of any text."""
    source = SourceText("m", data.draw(texts))
    edits = data.draw(edits_in(source))
    told = suggestion(fix(*edits), "m")
    if told is None:
        return
    start = bounds(source, told["range"]["start"]["line"])[0]
    end = bounds(source, told["range"]["end"]["line"])[1]
    written = source.text[:start] + told["text"] + source.text[end:]
    assert told["text"]
    assert written == applied(source.text, (Edit(one.location.span, one.text) for one in edits))


@pytest.mark.slow
@given(reports())
def test_any_report_is_valid(made: Report) -> None:
    for style in (PLAIN, Style(unicode=False)):
        assert len(diagnostics(made, style)) == len(made.findings)
