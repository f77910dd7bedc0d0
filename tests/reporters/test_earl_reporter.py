"""EARL, as parsers of RDF read it."""

from __future__ import annotations

import pyoxigraph as ox
import pytest
from hypothesis import given
from reported import BOTH, INERTIA, UNIT, report, reports

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters.earl import PREFIXES, render
from kinlint.reporters.terminal_style import Style

HEAD = "".join(f"PREFIX {prefix}: <{iri}>\n" for prefix, iri in PREFIXES.items())
ASSERTIONS = """
    SELECT ?test ?outcome ?line ?column WHERE {
        ?assertion a earl:Assertion ; earl:mode earl:automatic ; earl:subject ?subject ;
            earl:assertedBy/doap:name "kinlint" ; earl:test ?test ; earl:result ?result .
        ?result a earl:TestResult ; earl:outcome ?outcome .
        OPTIONAL { ?result earl:pointer ?pointer .
            ?pointer ptr:reference ?subject ; ptr:lineNumber ?line ; ptr:charNumber ?column }
    }
"""


def assertions(made: Report, style: Style | None = None) -> list[tuple[str, ...]]:
    """Test, outcome, line and column of each assertion, sorted."""
    store = ox.Store()
    store.load("".join(render(made, style or Style())).encode(), ox.RdfFormat.TURTLE)
    rows = store.query(HEAD + ASSERTIONS)
    assert isinstance(rows, ox.QuerySolutions)
    found = (tuple("" if cell is None else cell.value for cell in row) for row in rows)
    return sorted((test, outcome.rpartition("#")[2], *place) for test, outcome, *place in found)


def test_findings_failed_and_rules_without_findings_passed() -> None:
    first, second = assertions(BOTH)
    assert first == (INERTIA.iri, "failed", "7", "21")
    assert second == (UNIT.iri, "failed", "8", "15")
    clean = assertions(report(files=("a.urdf",)))
    assert clean == [(INERTIA.iri, "passed", "", ""), (UNIT.iri, "passed", "", "")]


def test_of_a_file_that_cannot_be_read_nothing_can_be_told() -> None:
    made = report(errors=(SourceError("bad b.jsonld", "no JSON", 3, 4),))
    ((test, *rest),) = assertions(made)
    assert test.endswith("readable")
    assert rest == ["cantTell", "3", "4"]


@pytest.mark.slow
@given(reports())
def test_any_report_is_turtle(made: Report) -> None:
    for style in (Style(), Style(unicode=False)):
        assert [row[1] for row in assertions(made, style)].count("failed") == len(made.findings)
