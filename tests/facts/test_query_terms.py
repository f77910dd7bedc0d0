"""Terms in the SPARQL of shapes."""

from __future__ import annotations

import pytest
from support.linting import lint

SHAPE = """
@prefix sh: <http://www.w3.org/ns/shacl#> .
<https://example.org/shapes#Arm> a sh:NodeShape ; sh:sparql [ sh:select \"\"\"%s\"\"\" ] .
"""
PREFIX = "PREFIX c: <https://comp-rob2b.github.io/metamodels/geometry/coordinates#>"


@pytest.mark.parametrize(
    ("query", "undeclared"),
    [
        (f"{PREFIX} SELECT $this WHERE {{ $this c:of-pose ?pose }}", []),
        (
            f"{PREFIX} SELECT $this WHERE {{ $this c:off ?a ; c:offf ?b ; c:of ?c }}",
            ["off", "offf"],
        ),
        (f"{PREFIX} SELECT $this WHERE {{ $this ?path 'c:off' }} # c:off", []),
        (f"{PREFIX} SELECT ~ c:off", []),
        ("SELECT $this WHERE { $this c:off ?a }", []),
    ],
    ids=["declared", "undeclared", "strings and comments", "no SPARQL", "unknown prefix"],
)
def test_terms_that_no_metamodel_declares(query: str, undeclared: list[str]) -> None:
    """Each of them is one finding; strings and comments have none."""
    report = lint(SHAPE % query, "shapes.ttl")
    found = [each.message for each in report.findings if each.rule.code == "LD005"]

    assert len(found) == len(undeclared)
    assert all(any(f"{term}'" in message for message in found) for term in undeclared)
