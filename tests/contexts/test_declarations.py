"""What the contexts define is declared, term by term, for rules to ask."""

from __future__ import annotations

import csv
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from data import locate_data
from rdflib import RDFS, Graph, Literal, Namespace, URIRef

from kinlint.contexts.declarations import PATH, declarations
from kinlint.resources import data
from kinlint.vocabulary import KIN, METAMODELS

KINEMATICS = Namespace(KIN)


@pytest.fixture(scope="module")
def graph() -> Graph:
    return Graph().parse(data("shapes") / PATH, format="turtle")


def rows() -> Iterator[dict[str, str]]:
    """The terms of the published contexts, as a table made from them by other means."""
    table = locate_data("comp-rob2b").parent.parent / "reference" / "vocabulary.tsv"
    if not table.exists():
        pytest.skip("there is no table of the vocabulary")
    with table.open(encoding="utf-8", newline="") as stream:
        yield from csv.DictReader(stream, dialect="excel-tab")


def test_fresh() -> None:
    """The file is what the contexts declare today."""
    assert (data("shapes") / PATH).read_text(encoding="utf-8") == declarations()


def test_command(tmp_path: Path) -> None:
    """The command writes the file that it is given."""
    file = tmp_path / "declarations.ttl"

    subprocess.run([sys.executable, "-m", "kinlint.contexts.declarations", file], check=True)

    assert file.read_text(encoding="utf-8") == declarations()


def test_every_published_term(graph: Graph) -> None:
    """Each published class, property and enumeration value is declared, with its document."""
    published = [row for row in rows() if row["kind"] in {"class", "property", "enum-value"}]

    assert len(published) > 400
    for row in published:
        document = URIRef(METAMODELS + row["context"])
        assert (URIRef(row["iri"]), RDFS.isDefinedBy, document) in graph, row
        assert (URIRef(row["iri"]), KINEMATICS.inRelease, Literal("ba7e601")) in graph, row


def test_every_published_property(graph: Graph) -> None:
    """A property has the values and the container of the published coercion, a class has none."""
    coercions = {"@id": KINEMATICS.Reference, "@vocab": KINEMATICS.Term}
    for row in rows():
        term = URIRef(row["iri"])
        values = set(graph.objects(term, KINEMATICS.values))
        lists = (term, KINEMATICS.container, KINEMATICS.List) in graph
        if row["kind"] == "property":
            assert values == {coercions.get(row["coercion"], KINEMATICS.Number)}, row
            assert lists == (row["container"] == "@list"), row
        elif row["kind"] == "class":
            assert not values, row


def test_older_terms(graph: Graph) -> None:
    """A term that only an older release knows is declared for that release alone."""
    row = URIRef(f"{METAMODELS}geometry/coordinates#RotationRowXYZ")

    assert set(graph.objects(row, KINEMATICS.inRelease)) == {Literal("59e0b06")}


def test_own_terms(graph: Graph) -> None:
    """kinlint's own terms are declared likewise; text is told from numbers."""
    values = KINEMATICS["values"]

    assert (KINEMATICS["axes-sequence"], values, KINEMATICS.Text) in graph
    assert (KINEMATICS["handedness"], values, KINEMATICS.Term) in graph
    assert (KINEMATICS["of-joint"], values, KINEMATICS.Reference) in graph
    assert (KINEMATICS["scale"], KINEMATICS.container, KINEMATICS.List) in graph
    assert (KINEMATICS["LeftHanded"], RDFS.isDefinedBy, None) in graph
    assert (KINEMATICS["LeftHanded"], KINEMATICS.inRelease, None) not in graph
