"""Work that must not grow with the square of the size of a file, counted."""

from __future__ import annotations

from collections import Counter

import pytest
from benchmarks.growth.growing import Growing
from benchmarks.growth.other_inputs import OTHERS
from benchmarks.growth.urdf_inputs import URDF
from support.linting import lint

from kinlint.engine.literal_spelling import Spelling
from kinlint.engine.store import Store
from kinlint.facts import dangling_references
from kinlint.findings import consequences
from kinlint.formats.sdf import name_references
from kinlint.suggestion import LOOKED_UP

INPUTS = {each.title: each for each in (*URDF, *OTHERS)}


@pytest.fixture
def calls(monkeypatch):
    """Count the calls of functions that are replaced by `counted`."""
    found: Counter[str] = Counter()

    def count(owner, name):
        function = getattr(owner, name)

        def counted(*arguments, **options):
            found[name] += 1
            return function(*arguments, **options)

        monkeypatch.setattr(owner, name, counted)

    found.of = count
    return found


def linted(given: Growing, count: int):
    return lint(given.text(count), given.name)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("title", "owner"),
    [
        ("SDF: missing frames", name_references),
        ("URDF: dangling references", dangling_references),
    ],
)
def test_only_the_first_missing_names_are_compared_with_all_others(calls, title, owner):
    """Each comparison takes time linear in the names that there are."""
    calls.of(owner, "nearest")
    report = linted(INPUTS[title], 2 * LOOKED_UP)

    assert report.findings
    assert 0 < calls["nearest"] <= LOOKED_UP


@pytest.mark.parametrize("title", ["URDF: undefined materials", "URDF: malformed comments"])
def test_findings_that_rest_on_what_is_written_need_no_query_each(calls, title):
    """What they rest on is asked for only where something is inferred or computed."""
    calls.of(Store, "rows")
    linted(INPUTS[title], 10)
    few = calls["rows"]
    linted(INPUTS[title], 40)

    assert calls["rows"] - few <= few + 30


def test_suspicions_do_not_grow_with_the_pairs_of_values(monkeypatch):
    """Many values of one property of one node give as many at most, not one for each two."""
    kept = []
    suspects = consequences._suspects

    def counted(*arguments):
        found = suspects(*arguments)
        kept.append(sum(map(len, (*found.terms.values(), *found.namespaces.values()))))
        return found

    monkeypatch.setattr(consequences, "_suspects", counted)
    title = "JSON-LD: values of one functional property"
    for count in (10, 40):
        assert linted(INPUTS[title], count).findings

    few, many = kept
    assert 0 < many <= 4 * few


def test_a_pair_of_links_that_is_disabled_often_is_one_finding():
    """Not one for each two of its entries."""
    report = linted(INPUTS["SRDF: one pair disabled again"], 30)

    assert [each.rule.code for each in report.findings].count("CMP030") == 1


@pytest.mark.slow
@pytest.mark.parametrize("title", INPUTS)
def test_inputs_of_the_benchmark_are_read(title):
    """All but the one whose point is that it cannot be."""
    report = linted(INPUTS[title], 3)

    codes = {each.rule.code for each in report.findings}
    assert ("SRC019" in codes) == (title == "URDF: never ended")
    assert not report.errors


@pytest.mark.slow
def test_what_many_files_say_is_looked_up_where_it_is_said(calls):
    """Not in each of them for each finding."""
    text = """{"@context": ["https://w3id.org/kinlint/composable.json", {"r": "https://x.example/%d#"}],
    "@graph": [{"@id": "r:a", "@type": "Frame", "origin": "r:b"}, {"@id": "r:o", "@type": "Point"}]}
    """
    calls.of(Spelling, "as_written")
    found = []
    for count in (10, 40):
        calls.clear()
        report = lint({f"{each}.jsonld": text % each for each in range(count)})
        assert len(report.findings) == count
        found.append(calls["as_written"])
    assert found[1] <= 4 * found[0]
