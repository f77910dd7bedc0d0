"""What is mended in real robots stays what it was to those who read it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping

import pytest
from consumers import Motion, check_urdf, reading
from fix_trials import TOGETHER, Outcome, faults, shares, spliced, tried
from real_fixes import page

from kinlint.edits import Edit, applied
from kinlint.files.packages import Packages
from kinlint.formats.decoding import decode, encode
from kinlint.resources import data
from kinlint.text import SourceText, Span

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("fixes for public robots")]

SAMPLE = {"jsonld": 1, "urdf": 2, "xacro": 1, "srdf": 1, "sdf": 2}
"""How many shares of each format are tried here. `python tests/real_fixes.py` tries them all."""


@pytest.fixture(scope="module")
def sample() -> Mapping[str, Outcome]:
    """What becomes of the fixes for some files of each format."""
    pytest.importorskip("pinocchio", reason="urdfdom and Pinocchio come with PyPI's pin")
    if check_urdf() is None:
        pytest.skip("this build of Pinocchio comes without check_urdf")
    found = {form: Outcome(form) for form in SAMPLE}
    for form, count in SAMPLE.items():
        for share in shares(form)[:count]:
            found[form].add(tried(share))
    return found


def test_fixes_are_offered_for_real_robots(sample: Mapping[str, Outcome]) -> None:
    """So that what follows is about something."""
    levels = Counter(
        each.level
        for outcome in sample.values()
        for each in outcome.trials
        if each.code != TOGETHER
    )

    assert levels["safe"] >= 5
    assert levels["unsafe"] >= 5
    assert any(each.code == TOGETHER for each in sample["urdf"].trials)


def test_no_fix_does_harm(sample: Mapping[str, Outcome]) -> None:
    """Bytes outside of edits stay, nobody refuses what was read, and safe fixes move nothing."""
    assert faults(sample.values()) == []


def test_the_page_tells_at_least_of_these(sample: Mapping[str, Outcome]) -> None:
    """If not: `python tests/real_fixes.py > rules/real-fixes.md`, and look at what changed."""
    kept = _table((data("rules") / "real-fixes.md").read_text("utf-8").splitlines())
    here = _table(list(page(sample)))

    assert {row for row in here if row not in kept} == set()
    assert [row for row, numbers in here.items() if not _within(numbers, kept[row])] == []
    assert here["xacro"] == kept["xacro"]
    assert here["srdf"] == kept["srdf"]


def _table(lines: list[str]) -> Mapping[str, list[int]]:
    """The numbers in the cells of a page's rows, by what their first cells say."""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines if line[:1] == "|"]
    cells = {
        row[0]: [int(cell or 0) for cell in row[1:] if re.fullmatch(r"\d*", cell)] for row in rows
    }
    return {name: numbers for name, numbers in cells.items() if any(numbers)}


def _within(less: list[int], more: list[int]) -> bool:
    return all(one <= other for one, other in zip(less, more, strict=False))


@pytest.mark.parametrize("name", ["a.urdf", "b.urdf"])
def test_bytes_are_exchanged_where_edits_are(name: str) -> None:
    """Whatever the encoding: the mark at the start is no part of the text."""
    encoding = {"a.urdf": "utf-16", "b.urdf": "utf-8-sig"}[name]
    declared = "utf-16" if encoding == "utf-16" else "utf-8"
    text = f'<?xml version="1.0" encoding="{declared}"?>\r\n<robot name="Käfer 𝄞"/>\r\n'
    stored = text.encode(encoding)
    source = decode(name, stored)
    at = source.text.index("𝄞")
    edits = [Edit(Span(at, at + 1), "é"), Edit(Span(at + 3, at + 3), " ")]
    mended = SourceText(name, applied(source.text, edits), source.bom, encoding=source.encoding)

    assert spliced(stored, source, edits) == encode(mended)


@pytest.mark.parametrize("form", ["urdf", "xacro"])
def test_consumers_tell_robots_from_others(form: str, tmp_path) -> None:
    """They read a robot, see that it moves, and refuse one without its link."""
    pytest.importorskip("pinocchio", reason="urdfdom and Pinocchio come with PyPI's pin")
    packages = Packages(environment={})
    arm = """<robot name="arm"><link name="a"/><link name="b"/><joint name="j" type="continuous">
        <origin xyz="1 0 0"/><parent link="a"/><child link="b"/></joint></robot>"""
    path = tmp_path / f"arm.{form}"
    readings = []
    for text in (arm, arm.replace("1 0", "1 2"), arm.replace('<link name="b"/>', "")):
        path.write_text(text, "utf-8")
        readings.append(reading(form, path, packages))
    whole, moved, broken = (each["Pinocchio"] for each in readings)

    assert isinstance(whole, Motion)
    assert isinstance(moved, Motion)
    assert whole.apart(whole) == 0
    assert whole.apart(moved) == pytest.approx(2)
    assert broken is False
    assert readings[0]["urdfdom"] is True
    assert readings[2]["urdfdom"] is False
