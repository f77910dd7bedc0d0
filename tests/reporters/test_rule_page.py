from __future__ import annotations

from dataclasses import replace

from reported import INERTIA, RULES

from kinlint.reporters import rule_page, rule_pages
from kinlint.reporters.rule_example import parse_marks
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Applicability, Example, Repair
from kinlint.text import Span


def test_the_text_explains_the_rule() -> None:
    assert "".join(rule_page.text(INERTIA, Style(), full=True)) == (
        """\
INE007 inertia-seen-by-foreign-frame: inertia is seen by a frame of another body

Severity: error
Anti-pattern: AP3 (Artificial structural constraints)
Formats: jsonld
Since: 0.1.0

An inertia is a matrix of numbers, and numbers need a frame.

A frame that moves against the body makes them wrong.

Bad:

    {
      "as-seen-by": "rob:link1-root"
                    ^^^^^^^^^^^^^^^^
    }

Good:

    { "as-seen-by": "rob:link2-root" }

To ignore it:

  - for one run: --ignore INE007
  - for a project: ignore = ["INE007"] in kinlint.toml
  - for one node of a model: "https://w3id.org/kinlint/ns#ignore": "INE007"

See also:

  - https://example.org/inertia
"""
    )


REPAIR = Repair(
    title="Swap the limits",
    applicability=Applicability.UNSAFE,
    update="DELETE { $this kin:lower ?lower }\nWHERE { $this kin:lower ?lower }",
    query="",
    variables=(),
    removed=(),
    added=(),
    why="Either number\n   may be the wrong one.",
    formats=("urdf", "sdf"),
)
SURE = replace(REPAIR, applicability=Applicability.SAFE, why="")
MENDED = replace(INERTIA, repairs=(REPAIR, SURE))


def test_the_page_tells_what_a_fix_does_and_how_far_to_trust_it() -> None:
    """With the update, as it stands in the rule file."""
    page = "".join(rule_page.text(MENDED, Style(), full=True))
    assert (
        """
Fix: Swap the limits in urdf and sdf (unsafe, so only --fix --unsafe-fixes makes
it). Either number may be the wrong one.

    DELETE { $this kin:lower ?lower }
    WHERE { $this kin:lower ?lower }

Fix: Swap the limits in urdf and sdf (safe, so --fix makes it).
"""
        in page
    )
    assert "```sparql\nDELETE { $this" in rule_page.markdown(MENDED)
    assert rule_page.rule_object(MENDED)["fixes"][0] == {
        "title": "Swap the limits",
        "applicability": "unsafe",
        "why": "Either number may be the wrong one.",
        "formats": ["urdf", "sdf"],
        "update": REPAIR.update,
    }
    assert "| error | jsonld | AP3 | safe | inertia is" in "".join(rule_pages.catalogue([MENDED]))


def test_the_page_is_drawn_where_there_are_colours() -> None:
    text = "".join(rule_page.text(INERTIA, Style(color=True), full=True))
    assert "\x1b[" in text
    assert "rob:link2-root" in text


def test_markdown_has_examples_in_fences() -> None:
    text = rule_page.markdown(INERTIA)
    assert text.startswith("# INE007 inertia-seen-by-foreign-frame\n\n**inertia is seen by")
    assert '```text\n{\n  "as-seen-by": "rob:link1-root"\n  ' in text
    assert '```json\n{ "as-seen-by": "rob:link2-root" }\n```\n' in text
    assert "- <https://example.org/inertia>\n" in text


def test_a_fence_is_longer_than_any_ticks_inside() -> None:
    rule = replace(INERTIA, examples=(Example("jsonld", None, '{"a": "```"}'),))
    assert '````json\n{"a": "```"}\n````' in rule_page.markdown(rule)


def test_the_object_has_examples_without_marks_and_where_they_were() -> None:
    page = rule_page.rule_object(INERTIA)
    assert page["code"] == "INE007"
    assert page["severity"] == "error"
    assert page["url"] == INERTIA.iri
    (example,) = page["examples"]
    assert example["bad"] == '{\n  "as-seen-by": "rob:link1-root"\n}'
    assert example["marks"] == [{"row": 2, "column": 17, "end_row": 2, "end_column": 33}]


def test_the_catalogue_is_one_page_with_an_index_and_a_section_for_each_rule() -> None:
    page = "".join(rule_pages.catalogue(reversed(RULES)))
    table = (
        "| Code | Name | Severity | Formats | Anti-patterns | Fix | Title |\n"
        "|---|---|---|---|---|---|---|\n"
    )
    assert page.startswith("# The rules of kinlint\n")
    assert (
        f"\n### inertia (INE)\n\n{table}"
        "| INE007 | [inertia-seen-by-foreign-frame](#ine007-inertia-seen-by-foreign-frame) "
        "| error | jsonld | AP3 |  | inertia is seen by a frame of another body |\n"
        f"\n### other (UNI)\n\n{table}"
    ) in page
    assert page.count("\n## ") == 4 + len(RULES)
    section = page.partition("\n## INE007 inertia-seen-by-foreign-frame\n\n")[2]
    assert section.startswith("**inertia is seen by a frame of another body**\n\nSeverity: error")
    file = "inertia/inertia-seen-by-foreign-frame.ttl"
    assert f"\n\nRule file: [{file}]({file})\n" in section
    assert "\n\n\n" not in page


def test_a_page_for_each_family_stands_beside_its_rules() -> None:
    pages = rule_pages.pages(RULES)

    assert sorted(pages) == ["README.md", "inertia/README.md"]
    link = "[inertia-seen-by-foreign-frame](inertia/README.md#ine007-inertia-seen-by-foreign-frame)"
    assert link in pages["README.md"]
    assert "\n## INE007" not in pages["README.md"]
    page = pages["inertia/README.md"]
    assert page.startswith("# inertia (INE)\n\nMade from the rule files beside this page")
    assert "| INE007 | [inertia-seen-by-foreign-frame](#ine007-" in page
    assert "\n## INE007 inertia-seen-by-foreign-frame\n\n**" in page
    file = "inertia-seen-by-foreign-frame.ttl"
    assert f"\n\nRule file: [{file}]({file})\n" in page


def test_rules_that_lie_in_no_family_are_explained_in_the_index() -> None:
    page = rule_pages.pages([rule for rule in RULES if not rule.path])["README.md"]

    assert "\n### other (UNI)\n" in page
    assert "\n## UNI" in page


def test_a_rule_that_says_little_has_a_page() -> None:
    rule = replace(INERTIA, why="", examples=(), links=(), antipatterns=(), formats=(), since="")
    assert "Severity: error\n\nTo ignore it" in "".join(rule_page.text(rule, Style(), full=True))
    assert rule_page.help_text(rule) == "kinlint rule INE007"


def test_marks_may_be_nested_and_many() -> None:
    example = parse_marks("a [|b [|c|] d|] e [|f|]", "jsonld")
    assert example.text == "a b c d e f"
    assert example.marks == (Span(2, 7), Span(4, 5), Span(10, 11))


def test_files_beside_an_example_are_named() -> None:
    """Whether they are there is what the rule is about."""
    example = Example("urdf", "<[|robot|]/>", "<robot/>", ("meshes/a.stl", "b.stl"))
    page = rule_page.markdown(replace(INERTIA, examples=(example,)))

    assert "Bad (beside it: meshes/a.stl, b.stl):\n" in page
    assert "\nGood:\n" in page
