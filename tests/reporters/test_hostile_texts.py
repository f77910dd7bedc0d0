"""No text of a file does anything but stand in a report, whichever format is written."""

from __future__ import annotations

import io
import json
import re
import unicodedata
from dataclasses import replace
from xml.etree import ElementTree as ET

import pyoxigraph as ox
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reported import INERTIA_FINDING, UNSAFE, report

from kinlint.errors import SourceError
from kinlint.finding import Finding, Premise, Related, TextEdit
from kinlint.report import Report
from kinlint.reporters import reporter_registry
from kinlint.reporters.log_commands import UNICODE, without_controls
from kinlint.text import Location, SourceText, Span

COMMANDS = (
    *(
        "::error::x",
        "  ::set-env name=A::b",
        "::add-mask::x",
        "##[group]x",
        "##vso[task.complete]x",
    ),
    *("##teamcity[message text='x']", "\n::warning::x", "\r\n##[error]x"),
)
MARKUP = (
    *("<script>alert(1)</script>", '" onload="x', "]]>", "-->", "&amp;", "<img src=x>"),
    *("`x`", "[a](javascript:x)", "|a|b|", "</code></pre>", "@everyone", "=cmd()", "{{7*7}}", "\\"),
)
CONTROLS = (
    "\x1b[2J",
    "\x1b]0;x\x07",
    "\x9b31m",
    "\x00",
    "\x08",
    "\u202e",
    "\u2066",
    "\u2028",
    "\x85",
)
hostile = st.lists(
    st.sampled_from([*COMMANDS, *MARKUP, *CONTROLS, "joint", " "]), min_size=1, max_size=5
).map("".join)
SILENT = {"Cc"}
"""Categories of characters that drive a terminal; line ends and tabs are harmless."""


@st.composite
def reports(draw: st.DrawFn) -> Report:
    """A report in which every text that comes from a file is hostile."""
    text = draw(hostile) + "\n" + draw(hostile)
    source = SourceText(draw(hostile).replace("\0", ""), text)
    place = Location(source, Span(0, min(3, len(text))))
    fix = replace(UNSAFE, title=draw(hostile), edits=(TextEdit(place, draw(hostile)),))
    finding: Finding = replace(
        INERTIA_FINDING,
        location=place,
        message=draw(hostile),
        arguments=(draw(hostile),),
        related=(Related(place, draw(hostile)),),
        because=(Premise(draw(hostile), place),),
        fixes=(fix,),
    )
    made = report(finding)
    return replace(made, errors=(SourceError(source.name, draw(hostile), 1, 1),))


def written(made: Report, name: str) -> str:
    out = io.StringIO()
    reporter_registry.write(made, name, out)
    return out.getvalue()


@pytest.mark.parametrize("name", reporter_registry.FORMATS)
@settings(max_examples=25)
@given(made=reports())
def test_no_terminal_is_driven(name: str, made: Report) -> None:
    text = written(made, name)
    assert not [c for c in text if unicodedata.category(c) in SILENT and c not in "\n\t"]


@pytest.mark.parametrize("name", sorted({*reporter_registry.FORMATS} - {"github", "azure"}))
@settings(max_examples=25)
@given(made=reports())
def test_no_runner_is_commanded(name: str, made: Report) -> None:
    for line in written(made, name).split("\n"):
        assert not re.match(r"\s*::[^:]", line)
        assert "##[" not in line
        assert "##vso[" not in line
        assert "##teamcity[" not in line


@settings(max_examples=25)
@given(made=reports())
def test_commands_to_github_are_our_own(made: Report) -> None:
    lines = written(made, "github").split("\n")
    known = ("::error ", "::warning ", "::notice ")
    assert all(line.startswith(known) for line in lines if line)


@settings(max_examples=25)
@given(made=reports())
def test_commands_to_azure_are_our_own(made: Report) -> None:
    lines = written(made, "azure").split("\n")
    assert all(line.startswith("##vso[task.logissue ") for line in lines if line)


@pytest.mark.parametrize("name", ["json", "sarif", "gitlab", "rdjson"])
@settings(max_examples=25)
@given(made=reports())
def test_json_stays_json(name: str, made: Report) -> None:
    assert json.loads(written(made, name)) is not None


@pytest.mark.parametrize("name", ["json-lines", "rdjsonl"])
@settings(max_examples=25)
@given(made=reports())
def test_lines_of_json_stay_that(name: str, made: Report) -> None:
    assert all(json.loads(line) for line in written(made, name).split("\n") if line)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["junit", "checkstyle"])
@settings(max_examples=25)
@given(made=reports())
def test_xml_stays_xml(name: str, made: Report) -> None:
    ET.fromstring(written(made, name))  # noqa: S314  written here


@settings(max_examples=25)
@given(made=reports())
def test_turtle_stays_turtle(made: Report) -> None:
    assert list(ox.parse(written(made, "turtle"), ox.RdfFormat.TURTLE))


@settings(max_examples=25)
@given(made=reports())
def test_html_has_no_script_of_a_file(made: Report) -> None:
    text = written(made, "html")
    assert "<script>alert" not in text
    assert "<img src=x" not in text
    assert 'href="javascript:' not in text


@pytest.mark.parametrize("control", ["\u061c", "\u200f", "\u2028", "\u202e", "\u2066"])
def test_a_log_is_read_in_the_order_of_its_text(control: str) -> None:
    """Bidirectional controls and the line separators of Unicode are escaped as others are."""
    assert without_controls(f"a{control}b", UNICODE) == f"a\\u{ord(control):04x}b"
