"""Fixes in SARIF do what they do in the file, however they are applied."""

from __future__ import annotations

from dataclasses import replace
from pathlib import PurePosixPath
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from reported import (
    DISPLAY,
    DYNAMICS,
    INERTIA_FINDING,
    SAFE,
    SKELETON,
    UNSAFE,
    edit,
    edits_in,
    fix,
    report,
    texts,
    unit_finding,
)
from sarif_reader import (
    by_column,
    by_offset,
    by_specification,
    by_viewer,
    file_name,
    overlapping,
    results,
)

from kinlint.edits import Edit, applied
from kinlint.finding import Fix, TextEdit
from kinlint.reporters.sarif.sarif_fix import anchored
from kinlint.reporters.sarif.sarif_log import log
from kinlint.text import Location, SourceText, Span


def told(made: Fix) -> dict[str, Any]:
    """The fix as the log has it."""
    location = Location(made.sources[0], Span(0, 0))
    (result,) = results(log(report(unit_finding(location, fixes=(made,)))))
    (object_,) = result["fixes"]
    assert isinstance(object_, dict)
    return object_


def written(source: SourceText, edits: tuple[TextEdit, ...]) -> str:
    """What `--fix` writes."""
    return applied(source.text, (Edit(one.location.span, one.text) for one in edits))


def test_a_fix_says_what_it_does_where_and_how_far_it_may_be_trusted() -> None:
    """Title, one file, lines and columns and offsets, and the update that was worked out."""
    assert told(UNSAFE) == {
        "description": {"text": "Express it in frame 'rob:link2-root'"},
        "artifactChanges": [
            {
                "artifactLocation": {"uri": "models/dynamics.jsonld", "uriBaseId": "SRCROOT"},
                "replacements": [
                    {
                        "deletedRegion": {
                            "startLine": 7,
                            "startColumn": 21,
                            "endLine": 7,
                            "endColumn": 37,
                            "charOffset": 156,
                            "charLength": 16,
                        },
                        "insertedContent": {"text": '"rob:link2-root"'},
                    }
                ],
            }
        ],
        "properties": {
            "kinlint/applicability": "unsafe",
            "kinlint/sparqlUpdate": "DELETE WHERE {}",
            "kinlint/why": "The numbers stay as they are.",
        },
    }


def test_the_preferred_fix_comes_first_and_what_is_never_made_is_left_out() -> None:
    """Viewers offer every fix that they find, to be made at a click; no two may be equal."""
    fixes = (UNSAFE, DISPLAY, SAFE, UNSAFE)
    (result,) = results(log(report(replace(INERTIA_FINDING, fixes=fixes))))
    levels = [one["properties"]["kinlint/applicability"] for one in result["fixes"]]
    assert levels == ["unsafe", "safe"]
    (result,) = results(log(report(replace(INERTIA_FINDING, fixes=(DISPLAY,)))))
    assert "fixes" not in result


def test_a_fix_of_two_files_has_a_change_for_each() -> None:
    """All of it or nothing, so both belong to one fix."""
    made = fix(edit(DYNAMICS, '"M"', '"CM"'), edit(SKELETON, '"rob:link1"', '"rob:link2"'))
    changes = told(made)["artifactChanges"]
    names = [PurePosixPath(file_name(one["artifactLocation"])).name for one in changes]
    assert names == ["dynamics.jsonld", "skeleton.jsonld"]


def test_a_deletion_says_that_nothing_comes_instead() -> None:
    """reviewdog fails without `insertedContent`."""
    (change,) = told(fix(edit(DYNAMICS, '"rob:link2",', "")))["artifactChanges"]
    assert change["replacements"][0]["insertedContent"] == {"text": ""}


CASES = {
    "new line": ("{\n  a\n}", (3, 3), "  b,\n"),
    "new line before": ("{\n  a\n}", (1, 1), "\n  b,"),
    "line deleted": ("{\n  a,\n  b\n}", (2, 6), ""),
    "re-indented": ("{\n  a\n}", (2, 4), "\t"),
    "blank line": ("{\n\n  \n  a\n}", (2, 5), ""),
    "at the end": ("{}\n", (3, 3), "x\n"),
    "only blanks": ("  \n", (1, 2), "x"),
    "same blanks": ("{\n  a\n}", (1, 5), "\n    b"),
    "no-break space": ("{\n\xa0 a\n}", (2, 3), ""),
    "astral": ('{\r\n\t"😀": 1\r\n}', (4, 7), '"é"'),
}


@pytest.mark.parametrize("case", CASES)
def test_three_ways_to_apply_a_fix_give_what_is_written(case: str) -> None:
    """By offsets, by lines and columns, and as a viewer does that passes over indentation."""
    text, span, new = CASES[case]
    source = SourceText("m.jsonld", text)
    edits = (TextEdit(Location(source, Span(*span)), new),)
    (change,) = told(fix(*edits))["artifactChanges"]
    assert by_specification(source, change) == written(source, edits)
    if case != "only blanks":
        assert by_viewer(source, change) == written(source, edits)


@st.composite
def edited(draw: st.DrawFn) -> tuple[SourceText, tuple[TextEdit, ...]]:
    source = SourceText("m.jsonld", draw(texts))
    return source, draw(edits_in(source))


@given(edited())
def test_any_edits_come_out_the_same(drawn: tuple[SourceText, tuple[TextEdit, ...]]) -> None:
    """Whatever is deleted and written, in whatever text."""
    source, edits = drawn
    (change,) = told(fix(*edits))["artifactChanges"]
    assert not overlapping(change["replacements"])
    for one in change["replacements"]:
        region = one["deletedRegion"]
        assert by_offset(source, region) == by_column(source, region)
    assert by_specification(source, change) == written(source, edits)
    assume(source.text[:1].strip("\ufeff \t\r\n\u2028"))
    assert by_viewer(source, change) == written(source, edits)


@given(edited())
def test_no_region_starts_at_a_blank(drawn: tuple[SourceText, tuple[TextEdit, ...]]) -> None:
    """Unless there is nothing but blanks before it."""
    source, edits = drawn
    text = source.text
    for span, _ in anchored(text, [Edit(one.location.span, one.text) for one in edits]):
        before, first = text[: span.start], text[span.start : span.start + 1]
        assert first.strip("\ufeff \t\r\n\u2028") or not before.strip("\ufeff \t\r\n\u2028")
