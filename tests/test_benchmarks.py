from __future__ import annotations

import shutil
import sys
from collections import Counter

import pytest
from benchmarks import fleet, robot
from benchmarks.checking import Subject, compared, deeply
from benchmarks.defects import DEFECTS, STEP, expected
from benchmarks.editing import Editor
from benchmarks.fleet import Fleet
from benchmarks.processes import Workplace
from benchmarks.table import Row, markdown
from rdflib import Graph
from support.linting import lint

from kinlint.catalogue.rulebook import Rulebook, load
from kinlint.engine.reference import recording
from kinlint.report import Report

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def catalogue() -> Rulebook:
    return load()


def linted(text: str, catalogue: Rulebook) -> Report:
    return lint(text, "chain.jsonld", rules=catalogue)


@pytest.mark.parametrize("joints", [1, 7, 70])
def test_a_clean_chain_has_no_findings(joints, catalogue):
    """What the benchmark spoils was right before."""
    report = linted(robot.chain(joints), catalogue)

    assert report.findings == ()
    assert report.errors == ()


@pytest.mark.parametrize("joints", [1, 7, 70])
def test_a_spoiled_chain_has_the_findings_that_were_put_in(joints, catalogue):
    """Each injected defect is found once, and nothing else is."""
    report = linted(robot.chain(joints, spoiled=True), catalogue)

    found = Counter(each.rule.code for each in report.findings)

    assert found == expected(joints)


def test_seventy_joints_have_every_kind_of_defect():
    """The longest chain that tests and a default run check leaves no kind out."""
    assert {code for code, _ in DEFECTS} <= set(expected(70))
    assert len(DEFECTS) == len(range(0, 70, STEP))


def test_both_engines_find_the_same_in_a_spoiled_chain(catalogue, monkeypatch):
    """The benchmark compares like with like. Here pySHACL may keep the queries that it parsed."""
    monkeypatch.setattr(*recording.QUERIES, recording._query)
    assert all(seconds > 0 for seconds in compared(1, catalogue, runs=1))


def test_engines_that_disagree_are_no_comparison(catalogue, monkeypatch):
    """A peer that finds nothing may be as slow as it likes."""
    monkeypatch.setattr(Subject, "theirs", lambda _: Graph())

    with pytest.raises(AssertionError, match=r"only ours: .*missing-unit"):
        compared(1, catalogue, runs=1)


def test_recursion_may_go_deep_where_rdflib_needs_it():
    """A path over ten thousand joints ends, and the limit is as before."""
    limit = sys.getrecursionlimit()
    reached = []

    def dive(depth: int) -> int:
        return 1 + dive(depth - 1) if depth else 0

    deeply(lambda: reached.append(dive(10_000)))

    assert reached == [10_000]
    assert sys.getrecursionlimit() == limit


def test_an_error_in_the_deep_comes_up():
    """A failed measurement is no measurement."""
    with pytest.raises(ZeroDivisionError):
        deeply(lambda: 1 // 0)


def test_a_process_that_fails_is_not_timed(tmp_path):
    """Exit codes 0 and 1 are a lint; any other, or a word on standard error, is not."""
    place = Workplace(tmp_path)
    place.run([sys.executable, "-c", "raise SystemExit(1)"])

    with pytest.raises(RuntimeError):
        place.run([sys.executable, "-c", "raise SystemExit(2)"])
    with pytest.raises(RuntimeError, match="alas"):
        place.run([sys.executable, "-c", "import sys; sys.stderr.write('alas')"])


LEG = '<robot name="leg"><link name="thigh"/></robot>'


def test_a_fleet_is_linted_at_once_and_loaded_one_by_one(tmp_path, rules_cache, monkeypatch):
    """The files below a directory, whoever is there to be compared with."""
    for name in ("left", "right"):
        (tmp_path / f"{name}.urdf").write_text(LEG, "utf-8")
    monkeypatch.setattr(fleet, "EACH", "import sys; assert sys.argv[1:]")
    monkeypatch.setattr(fleet, "find_spec", lambda _: True)
    monkeypatch.setattr(fleet, "CHECK_URDF", tmp_path / "absent" / "check_urdf")

    monkeypatch.setattr(fleet, "SMALL", 8)

    each, together, *shared, files, small = Fleet(tmp_path).rows(1)

    assert each.ours == together.ours == "`kinlint`, 2 URDF files in one run"
    assert all(seconds > 0 for row in (each, together) for seconds in row.seconds)
    assert (each.target, together.target) == (20, None)
    assert {row.ours for row in shared} <= {f"{each.ours}, two processors"}
    assert [row.unit for row in (files, small)] == ["B", "B"]
    assert small.ours == "`kinlint`, 8 small files, URDF and JSON-LD, memory"
    assert 0 < small.seconds[1] < small.seconds[0]


def test_memory_is_told_in_megabytes():
    row = Row("many files, memory", "few files, memory", (3e8, 1e8), target=1.3, unit="B")

    assert [*markdown([row])][-1].endswith(
        "| 300 MB | 100 MB | 3.00 times as much | ≤ 1.3 **missed** |"
    )


@pytest.mark.skipif(not fleet.CHECK_URDF.exists(), reason="check_urdf is not installed")
def test_check_urdf_is_timed_only_if_it_finds_its_libraries(tmp_path):
    """A peer that does not start would be fast."""
    (tmp_path / "leg.urdf").write_text(LEG, "utf-8")
    Fleet(tmp_path).run([str(fleet.CHECK_URDF), str(tmp_path / "leg.urdf")])

    with pytest.raises(RuntimeError):
        Fleet(tmp_path).run([sys.executable, "-c", "raise SystemExit(127)"])


@pytest.mark.parametrize(
    ("row", "met", "line"),
    [
        (
            Row("ours", "theirs", (0.5, 600.0), "faster", 1000),
            True,
            "| ours | theirs | 500 ms | 600 s | 1,200 times faster | ≥ 1,000 |",
        ),
        (
            Row("ours", "theirs", (0.5, 60.0), "faster", 1000),
            False,
            "| ours | theirs | 500 ms | 60 s | 120 times faster | ≥ 1,000 **missed** |",
        ),
        (
            Row("ours", "theirs", (0.03, 0.01), "ratio", 3.5),
            True,
            "| ours | theirs | 30 ms | 10 ms | 3.00 times as long | ≤ 3.5 |",
        ),
        (
            Row("ours", "theirs", (0.03, 0.01)),
            True,
            "| ours | theirs | 30 ms | 10 ms | 3.00 times as long |  |",
        ),
    ],
)
def test_a_row_says_its_ratio_and_whether_the_target_is_met(row, met, line):
    """What the README quotes is what was measured."""
    assert row.met is met
    assert [*markdown([row])][-1] == line


def test_a_keystroke_in_an_editor_is_answered(tmp_path, rules_cache):
    """By the server, for the version that it made, and by a process for the same text."""
    shutil.copytree(rules_cache, tmp_path / "cache")
    place = Workplace(tmp_path)

    with Editor(place, "leg.urdf", LEG, LEG.index("thigh") + len("thigh")) as editor:
        editor.press()
        assert editor.text == LEG.replace("thigh", "thigh1")
        editor.lint()
        assert (tmp_path / "leg.urdf").read_text("utf-8") == editor.text
        editor.press()
        assert editor.text == LEG
