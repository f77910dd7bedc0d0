"""Comments that silence rules: what they name, and what they cover."""

from __future__ import annotations

import pytest
from reading_xml import model, short

from kinlint.vocabulary import KL

LINKS = """\
<robot name='r'>
  <link name='a'><inertial/></link>
  {}
  <link name='b'><inertial/></link>
  {}
</robot>
"""


ON_A = "<!-- kinlint: ignore[A] -->"


def covered(text: str) -> list[str]:
    arm = model(text)
    return [short(arm, s) for s, p, _ in arm.statements if p == f"<{KL}ignore>"]


@pytest.mark.parametrize(
    ("text", "nodes"),
    [
        (LINKS.format("<!-- kinlint: ignore[A] -->", ""), ["#/link/b"]),
        (LINKS.format("<!--kinlint:ignore[A]-->\n\n<!-- x -->", ""), ["#/link/b"]),
        (LINKS.format(f"{ON_A} <!-- kinlint: ignore[B] -->", ""), ["#/link/b"] * 2),
        (LINKS.format("<!-- kinlint: file-ignore[A] -->", ""), [""]),
        (LINKS.format("<link name='c'/> <!-- kinlint: ignore[A] -->", ""), ["#/link/c"]),
        (LINKS.format("<link name='c'> <!-- kinlint: ignore[A] --></link>", ""), ["#/link/c"]),
        (LINKS.format(f"<link name='c'><inertial/></link>{ON_A}", ""), ["#/link/c"]),
        (LINKS.format("<link name='c'\n > <!-- kinlint: ignore[A] --></link>", ""), ["#/link/c"]),
        ("<!-- kinlint: ignore[A] -->\n<robot/>", ["#"]),
        ("<robot/><!-- kinlint: ignore[A] -->", ["#"]),
        ("<robot><link/><!-- kinlint: ignorance --><!-- ignore[A] --></robot>", []),
        ("<robot><!-- kinlint: ignore[A", []),
    ],
)  # fmt: skip
def test_a_comment_covers_the_next_element_or_the_one_before_it(
    text: str, nodes: list[str]
) -> None:
    assert covered(text) == nodes


def test_a_comment_after_the_last_element_covers_nothing() -> None:
    assert covered(LINKS.format("", "<!-- kinlint: ignore[A] -->"))[0].startswith("_:")


@pytest.mark.parametrize(
    ("comment", "rules", "reason"),
    [
        ("kinlint: ignore[A1] why not", ["A1"], "why not"),
        ("kinlint: ignore[A1]: why\n  not", ["A1"], "why not"),
        ("kinlint: ignore[A1, b-c,D] \N{EM DASH} why", ["A1", "b-c", "D"], "why"),
        ("  kinlint:ignore [A1]", ["A1"], None),
        ("kinlint: ignore", [""], None),
        ("kinlint: ignore[] for now", [""], "for now"),
    ],
)
def test_a_comment_names_rules_and_a_reason(
    comment: str, rules: list[str], reason: str | None
) -> None:
    arm = model(f"<!--{comment}--><robot/>")
    said = {
        short(arm, p).rpartition("#")[2]: arm.source[arm.map.triples[s, p, o]]
        for s, p, o in arm.statements
        if p == f"<{KL}reason>"
    }
    named = [short(arm, o) for _, p, o in arm.statements if p == f"<{KL}rule>"]
    places = [arm.source[arm.map.triples[t]] for t in arm.statements if t[1] == f"<{KL}rule>"]
    assert named == rules
    assert places == (rules if rules != [""] else [f"<!--{comment}-->"])
    assert (" ".join(said["reason"].split()) if said else None) == reason


def test_a_comment_may_have_an_end() -> None:
    arm = model("<!-- kinlint: ignore[A] until 2030-01-31: new gripper --><robot/>")
    said = {
        short(arm, p).rpartition("#")[2]: (short(arm, o), arm.source[arm.map.triples[s, p, o]])
        for s, p, o in arm.statements
        if p in (f"<{KL}until>", f"<{KL}reason>")
    }
    assert {name.rpartition("/")[2]: both for name, both in said.items()} == {
        "until": ("2030-01-31", "2030-01-31"),
        "reason": ("new gripper", "new gripper"),
    }
