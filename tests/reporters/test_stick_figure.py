"""Stick figures: what is drawn where, that tags keep apart, and that names are never markup."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from xml.etree import ElementTree as ET

import pytest
from drawn import HOSTILE, about, chain, standing

from kinlint.reporters.picture.finding_badges import marks
from kinlint.reporters.picture.stick_figure.figure_svg import HEIGHT, TALL, WIDTH, figure
from kinlint.reporters.picture.stick_figure.joint_glyphs import Glyph
from kinlint.reporters.picture.stick_figure.projection import overlaps, project
from kinlint.reporters.picture.stick_figure.skeleton import RADIUS, Skeleton
from kinlint.rule import Severity
from kinlint.structure import Joint, Structure, Vector

SVG = "{http://www.w3.org/2000/svg}"
ZERO: Vector = (0.0, 0.0, 0.0)


def drawn(structure: Structure, *findings) -> str:
    made = figure(structure, marks(structure, findings), name="f", href=lambda _: "#f-1")
    assert made is not None
    return made.svg


def parsed(svg: str) -> ET.Element:
    return ET.fromstring(svg)  # noqa: S314  it is our own


def classes(svg: str) -> list[str]:
    return [each.get("class", "") for each in parsed(svg).iter()]


ARM = standing(chain("base", "upper", "lower"))


def test_links_are_sticks_and_joints_have_an_axis_a_ring_and_a_range() -> None:
    found = classes(drawn(ARM))
    assert [found.count(kind) for kind in ("axis", "head", "ring", "range")] == [2, 2, 2, 2]
    assert found.count("bone") == 2
    assert found.count("moving") == 2


@pytest.mark.parametrize(
    ("changes", "kinds"),
    [
        ({"kind": "fixed"}, []),
        ({"kind": "continuous", "lower": None, "upper": None}, ["ring", "axis", "head"]),
        ({"kind": "prismatic"}, ["range", "end", "end", "axis", "head"]),
        ({"kind": "revolute"}, ["range", "ring", "axis", "head"]),
        ({"direction": None}, []),
    ],
)
def test_the_glyph_tells_the_kind_of_a_joint(changes: dict[str, object], kinds: list[str]) -> None:
    joint = replace(ARM.joints[0], **changes)
    lines = Glyph(joint, ZERO, (0.0, 0.0, 9.0), 5.0, 100.0).lines()
    assert [each.kind for each in lines] == kinds


@pytest.mark.parametrize(
    "limits", [(-1e308, 1e308), (0.0, 0.0), (9.0, -9.0), (1e300, 1e300), (-7.0, 7.0)]
)
def test_the_range_of_any_limits_is_an_arc_about_the_axis(limits: tuple[float, float]) -> None:
    joint = replace(ARM.joints[0], lower=limits[0], upper=limits[1])
    (arc,) = (each for each in Glyph(joint, ZERO, ZERO, 5.0, 100.0).lines() if each.kind == "range")
    assert len(arc.points) < 40
    for x, y, z in arc.points[1:]:
        assert y == pytest.approx(0.0, abs=1e-9)
        assert math.hypot(x, z) == pytest.approx(math.dist(ZERO, arc.points[1]))


def test_the_range_begins_where_the_link_is_at_zero() -> None:
    joint = replace(ARM.joints[0], lower=0.0, upper=1.0)
    arc = next(Glyph(joint, ZERO, (0.0, 0.0, 9.0), 5.0, 100.0).lines())
    x, y, z = arc.points[1]
    assert (x, y) == pytest.approx((0.0, 0.0))
    assert z > 0.0


def test_a_robot_fits_whatever_its_size() -> None:
    for size in (1e-6, 1.0, 1e6):
        skeleton = Skeleton(standing(chain("a", "b", "c"), (size, 0.0, size)))
        for stick in skeleton.sticks():
            assert math.dist(ZERO, stick.start) <= RADIUS + 1e-6
            assert math.dist(ZERO, stick.end) <= RADIUS + 1e-6


def test_no_place_no_figure() -> None:
    assert figure(chain("a", "b"), {}, name="f") is None
    here = standing(chain("a", "b"), ZERO)
    assert figure(here, {}, name="f") is None
    far = standing(chain("a", "b", "c"), (1e308, 1e308, 1e308))
    assert figure(far, {}, name="f") is None


def test_joints_without_a_place_are_told_in_the_caption() -> None:
    first, second = ARM.joints
    made = figure(replace(ARM, joints=(first, replace(second, placed=False))), {}, name="f")
    assert made is not None
    assert "1 of 2 joints have no stated place" in made.caption
    assert "All joints at zero." in made.caption


def test_an_open_loop_is_bridged() -> None:
    first, second = ARM.joints
    opened = replace(second, end=(1.0, 1.0, 1.0), closes=True)
    assert "gap" in classes(drawn(replace(ARM, joints=(first, opened))))


def test_trees_stand_beside_each_other() -> None:
    links = chain("a", "b", "c").links
    joints = (Joint("urn:j", "j", "fixed", "urn:l0", "urn:l1", point=(1.0, 0.0, 0.0), placed=True),)
    robot = Structure(
        "urn:arm",
        "arm",
        tuple(replace(each, point=ZERO) for each in links),
        joints,
        roots=("urn:l0", "urn:l2"),
    )
    (alone,) = (each for each in Skeleton(robot).sticks() if each.link.name == "c")
    (base,) = (each for each in Skeleton(robot).sticks() if each.link.name == "a")
    assert abs(alone.start[1] - base.start[1]) > 10.0


def test_tags_lead_to_findings_and_say_what_they_are_about() -> None:
    svg = drawn(ARM, about("urn:l1"), about("urn:j0", Severity.WARNING))
    links = list(parsed(svg).iter(f"{SVG}a"))
    assert [each.get("aria-label") for each in links] == [
        "error UNI002 of upper",
        "warning UNI002 of j base",
    ]
    assert "✖ upper" in "".join(parsed(svg).itertext())


def test_infos_are_not_marked() -> None:
    assert "<a " not in drawn(ARM, about("urn:l1", Severity.INFO))


def test_findings_know_their_tag() -> None:
    finding = about("urn:l1")
    made = figure(ARM, marks(ARM, [finding]), name="f", href=lambda _: "#f-1")
    assert made is not None
    assert f'id="{made.anchors[id(finding)]}"' in made.svg


def boxes(svg: str) -> Sequence[tuple[float, ...]]:
    found = []
    for flag in parsed(svg).iter(f"{SVG}g"):
        kinds = flag.get("class", "").split()
        if "flag" not in kinds or "crowded" in kinds:
            continue
        pill = flag.find(f"{SVG}g")
        assert pill is not None
        x, y = map(float, re.findall(r"-?[\d.]+", pill.get("transform", "")))
        wide = float(flag.get("data-w", "0"))
        found.append((x - wide / 2, y - HEIGHT / 2, x + wide / 2, y + HEIGHT / 2))
    return found


@pytest.mark.parametrize("count", [3, 9, 20])
def test_no_tag_is_over_another_or_outside(count: int) -> None:
    robot = standing(chain(*(f"link_{n}" for n in range(count))), (0.02, 0.01, 0.1))
    svg = drawn(robot, *(about(f"urn:l{n}") for n in range(count)))
    x, y, wide, high = map(float, parsed(svg).get("viewBox", "").split())
    assert (wide, high) == (WIDTH, TALL)
    found = boxes(svg)
    assert len(found) >= count
    for index, box in enumerate(found):
        assert not any(overlaps(box, other) for other in found[:index])
        assert x <= box[0]
        assert y <= box[1]
        assert box[2] <= x + wide
        assert box[3] <= y + high


def test_hundreds_of_marks_are_dots_on_their_parts() -> None:
    robot = standing(chain(*map(str, range(200))))
    svg = drawn(robot, *(about(f"urn:l{n}") for n in range(200)))
    assert len(list(parsed(svg).iter(f"{SVG}a"))) == 200
    assert 'data-w="0"' in svg
    assert len(svg) < 600_000


def test_names_are_never_markup() -> None:
    for name in HOSTILE:
        robot = standing(chain("first", name, "last"))
        svg = drawn(robot, about("urn:l1", message=name), about("urn:j1", message=name))
        svg.encode()
        assert not re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\u2028\u202e]", svg)
        tags = {each.tag.removeprefix(SVG) for each in parsed(svg).iter()}
        assert tags <= {"svg", "g", "path", "circle", "rect", "text", "title", "a"}


def test_what_is_near_is_low_and_what_is_high_is_up() -> None:
    assert project((0.0, 0.0, 10.0))[1] < 0.0
    assert project((10.0, 0.0, 0.0))[0] > 0.0
    assert project((10.0, 0.0, 0.0))[1] > 0.0
