from __future__ import annotations

import re
from dataclasses import replace

import pytest
from hypothesis import given
from reported import BOTH, DYNAMICS, INERTIA_FINDING, PLAIN, at, here, report, reports, unit_finding

from kinlint.errors import SourceError
from kinlint.finding import Finding, Premise, Related
from kinlint.report import Report
from kinlint.reporters.display_width import printable, width
from kinlint.reporters.full import render
from kinlint.reporters.terminal_style import Style
from kinlint.text import Location, SourceText, Span

ESCAPES = re.compile(r"\x1b\[[0-9;]*m|\x1b\]8;;.*?\x1b\\")


def full(*findings: Finding, style: Style = PLAIN, derived: bool = False) -> str:
    return "".join(render(report(*findings, derived=derived), style))


def excerpt(location: Location, style: Style = PLAIN) -> list[str]:
    """The lines of a finding's excerpt, without header and footer."""
    lines = full(unit_finding(location), style=style).splitlines()
    return lines[3:-3]


def test_a_finding_shows_lines_marks_other_files_and_reasons() -> None:
    assert "".join(render(replace(BOTH, derived=True), Style())) == (
        """\
error[INE007]: Inertia 'rob:link2-inertia' is seen by frame 'rob:link1-root' of another body. [AP3]
 --> models/dynamics.jsonld:7:21
  |
5 |       "of-body": "rob:link2",
  |                  ----------- but the inertia belongs to rob:link2
6 |       "reference-point": "rob:link2-root-origin",
7 |       "as-seen-by": "rob:link1-root",
  |                     ^^^^^^^^^^^^^^^^
  |
 ::: models/skeleton.jsonld:2:41
  |
2 |   { "@id": "rob:link1-root", "of-body": "rob:link1" }
  |                                         ----------- fixed to rob:link1 here
  |
  = derived from: link2-inertia of-body link2 (models/dynamics.jsonld:5)
                  link1-root a Frame, inferred: what has an origin is a Frame
                    link1-root of-body link1 (models/skeleton.jsonld:2)
  = docs: kinlint rule INE007

warning[UNI002]: Unit 'M' does not fit. [AP5, AP6]
 --> models/dynamics.jsonld:8:15
  |
6 |       "reference-point": "rob:link2-root-origin",
7 |       "as-seen-by": "rob:link1-root",
8 |       "unit": "M"
  |               ^^^
  |
  = docs: kinlint rule UNI002

"""
    )


def test_lines_between_marks_are_left_out() -> None:
    source = SourceText("m.jsonld", "one\ntwo\nthree\nfour\nfive\nsix\n")
    finding = unit_finding(
        at(source, "six"), related=(Related(at(source, "one"), "a"), Related(at(source, "two"), ""))
    )
    assert full(finding).splitlines()[3:-3] == [
        "1 | one",
        "  | --- a",
        "2 | two",
        "  | ---",
        "3 | three",
        "4 | four",
        "5 | five",
        "6 | six",
        "  | ^^^",
    ]
    far = unit_finding(at(source, "six"), related=(Related(at(source, "one"), "a"),))
    assert full(far).splitlines()[3:7] == ["1 | one", "  | --- a", "...", "4 | four"]


def test_a_place_far_off_in_the_same_file_has_an_excerpt_of_its_own() -> None:
    source = SourceText("m.jsonld", "one\n" + "\n" * 20 + "last\n")
    finding = unit_finding(at(source, "last"), related=(Related(at(source, "one"), "a"),))
    assert "  ::: m.jsonld:1:1\n   |\n 1 | one\n   | --- a\n   |\n" in full(finding)


def test_a_span_of_several_lines_is_marked_on_its_first() -> None:
    assert excerpt(here("x {\n y\n}", 2, 8)) == ["1 | x {", "  |   ^"]


@pytest.mark.parametrize(
    ("text", "offset", "expected"),
    [
        ("", 0, ["1 |", "  | ^"]),
        ("{}", 2, ["1 | {}", "  |   ^"]),
        ("{}\n", 3, ["1 | {}", "2 |", "  | ^"]),
        ("{}\r\nx", 4, ["1 | {}", "2 | x", "  | ^"]),
        ("a\rb", 2, ["1 | a", "2 | b", "  | ^"]),
    ],
)
def test_an_empty_span_has_one_caret(text: str, offset: int, expected: list[str]) -> None:
    assert excerpt(here(text, offset, offset)) == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ('\t"M"', ['1 |     "M"', "  |     ^^^"]),
        ('漢字 "M"', ['1 | 漢字 "M"', "  |      ^^^"]),
        ('e\u0301 "M"', ['1 | e\u0301 "M"', "  |   ^^^"]),
        ('😀 "M"', ['1 | 😀 "M"', "  |    ^^^"]),
        ('\x1b[31m "M"', ['1 | \\u001b[31m "M"', "  |            ^^^"]),
        ('\u202e "M"', ['1 | \\u202e "M"', "  |        ^^^"]),
        ('👩\u200d🚀 "M"', ['1 | 👩\u200d🚀 "M"', "  |      ^^^"]),
    ],
)
def test_carets_stand_below_what_a_terminal_shows(line: str, expected: list[str]) -> None:
    assert excerpt(here(line, line.index('"'), len(line))) == expected


