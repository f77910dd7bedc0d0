from __future__ import annotations

import io
import json
import subprocess
import sys
from dataclasses import replace

import pytest
from reported import BOTH, INERTIA_FINDING, SAFE, UNSAFE, here, report, unit_finding

from kinlint.errors import UsageError
from kinlint.report import Report
from kinlint.reporters import reporter_registry
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity


def written(made: Report, name: str, *, summarise: bool = True) -> str:
    out = io.StringIO()
    reporter_registry.write(made, name, out, summarise=summarise)
    return out.getvalue()


@pytest.mark.parametrize("name", reporter_registry.FORMATS)
def test_only_formats_for_people_end_in_a_summary(name: str) -> None:
    text = written(BOTH, name)
    machine = reporter_registry.FORMATS[name].machine
    itself = name in {"markdown", "html"}  # documents that say it anyway
    assert ("Found 2 findings" in text) is (itself or not machine)
    assert ("Found 2 findings" in written(BOTH, name, summarise=False)) is itself
    assert machine is (name not in {"full", "concise", "grouped"})


def test_an_unknown_format_is_a_usage_error() -> None:
    with pytest.raises(UsageError, match="unknown output format 'xml'"):
        reporter_registry.reporter("xml")


@pytest.mark.parametrize("name", reporter_registry.FORMATS)
@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_every_stream_takes_every_text(name: str, encoding: str) -> None:
    location = here('"é漢😀"', 0, 5, name="é\udc80.jsonld")
    finding = unit_finding(location, "漢", message="lone \ud800 漢", template="")
    raw = io.BytesIO()
    out = io.TextIOWrapper(raw, encoding=encoding)
    reporter_registry.write(report(finding), name, out)
    out.flush()
    text = raw.getvalue().decode(encoding)
    assert text
    if name in {"json", "sarif"}:
        assert "\ufffd" in str(json.loads(text))


def test_the_summary_can_stand_alone() -> None:
    out = io.StringIO()
    reporter_registry.write_summary(replace(BOTH, seconds=None), out)
    assert out.getvalue() == ("Found 2 findings (1 error, 1 warning) in 1 file.\n")


def test_statistics_count_by_rule() -> None:
    findings = [*BOTH.findings, unit_finding(here("x", 0, 1))]
    out = io.StringIO()
    reporter_registry.write_statistics(report(*findings), out)
    assert out.getvalue() == (
        "2  UNI002  warning  AP5,AP6  unit-quantity-mismatch\n"
        "1  INE007  error    AP3      inertia-seen-by-foreign-frame\n"
    )
    reporter_registry.write_statistics(Report(), out := io.StringIO())
    assert out.getvalue() == ""


def test_statistics_have_the_severities_of_the_findings() -> None:
    """Not that of the rule: targets, formats and the configuration may have set another."""
    usual = unit_finding(here("x", 0, 1))
    mild = replace(usual, severity=Severity.INFO)

    assert "  warning,info  " in written_statistics(report(mild, usual))[0]
    assert "  info  " in written_statistics(report(mild))[0]


def test_statistics_say_what_can_be_fixed_if_anything_can() -> None:
    """All of a rule's findings, all with care, some, or none."""
    other = replace(SAFE, edits=())
    findings = [
        replace(INERTIA_FINDING, fixes=(UNSAFE,)),
        unit_finding(here("x", 0, 1), fixes=(other,)),
        unit_finding(here("y", 0, 1)),
    ]
    table = written_statistics(report(*findings))
    assert table == [
        "2  UNI002  [-]   warning  AP5,AP6  unit-quantity-mismatch",
        "1  INE007  [*!]  error    AP3      inertia-seen-by-foreign-frame",
    ]
    assert "  [*]  error" in written_statistics(report(findings[0], unsafe=True))[0]
    assert "  -    error" in written_statistics(report(INERTIA_FINDING, findings[1]))[0]


def written_statistics(made: Report) -> list[str]:
    reporter_registry.write_statistics(made, out := io.StringIO())
    return out.getvalue().splitlines()


def test_only_formats_that_tell_of_fixes_need_them() -> None:
    """Working fixes out takes time; where there is a line for a finding, there is no place."""
    told = [name for name, one in reporter_registry.FORMATS.items() if not one.fixes]
    servers = ["github", "gitlab", "azure", "junit", "checkstyle"]
    assert told == ["concise", "grouped", *servers, "earl", "markdown", "sqlite"]


@pytest.mark.parametrize("style", [Style(color=True), Style(color=True, links=True, unicode=False)])
def test_statistics_are_drawn_as_a_table_in_colour(style: Style) -> None:
    out = io.StringIO()
    reporter_registry.write_statistics(report(replace(INERTIA_FINDING, fixes=(SAFE,))), out, style)
    assert "[*]" in out.getvalue()
    assert "Anti-patterns" in out.getvalue()
    assert "\x1b[" in out.getvalue()
    assert ("\x1b]8;" in out.getvalue()) is style.links


@pytest.mark.parametrize("name", reporter_registry.FORMATS)
def test_no_format_needs_a_slow_library(name: str) -> None:
    code = (
        "import io, sys\n"
        "from kinlint.reporters import reporter_registry\n"
        "from kinlint.report import Report\n"
        f"reporter_registry.write(Report(), {name!r}, io.StringIO())\n"
        "slow = {'rich', 'rdflib', 'pyshacl', 'owlrl', 'pyld', 'pyoxigraph', 'asyncio'}\n"
        "sys.exit(repr(slow & set(sys.modules)) if slow & set(sys.modules) else 0)\n"
    )
    path = ":".join(sys.path)
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        env={"PYTHONPATH": path},
        check=False,
    )
    assert done.returncode == 0, done.stderr
