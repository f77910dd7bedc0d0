"""Pictures of robots: what is drawn, what is marked, and that names are never markup."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree as ET

import pytest
from drawn import HOSTILE, about, chain, picture, place

from kinlint.reporters.picture.finding_badges import CODES, badge, marks, paired
from kinlint.reporters.picture.formats import FORMATS, pieces
from kinlint.reporters.picture.labels import heading, number
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity
from kinlint.structure import Joint, Link, Structure

SVG = "{http://www.w3.org/2000/svg}"
ARM = chain("base", "upper", "lower", close=True)


def drawn(form: str, *robots: Structure, style: Style | None = None, frames: bool = False) -> str:
    made = picture(about("urn:l1"), robots=robots or (ARM,))
    return "".join(pieces(made, form, style or Style(), frames=frames))


def parsed(svg: str) -> ET.Element:
    return ET.fromstring(svg)  # noqa: S314  it is our own


def texts(svg: str) -> list[str]:
    return [each.text or "" for each in parsed(svg).iter(f"{SVG}text")]


def test_the_tree_as_text() -> None:
    assert drawn("text").splitlines()[:5] == [
        "arm: 3 links, 3 joints, 1 loop",
        "base",
        "└─ j base (revolute) → upper  [✖ UNI002]",
        "   └─ j upper (revolute, mimics j base × -2 + 0.1) → lower",  # noqa: RUF001
        "      └╌ closing (fixed, closes a loop to base)",
    ]


def test_the_tree_in_ascii() -> None:
    text = drawn("text", style=Style(unicode=False))
    assert text.isascii()
    assert "`- j base (revolute) -> upper  [x UNI002]" in text


def test_findings_are_told_below_the_tree() -> None:
    assert drawn("text").splitlines()[-1] == "✖ UNI002 arm.urdf:1:2: Unit 'M' does not fit."


def test_a_deep_tree_goes_on_at_the_margin() -> None:
    lines = drawn("text", chain(*map(str, range(60)))).splitlines()
    assert max(map(len, lines)) < 120
    assert sum("⋯1" in line for line in lines) == 2


def test_svg_has_boxes_ellipses_and_a_dashed_loop() -> None:
    svg = drawn("svg")
    root = parsed(svg)
    kinds = [each.get("class", "") for each in root.iter(f"{SVG}g")]
    assert kinds.count("link") + kinds.count("link error") == 3
    assert (kinds.count("joint"), kinds.count("loop")) == (2, 1)
    assert len(list(root.iter(f"{SVG}ellipse"))) == 3
    assert 'class="edge closing"' in svg
    assert "xyz: 0 0.1 0.33333" in texts(svg)
    assert "rpy: 0 0 1.5708" in texts(svg)


def test_marks_are_words_and_not_colours_alone() -> None:
    for form in FORMATS:
        assert "✖ UNI002" in drawn(form)


@pytest.mark.parametrize("form", FORMATS)
def test_frames_are_drawn_if_asked_for(form: str) -> None:
    assert "f base" not in drawn(form)
    assert "f base" in drawn(form, frames=True)


@pytest.mark.parametrize("form", FORMATS)
def test_names_are_never_markup(form: str) -> None:
    for name in HOSTILE:
        text = drawn(form, chain("first", name, "last", close=True), frames=True)
        text.encode()
        assert not re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\u2028\u202e]", text)
        if form == "svg":
            root = parsed(text)
            assert {each.tag.removeprefix(SVG) for each in root.iter()} <= {
                *("svg", "g", "rect", "ellipse", "path", "text", "title", "style"),
                *("defs", "marker"),
            }


def test_names_are_found_in_the_picture_as_they_are() -> None:
    named = texts(drawn("svg", chain('<b>"&', "größe")))
    assert '<b>"&' in named
    assert "größe" in named


@pytest.mark.parametrize("form", ["svg", "dot", "mermaid"])
def test_a_stream_without_unicode_gets_references(form: str) -> None:
    text = drawn(form, chain("größe", "😀"), style=Style(unicode=False))
    assert text.isascii()
    if form == "svg":
        assert {"größe", "😀"} <= set(texts(text))


@pytest.mark.parametrize("form", FORMATS)
def test_several_robots_are_one_picture(form: str) -> None:
    text = drawn(form, chain("a", "b"), chain("c", "d"))
    assert all(name in text for name in ("j a", "j c"))


def test_wide_and_deep_robots_keep_a_shape_that_fits_a_screen() -> None:
    root = parsed(drawn("svg", chain(*map(str, range(61)))))
    wide, high = (float(root.get(side, "0")) for side in ("width", "height"))
    assert high < 2500
    assert 0.2 < wide / high < 5


def test_no_two_shapes_lie_on_each_other() -> None:
    links = tuple(Link(f"urn:l{n}", "name" * (n % 5 + 1)) for n in range(40))
    joints = tuple(
        Joint(f"urn:j{n}", f"joint {n}", "fixed", f"urn:l{n // 3}", f"urn:l{n}")
        for n in range(1, 40)
    )
    root = parsed(drawn("svg", Structure("urn:arm", "arm", links, joints, (), ("urn:l0",))))
    boxes = []
    for group in root.iter(f"{SVG}g"):
        if (shape := group.find(f"{SVG}rect")) is not None and group.get("class") == "link":
            x, y, w, h = (float(shape.get(each, "0")) for each in ("x", "y", "width", "height"))
            boxes.append((x, y, x + w, y + h))
        if (shape := group.find(f"{SVG}ellipse")) is not None:
            x, y, w, h = (float(shape.get(each, "0")) for each in ("cx", "cy", "rx", "ry"))
            boxes.append((x - w, y - h, x + w, y + h))
    assert len(boxes) == len(links) + len(joints)
    for index, (a, b, c, d) in enumerate(boxes):
        for e, f, g, h in boxes[:index]:
            assert c <= e or g <= a or d <= f or h <= b


def test_badges_lie_in_their_shapes() -> None:
    """Also where the name is short and the codes are many."""
    finding = about("urn:l0").rule
    told = [
        about(f"urn:{part}{n}", rule=replace(finding, code=f"RULE00{code}"))
        for part, count in (("l", 3), ("j", 2))
        for n in range(count)
        for code in range(4)
    ]
    made = picture(*told, robots=(chain("a", "b", "c"),))
    root = parsed("".join(pieces(made, "svg", Style())))
    count = 0
    for group in root.iter(f"{SVG}g"):
        badge_ = group.find(f"{SVG}g[@class='badge error']/{SVG}rect")
        if badge_ is None:
            continue
        count += 1
        x, y, w, h = (float(badge_.get(each, "0")) for each in ("x", "y", "width", "height"))
        if (shape := group.find(f"{SVG}rect")) is not None and "link" in group.get("class", ""):
            a, b, c, d = (float(shape.get(each, "0")) for each in ("x", "y", "width", "height"))
            assert a <= x
            assert x + w <= a + c
            assert b <= y
            assert y + h <= b + d
        elif (shape := group.find(f"{SVG}ellipse")) is not None:
            a, b, c, d = (float(shape.get(each, "0")) for each in ("cx", "cy", "rx", "ry"))
            assert a - c <= x
            assert x + w <= a + c
            assert b - d <= y
            assert y + h <= b + d
    assert count == 5


@pytest.mark.parametrize("form", sorted({*FORMATS} - {"text"}))
def test_infos_are_not_marked(form: str) -> None:
    made = picture(about("urn:l1", Severity.INFO), robots=(ARM,))
    drawn_ = "".join(pieces(made, form, Style()))
    assert 'class="badge' not in drawn_
    assert ":::info" not in drawn_
    if form != "svg":
        assert "UNI002" not in drawn_


def test_a_badge_names_the_worst_codes_first() -> None:
    found = marks(ARM, [about("urn:l1", Severity.INFO), about("urn:l1", Severity.ERROR)])
    mark = badge(found["urn:l1"])
    assert mark is not None
    assert (mark.severity, mark.codes, mark.more) == (Severity.ERROR, ("UNI002",), 0)
    assert badge(()) is None
    assert CODES == 3


def test_members_of_a_group_are_marked_each() -> None:
    group = about("urn:l0", members=(about("urn:l0"), about("urn:l2")))
    assert set(marks(ARM, [group])) == {"urn:l0", "urn:l2"}


def test_what_is_about_nothing_drawn_is_marked_where_it_lies() -> None:
    part = Link("urn:l0", "base", whole=place(10))
    arm = Structure("urn:arm", "arm", (part,), roots=("urn:l0",))
    inside, outside = (about("urn:x", location=place(at)) for at in (10, 50))
    assert set(marks(arm, [inside, outside])) == {"urn:l0"}


def test_numbers_have_no_idle_digits() -> None:
    assert [number(value) for value in (0.0, -0.0, 1e-9, 1 / 3, 1.0, -2.50, 1e7)] == [
        *("0", "0", "0", "0.33333", "1", "-2.5", "1e+07"),
    ]


def test_the_heading_counts() -> None:
    assert heading(ARM) == "arm: 3 links, 3 joints, 1 loop"
    assert heading(Structure("urn:arm", "arm")) == "arm: 0 links, 0 joints"


def test_robots_get_the_marks_that_each_would_get() -> None:
    robots = (ARM, chain("a", "b"), Structure("urn:none", "none"))
    found = [about("urn:l0"), about("urn:l2"), about("urn:x", members=(about("urn:l1"),))]
    assert list(paired(robots, found)) == [(each, marks(each, found)) for each in robots]
