"""Reports are written as JSON and read again, the very same."""

from dataclasses import replace

import pytest
from support import linting

from kinlint.cache.serialization import NotSerializable, parse_report, serialize_report
from kinlint.configuration.settings import Settings
from kinlint.parallel.shard import Job, lint_shard
from kinlint.report import Report
from kinlint.text import SourceText, Span

ROBOT = (
    '<robot name="r">\n<link name="base"/><link name="\U0001f916"/>'
    '<joint name="j" type="revolute"><parent link="base"/><child link="\U0001f916"/>'
    '<limit lower="1" upper="-1" effort="1" velocity="1"/><axis xyz="0 0 2"/></joint>'
    "<!-- kinlint: ignore[UNI002] --></robot>"
)


@pytest.fixture(scope="module")
def book():
    return linting.book()


@pytest.mark.parametrize("fixing", [False, True])
@pytest.mark.parametrize("drawn", [False, True])
def test_every_part_of_a_report_comes_back(book, fixing, drawn):
    """Findings with all that belongs to them, fixes, refusals, robots."""
    source = SourceText("a robot.urdf", ROBOT)
    report = lint_shard([[source]], (), Job(Settings(drawn=drawn), book, fixing))[0].report
    assert report.findings
    assert any(one.fixes for one in report.findings) == fixing
    assert bool(report.structures) == drawn
    again = parse_report(serialize_report(report, [source]), [source], book)
    assert replace(again, seconds=report.seconds) == report
    assert again.findings[0].location.source is source


def test_texts_that_were_not_given_come_along(book):
    """With all that is known of their bytes."""
    other = replace(
        SourceText("b.xacro", "x\udc80", misread=((Span(1, 2), "what"),), encoding=""),
        bom=True,
        original=b"x\x80",
    )
    given = SourceText("a.urdf", ROBOT)
    report = lint_shard([[given]], (), Job(Settings(), book))[0].report
    moved = [replace(one, location=replace(one.location, source=other)) for one in report.findings]
    report = replace(report, findings=tuple(moved))
    again = parse_report(serialize_report(report, [given]), [given], book)
    assert again.findings == report.findings
    assert len({id(one.location.source) for one in again.findings}) == 1


def test_what_has_no_notation_is_not_kept():
    """Rather than kept in a way that cannot be read."""
    with pytest.raises(NotSerializable):
        serialize_report(Report(files=(object(),)), [])


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"texts": [7], "report": {}}', '{"texts": [], "report": {"x": 1}}']
)
def test_what_is_no_report_is_refused(book, text):
    """Somehow: it counts as absent."""
    with pytest.raises((ValueError, TypeError, KeyError, IndexError)):
        parse_report(text, [], book)


def test_nothing_but_data_is_made(book):
    """A notation names its classes; others are not looked up."""
    text = '{"texts": [], "report": {"files": ["object", "Path", "x"]}}'
    with pytest.raises(KeyError):
        parse_report(text, [], book)
