"""Where the authors' shapes and contexts disagree, linting the shapes says so, and nothing else."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from data import locate_data
from support.linting import findings

from kinlint.finding import Finding

COORDINATES = "geometry/coordinates.ttl"
OPERATORS = "geometry/spatial-operators.ttl"
HANDLER = "task/constraint-handler.ttl"
SOLVER = "task/solver-specification.ttl"

ERRORS = {
    "S1": {(COORDINATES, line, "LD024") for line in (189, 195, 201)},
    "S2": {(COORDINATES, line, "LD024") for line in (270, 290, 310, 330)},
    "S5": {(OPERATORS, 130, "LD005")},
    "S9": {(HANDLER, 47, "LD005")},
    "S10": {(HANDLER, 212, "LD005")},
    "S12": {(SOLVER, line, "LD005") for line in (103, 124, 127, 133, 200, 205, 212, 217)},
}


@cache
def found() -> tuple[tuple[str, Finding], ...]:
    """The findings in all published shape files, each with the path of its file."""
    root = locate_data("comp-rob2b", "metamodels", "ba7e601")
    files = sorted(root.rglob("*.ttl"))
    assert len(files) == 9
    every = findings({str(file): file.read_bytes() for file in files})
    return tuple(
        (Path(finding.location.source.name).relative_to(root).as_posix(), finding)
        for finding in every
    )


def speaks_of(finding: Finding, line: int) -> bool:
    """Whether *line* is where *finding* is; a query is a literal of several lines."""
    return finding.location.start.line <= line <= finding.location.end.line


@pytest.mark.parametrize("error", ERRORS)
def test_error(error: str) -> None:
    """The error is found at its lines, by the rule that names it."""
    for file, line, code in ERRORS[error]:
        assert [
            finding
            for place, finding in found()
            if (place, finding.rule.code) == (file, code) and speaks_of(finding, line)
        ], (file, line)


def test_no_other_finding() -> None:
    """Whatever else the shapes say is right, as far as one can tell from them alone."""
    expected = [each for error in ERRORS.values() for each in error]
    others = [
        (file, finding.location.start.line, finding.rule.code, finding.message)
        for file, finding in found()
        if not any(
            (file, finding.rule.code) == (place, code) and speaks_of(finding, line)
            for place, line, code in expected
        )
    ]

    assert others == []
