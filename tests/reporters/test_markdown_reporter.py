"""Markdown, as a renderer of it understands it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from markdown_it import MarkdownIt
from reported import BOTH, PLAIN, UNIT_FINDING, here, messages, report, reports, unit_finding

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters import markdown
from kinlint.reporters.markdown_text import escaped, link, table

NASTY = "|`*_~<b>&amp;</b> [x](y) ![i](u) #1 @you $m$ :tada: https://x \\| www.x.y\n- z"


def html(made: Report) -> str:
    rendered: str = GFM.render("".join(markdown.render(made, PLAIN)))
    return rendered


GFM = MarkdownIt("commonmark").enable("table").enable("strikethrough")


def test_there_is_a_table_by_rule_and_each_finding_at_its_place() -> None:
    text = "".join(markdown.render(replace(BOTH, seconds=1.5), PLAIN))
    assert text == (
        "## kinlint\n\nFound 2 findings (1 error, 1 warning) in 1 file.\n"
        "\n"
        "| Rule | What | Severity | Count |\n"
        "| --- | --- | --- | --: |\n"
        "| [INE007](https://w3id.org/kinlint/rules/inertia-seen-by-foreign-frame)"
        " | inertia is seen by a frame of another body | error | 1 |\n"
        "| [UNI002](https://w3id.org/kinlint/rules/unit-quantity-mismatch)"
        " | unit does not fit its quantity | warning | 1 |\n"
        "\n"
        "### [models/dynamics.jsonld](models/dynamics.jsonld) (1 error and 1 warning)\n"
        "\n"
        "- [7:21](models/dynamics.jsonld#L7) **error**"
        " [INE007](https://w3id.org/kinlint/rules/inertia-seen-by-foreign-frame):"
        " Inertia 'rob:link2-inertia' is seen by frame 'rob:link1-root' of another body.\n"
        "- [8:15](models/dynamics.jsonld#L8) **warning**"
        " [UNI002](https://w3id.org/kinlint/rules/unit-quantity-mismatch):"
        " Unit 'M' does not fit.\n"
    ).replace("'rob:link", "'rob\\:link")


def test_a_clean_run_says_so() -> None:
    text = "".join(markdown.render(report(files=("a.urdf",), applied=3), PLAIN))
    assert text == "## kinlint\n\nAll checks passed (1 file, 0 triples, 3 rules applied).\n"


def test_files_that_cannot_be_read_are_listed() -> None:
    errors = (SourceError("a b.urdf", "no <such> file", 3), SourceError("<stdin>", "no"))
    shown = html(report(errors=errors))
    assert '<a href="a%20b.urdf#L3">a b.urdf:3</a> <strong>error</strong>: no &lt;such&gt;' in shown
    assert "<li>&lt;stdin&gt; <strong>error</strong>: no</li>" in shown


def test_nothing_that_a_file_says_is_markup() -> None:
    finding = unit_finding(here("x", 0, 1, f"{NASTY}.urdf".replace("\n", " ")), message=NASTY)
    shown = html(report(finding))
    assert shown.count("<a ") == 4  # The rule in the table, and file, place and rule in the list.
    for tag in ("<b>", "<img", "<em>", "<code>", "<s>", "<ul>\n<li>z"):
        assert tag not in shown
    assert "https://x" in shown
    assert "@you" not in "".join(markdown.render(report(finding), PLAIN))


@given(messages)
def test_escaped_text_is_shown_as_it_is(text: str) -> None:
    """Its line ends and the blanks round them as one blank."""
    cell = GFM.render(table(("a", "b"), [("x", f"x{escaped(text)}x")], right=1))
    plain = GFM.render(f"x{escaped(text)}x")
    shown = plain.removeprefix("<p>").removesuffix("</p>\n")
    assert "<" not in shown
    assert f">{shown}</td>" in cell


def test_a_link_without_an_address_is_text() -> None:
    assert link("[a]", "") == "\\[a\\]"


@pytest.mark.slow
@given(reports())
def test_each_finding_is_an_item(made: Report) -> None:
    assert html(made).count("<li>") == len(made.findings)
    assert html(report(replace(UNIT_FINDING, suppressed="a toy"))).count("<li>") == 0
