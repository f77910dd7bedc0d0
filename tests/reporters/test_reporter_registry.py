from __future__ import annotations

import io
import json
import subprocess
import sys
from dataclasses import replace

import pytest
from reported import BOTH, here, report, unit_finding

from kinlint.errors import UsageError
from kinlint.report import Report
from kinlint.reporters import registry
from kinlint.reporters.style import Style


def written(made: Report, name: str, *, summarise: bool = True) -> str:
    out = io.StringIO()
    registry.write(made, name, out, summarise=summarise)
    return out.getvalue()


@pytest.mark.parametrize("name", registry.FORMATS)
def test_only_formats_for_people_end_in_a_summary(name: str) -> None:
    text = written(BOTH, name)
    machine = registry.FORMATS[name].machine
    assert ("Found 1 error" in text) is not machine
    assert "Found 1 error" not in written(BOTH, name, summarise=False)
    assert machine is (name not in {"full", "concise"})


def test_an_unknown_format_is_a_usage_error() -> None:
    with pytest.raises(UsageError, match="unknown output format 'xml'"):
        registry.reporter("xml")


@pytest.mark.parametrize("name", registry.FORMATS)
@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_every_stream_takes_every_text(name: str, encoding: str) -> None:
    location = here('"é漢😀"', 0, 5, name="é\udc80.jsonld")
    finding = unit_finding(location, "漢", message="lone \ud800 漢", template="")
    raw = io.BytesIO()
    out = io.TextIOWrapper(raw, encoding=encoding)
    registry.write(report(finding), name, out)
    out.flush()
    text = raw.getvalue().decode(encoding)
    assert text
    if name in {"json", "sarif"}:
        assert "\ufffd" in str(json.loads(text))


def test_the_summary_can_stand_alone() -> None:
    out = io.StringIO()
    registry.write_summary(replace(BOTH, seconds=None), out)
    assert out.getvalue() == ("Found 1 error and 1 warning in 1 file (1 file, 1,204 triples).\n")


def test_statistics_count_by_rule() -> None:
    findings = [*BOTH.findings, unit_finding(here("x", 0, 1))]
    out = io.StringIO()
    registry.write_statistics(report(*findings), out)
    assert out.getvalue() == (
        "2  UNI002  warning  AP5,AP6  unit-quantity-mismatch\n"
        "1  INE007  error    AP3      inertia-seen-by-foreign-frame\n"
    )
    registry.write_statistics(Report(), out := io.StringIO())
    assert out.getvalue() == ""


@pytest.mark.parametrize("style", [Style(color=True), Style(color=True, links=True, unicode=False)])
def test_statistics_are_drawn_as_a_table_in_colour(style: Style) -> None:
    out = io.StringIO()
    registry.write_statistics(BOTH, out, style)
    assert "Anti-patterns" in out.getvalue()
    assert "\x1b[" in out.getvalue()
    assert ("\x1b]8;" in out.getvalue()) is style.links


@pytest.mark.parametrize("name", registry.FORMATS)
def test_no_format_needs_a_slow_library(name: str) -> None:
    code = (
        "import io, sys\n"
        "from kinlint.reporters import registry\n"
        "from kinlint.report import Report\n"
        f"registry.write(Report(), {name!r}, io.StringIO())\n"
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