def test_without_unicode_everything_is_ascii() -> None:
    text = 'é 漢 "M" ' + "x" * 300
    lines = excerpt(here(text, 4, 7), Style(unicode=False))
    assert lines[0].startswith('1 | \\u00e9 \\u6f22 "M" xxx')
    assert lines[0].endswith("...")
    assert lines[1] == "  | " + " " * 14 + "^^^"
    assert "".join(lines).isascii()


def test_a_long_line_is_cut_round_the_token() -> None:
    text = "{" + '"a":1,' * 1000 + '"unit":"M"' + ',"b":2' * 1000 + "}"
    start = text.index('"M"')
    first, second = excerpt(here(text, start, start + 3), Style(width=60))
    assert first == '1 | …:1,"a":1,"unit":"M","b":2,"b":2,"b":2,"b":2,"b":…'
    assert second == "  | " + " " * (first.index('"M"') - 4) + "^^^"


def test_a_place_cut_off_from_a_long_line_is_shown_apart() -> None:
    text = '{"body":"A",' + '"a":1,' * 1000 + '"unit":"M"}'
    source = SourceText("m.jsonld", text)
    finding = unit_finding(at(source, '"M"'), related=(Related(at(source, '"A"'), "of this"),))
    assert '::: m.jsonld:1:9\n  |\n1 | {"body":"A","a":1' in full(finding, style=Style(width=60))


def test_more_than_fifty_equal_messages_are_shown_once() -> None:
    source = SourceText("m.jsonld", '"M"\n' * 51)
    many = [unit_finding(Location(source, Span(4 * i, 4 * i + 3))) for i in range(51)]
    assert full(*many[:50]).count("docs: kinlint rule") == 50
    text = full(*many)
    assert text.count("docs: kinlint rule") == 1
    assert " = note: the same at 50 other places: lines 2, 3, " in text
    assert text.endswith(", 11 and 40 more\n  = docs: kinlint rule UNI002\n\n")


def test_a_long_proof_is_cut() -> None:
    finding = unit_finding(here("x", 0, 1), because=(Premise("a b c"),) * 30)
    text = full(finding, derived=True)
    assert text.count("a b c") == 24
    assert "             and 6 more\n" in text


def test_the_arithmetic_is_one_sentence_and_the_derivation_is_for_those_who_ask() -> None:
    finding = replace(INERTIA_FINDING, reason="0.1 > 0.01 + 0.01 = 0.02 kg m².")
    assert "  |\n  = because: 0.1 > 0.01 + 0.01 = 0.02 kg m².\n  = docs: " in full(finding)
    assert "kg m².\n  = derived from: link2-inertia of" in full(finding, derived=True)
    assert "because" not in full(INERTIA_FINDING)


def test_a_suppressed_finding_says_why() -> None:
    finding = replace(unit_finding(here("x", 0, 1)), suppressed="known")
    assert "  = suppressed: known\n  = docs" in full(finding)


def test_files_that_cannot_be_read_are_named_last() -> None:
    error = SourceError("bad.jsonld", "no JSON", 3, 4)
    assert "".join(render(Report(errors=(error,)), Style())) == "error: bad.jsonld:3:4: no JSON\n"


def test_colours_change_nothing_but_colours() -> None:
    colored = full(INERTIA_FINDING, style=Style(color=True, links=True))
    assert "\x1b]8;;https://w3id.org/kinlint/rules/inertia-seen-by-foreign-frame\x1b\\" in colored
    assert "\x1b[1;31m" in colored
    assert ESCAPES.sub("", colored) == full(INERTIA_FINDING)


@pytest.mark.slow
@given(reports())
def test_no_text_of_a_file_reaches_the_terminal_raw(made: Report) -> None:
    text = "".join(render(made, Style()))
    assert all(char.isprintable() or char in "\n\u200d" for char in text)
    assert "".join(render(made, Style(unicode=False))).isascii()


@pytest.mark.slow
@given(reports())
def test_carets_have_the_width_of_what_they_mark(made: Report) -> None:
    for finding in made.findings:
        source, span = finding.location.source, finding.location.span
        line, column = finding.location.start
        if width(printable(source.line(line))) > 100 or set("\r\n") & set(source[span]):
            continue
        text = "".join(render(report(replace(finding, related=(), because=())), Style()))
        row = next(row for row in text.splitlines() if re.fullmatch(r" +\| +\^+", row))
        carets = row.split("| ", 1)[1]
        assert len(carets) - len(carets.lstrip()) == width(
            printable(source.line(line)[: column - 1])
        )
        assert carets.count("^") == max(1, width(printable(source[span].rstrip(" \t"))))


def test_no_line_of_an_excerpt_is_wider_than_the_terminal() -> None:
    for source in (DYNAMICS, SourceText("m.jsonld", "漢" * 900)):
        for offset in (0, 30, len(source.text)):
            location = Location(source, Span(offset, offset))
            assert all(width(row) <= 40 for row in excerpt(location, Style(width=40)))


def test_what_is_computed_is_not_called_inferred() -> None:
    source = SourceText("m.jsonld", "one\ntwo\n")
    because = (
        Premise("turn determinant -1", axiom="computed from"),
        Premise("turn x 0", at(source, "two"), depth=1),
        Premise("turn norm 1", axiom="computed from the same"),
    )
    shown_lines = full(unit_finding(at(source, "one"), because=because), derived=True).splitlines()
    assert [line.strip(" =") for line in shown_lines if "turn" in line] == [
        "derived from: turn determinant -1, computed from:",
        "turn x 0 (m.jsonld:2)",
        "turn norm 1, computed from the same",
    ]
