"""Fixes below their finding: the lines that change, and how far to trust that."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from reported import (
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
    report,
    texts,
    unit_finding,
)

from kinlint.edits import Edit, applied
from kinlint.finding import Fix, TextEdit
from kinlint.reporters.full import render
from kinlint.reporters.hunk import hunks, lines
from kinlint.reporters.terminal_style import Style
from kinlint.text import Location, SourceText, Span


def shown(*fixes: Fix, style: Style = PLAIN, unsafe: bool | None = None) -> list[str]:
    """The headline, and the lines that tell of *fixes*."""
    finding = unit_finding(at(DYNAMICS, '"M"'), fixes=fixes)
    told = "".join(render(report(finding, unsafe=unsafe), style)).splitlines()
    first = next((n for n, line in enumerate(told) if "help" in line), len(told) - 2)
    return [told[0], *told[first:-2]]


def block(source: SourceText, *edits: tuple[int, int, str]) -> list[str]:
    """The lines that tell of *edits*, without title and frame."""
    made = [TextEdit(Location(source, Span(start, end)), new) for start, end, new in edits]
    finding = unit_finding(Location(source, Span(0, 1)), fixes=(fix(*made),))
    told = "".join(render(report(finding), PLAIN)).splitlines()
    start = told.index("help: Express it in frame 'rob:link2-root'")
    return told[start + 2 : -3]


def test_an_unsafe_fix_is_shown_with_its_reason() -> None:
    """Title, lines, and what `--fix` alone will not do."""
    assert shown(UNSAFE) == [
        "warning[UNI002]: Unit 'M' does not fit. [AP5, AP6] [*!]",
        "help: Express it in frame 'rob:link2-root'",
        "  |",
        '7 -       "as-seen-by": "rob:link1-root",',
        '7 +       "as-seen-by": "rob:link2-root",',
        "  |",
        "note: unsafe fix: The numbers stay as they are.",
    ]


@pytest.mark.parametrize(
    ("fixes", "unsafe", "sign"),
    [
        ((), None, "AP6]"),
        ((SAFE,), None, "AP6] [*]"),
        ((UNSAFE,), None, "AP6] [*!]"),
        ((UNSAFE,), False, "AP6] [*!]"),
        ((UNSAFE,), True, "AP6] [*]"),
        ((UNSAFE, SAFE), None, "AP6] [*]"),
        ((DISPLAY,), True, "AP6]"),
        ((DISPLAY, UNSAFE), None, "AP6] [*!]"),
    ],
)
def test_a_sign_tells_what_fixes_it(fixes: tuple[Fix, ...], unsafe: bool | None, sign: str) -> None:  # noqa: FBT001
    """`[*]` is for `--fix`, `[*!]` for `--unsafe-fixes`; what is shown only has none."""
    assert shown(*fixes, unsafe=unsafe)[0].endswith(sign)


def test_a_safe_fix_needs_no_note_and_one_for_show_says_that_it_is() -> None:
    assert shown(SAFE)[-1] == "  |"
    assert shown(DISPLAY)[-1] == "note: never made by --fix: Nobody knows."


def test_of_many_fixes_the_first_are_shown() -> None:
    many = shown(SAFE, SAFE, UNSAFE, SAFE, SAFE)
    assert sum(line.startswith("help: Express") for line in many) == 3
    assert many[-1] == "help: 2 more fixes"
    assert shown(SAFE, SAFE, SAFE, SAFE)[-1] == "help: 1 more fix"


def test_what_changes_in_another_file_stands_below_its_name() -> None:
    made = fix(edit(SKELETON, '"rob:link1"', '"rob:link2"'))
    assert shown(made)[2:6] == [
        " ::: models/skeleton.jsonld:2",
        "  |",
        '2 -   { "@id": "rob:link1-root", "of-body": "rob:link1" }',
        '2 +   { "@id": "rob:link1-root", "of-body": "rob:link2" }',
    ]
    both = fix(*made.edits, edit(DYNAMICS, '"M"', '"CM"'))
    assert [line for line in shown(both) if ":::" in line] == [
        " ::: models/skeleton.jsonld:2",
        " ::: models/dynamics.jsonld:8",
    ]


FIVE = SourceText("m.jsonld", "one\ntwo\nthree\nfour\nfive\n")


def test_lines_that_only_come_or_go_stand_between_their_neighbours() -> None:
    """So one sees where."""
    assert block(FIVE, (3, 3, "\nand")) == ["1 | one", "2 + and", "3 | two"]
    assert block(FIVE, (4, 8, "")) == ["1 | one", "2 - two", "2 | three"]
    assert block(FIVE, (0, 0, "zero\n")) == ["1 + zero", "2 | one"]


def test_places_far_apart_are_parted_by_dots_and_numbered_as_they_will_be() -> None:
    assert block(FIVE, (3, 3, "\nand"), (19, 23, "5")) == [
        "1 | one",
        "2 + and",
        "3 | two",
        "...",
        "5 - five",
        "6 + 5",
    ]


def test_long_lines_are_cut_round_what_changes() -> None:
    source = SourceText("m.jsonld", "[" + "1, " * 40_000 + '"M"]')
    at_end = len(source.text) - 4
    old, new = block(source, (at_end, at_end + 3, '"CM"'))
    assert old.startswith("1 - …")
    assert old.endswith('1, "M"]')
    assert new.endswith('1, "CM"]')
    assert len(old) < 145


def test_many_lines_are_shown_in_part() -> None:
    source = SourceText("m.jsonld", "x\n" * 30)
    told = block(source, (0, 60, "y\n" * 30))
    assert len(told) == 21
    assert told[-1] == "... 40 more lines"


def test_in_colour_lines_that_go_are_red_and_those_that_come_are_green() -> None:
    told = shown(SAFE, style=Style(color=True))
    assert "\x1b[31m- " in told[3]
    assert "\x1b[32m+ " in told[4]


@given(st.data())
def test_hunks_make_the_lines_that_the_edits_make(data: st.DataObject) -> None:
    """For any edits of any text, unless they make one end of a line of two."""
    source = SourceText("m.jsonld", data.draw(texts))
    edits = [Edit(one.location.span, one.text) for one in data.draw(edits_in(source))]
    before = (source.text[: edit.span.start] for edit in edits)
    assume(not any(text.endswith("\r") for text in before))
    old = lines(source.text)
    new: list[str] = []
    at_line = 1
    for hunk in hunks(source, edits):
        new += old[at_line - 1 : hunk.old - 1]
        assert len(new) + 1 == hunk.new
        assert tuple(old[hunk.old - 1 : hunk.old - 1 + len(hunk.removed)]) == hunk.removed
        new += hunk.added
        at_line = hunk.old + len(hunk.removed)
    joined = "\n".join([*new, *old[at_line - 1 :]])
    assert joined == "\n".join(lines(applied(source.text, edits)))


def test_the_same_finding_often_shows_its_fix_once() -> None:
    """Beyond fifty, one stands for all."""
    findings = [replace(INERTIA_FINDING, fixes=(SAFE,)) for _ in range(60)]
    told = "".join(render(report(*findings), PLAIN))
    assert told.count("help: ") == 1
