from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from reported import (
    BOTH,
    INERTIA_FINDING,
    PLAIN,
    SAFE,
    UNSAFE,
    here,
    report,
    reports,
    unit_finding,
)

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters import json_array, json_lines
from kinlint.reporters.terminal_style import Style

PLACE = {"filename": "models/dynamics.jsonld"}


def array(made: Report, style: Style = PLAIN) -> list[dict[str, Any]]:
    text = "".join(json_array.render(made, style))
    assert text.endswith("]\n")
    loaded: list[dict[str, Any]] = json.loads(text)
    return loaded


def test_an_object_has_the_fields_of_ruff_and_ours() -> None:
    first, second = array(BOTH)
    assert second == {
        "filename": "models/dynamics.jsonld",
        "code": "UNI002",
        "name": "unit-quantity-mismatch",
        "message": "Unit 'M' does not fit.",
        "location": {"row": 8, "column": 15},
        "end_location": {"row": 8, "column": 18},
        "severity": "warning",
        "url": "https://w3id.org/kinlint/rules/unit-quantity-mismatch",
        "fix": None,
        "fixes": [],
        "iri": "https://example.org/robot#length",
        "related": [],
        "reason": None,
        "because": [],
        "consequences": [],
        "taxa": ["AP5", "AP6"],
    }
    assert first["related"][0] == {
        "filename": "models/dynamics.jsonld",
        "location": {"row": 5, "column": 18},
        "end_location": {"row": 5, "column": 29},
        "message": "but the inertia belongs to rob:link2",
    }
    assert first["because"][1] == {
        "statement": "link1-root a Frame",
        "inferred": True,
        "axiom": "what has an origin is a Frame",
        "depth": 0,
        "filename": None,
        "location": None,
        "end_location": None,
    }
    assert first["because"][2]["filename"] == "models/skeleton.jsonld"


def test_a_fix_has_the_fields_of_ruff_and_the_first_is_preferred() -> None:
    """Edits are in the places of the file, and name it: a fix may change several."""
    (told,) = array(report(replace(INERTIA_FINDING, fixes=(UNSAFE, SAFE))))
    assert told["fix"] == told["fixes"][0]
    assert told["fix"] == {
        "applicability": "unsafe",
        "message": "Express it in frame 'rob:link2-root'",
        "why": "The numbers stay as they are.",
        "update": "DELETE WHERE {}",
        "edits": [
            {
                "content": '"rob:link2-root"',
                "filename": "models/dynamics.jsonld",
                "location": {"row": 7, "column": 21},
                "end_location": {"row": 7, "column": 37},
            }
        ],
    }
    assert [fix["applicability"] for fix in told["fixes"]] == ["unsafe", "safe"]
    assert told["fixes"][1]["why"] is None


def test_no_findings_are_an_empty_array_and_no_lines() -> None:
    assert "".join(json_array.render(Report(), Style())) == "[]\n"
    assert "".join(json_lines.render(Report(), Style())) == ""


def test_a_file_that_cannot_be_read_is_an_object_without_a_code() -> None:
    errors = (SourceError("a.jsonld", "no JSON", 3, 4), SourceError("b.jsonld", "gone"))
    first, second = array(Report(errors=errors))
    assert first["code"] is None
    assert first["location"] == {"row": 3, "column": 4}
    assert second["location"] == {"row": 1, "column": 1}
    assert first.keys() == array(BOTH)[0].keys()


def test_a_suppressed_finding_says_why() -> None:
    finding = replace(unit_finding(here("x", 0, 1)), suppressed="known")
    assert array(report(finding))[0]["suppressed"] == "known"


@pytest.mark.slow
@given(reports())
def test_columns_are_code_points_and_ends_exclude(made: Report) -> None:
    for finding, loaded in zip(made.findings, array(made), strict=True):
        source = finding.location.source
        start, end = (
            source.line_starts[place["row"] - 1] + place["column"] - 1
            for place in (loaded["location"], loaded["end_location"])
        )
        assert (start, end) == finding.location.span


@pytest.mark.slow
@given(reports())
def test_lines_hold_the_objects_of_the_array(made: Report) -> None:
    for style in (Style(), Style(unicode=False)):
        text = "".join(json_lines.render(made, style))
        assert [json.loads(line) for line in text.split("\n")[:-1]] == array(made, style)
        assert style.unicode or text.isascii()
