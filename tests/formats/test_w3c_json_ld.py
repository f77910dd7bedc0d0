"""The W3C JSON-LD 1.1 suites: what PyLD passes, our reader passes with positions on."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from reading import domain
from test_json_ld_places import canonical
from w3c_json_ld import SuiteContexts, W3CTest, run_ours, run_pyld, w3c_tests

from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions

RECORD = Path(__file__).with_name("w3c_json_ld_expected.json")


@pytest.fixture(scope="module")
def suites() -> list[W3CTest]:
    return list(w3c_tests())


def failures(suites: list[W3CTest], run: object) -> dict[str, str]:
    found = {f"{test.suite}{test.id}": test.judge(run) for test in suites}
    return {name: reason for name, reason in found.items() if reason}


@pytest.mark.slow
def test_the_record_is_exact(suites: list[W3CTest]) -> None:
    """The record holds the number of tests, and each failure with what happens instead."""
    record = json.loads(RECORD.read_text("utf-8"))
    assert record["tests"] == {
        suite: sum(test.suite == suite for test in suites) for suite in ("expand", "toRdf")
    }
    pyld, ours = failures(suites, run_pyld), failures(suites, run_ours)
    assert {name: entry["pyld"] for name, entry in record["failures"].items()} == pyld
    told = {name: entry["ours"] for name, entry in record["failures"].items() if entry["ours"]}
    assert told == ours


def test_what_pyld_passes_we_pass() -> None:
    record = json.loads(RECORD.read_text("utf-8"))
    assert all(entry["pyld"] for entry in record["failures"].values())
    assert all(entry["reason"] for entry in record["failures"].values())


@pytest.mark.slow
def test_reading_for_the_linter_flattens_what_the_suite_expects(suites: list[W3CTest]) -> None:
    """The linter's reader takes graphs apart as they come; the triples are the same."""
    compared = 0
    for test in suites:
        if test.suite == "expand" or "expect" not in test.entry or _is_special(test):
            continue
        options = ReadOptions(contexts=SuiteContexts(), releases=(), base=test.base)
        triples = domain(read(test.source, options))
        ours = "".join(" ".join(triple) + " .\n" for triple in triples)
        theirs = re.sub(r"(?m)^(.*) (?:<[^>]*>|_:\S+) \.$", _unnamed, test.expected())
        assert canonical(ours) == canonical(theirs), test.id
        compared += 1
    assert compared > 250


def _is_special(test: W3CTest) -> bool:
    """Options that the linter does not have, and graphs that only a dataset can keep apart."""
    options = {"rdfDirection", "produceGeneralizedRdf", "expandContext", "processingMode"}
    return bool(options & test.option.keys()) or test.id == "#twf07"


def _unnamed(match: re.Match[str]) -> str:
    """A quad without its graph; a triple as it is."""
    rest = re.sub(r'"(?:[^"\\]|\\.)*"(?:@[\w-]+|\^\^<[^>]*>)?', '""', match[1])
    return f"{match[1]} ." if len(rest.split()) == 3 else match[0]


@pytest.mark.slow
def test_no_test_makes_the_lenient_reader_crash(suites: list[W3CTest]) -> None:
    for test in suites:
        verdict = test.judge(lambda one: run_ours(one, strict=False))
        assert not verdict.startswith("raises") or "Error" not in verdict, (test.id, verdict)
