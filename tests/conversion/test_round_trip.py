"""What was converted says what was lifted, and says it the same way each time."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest
from data import locate_data

from kinlint.conversion.composition import Composition, compose
from kinlint.conversion.output import WRITERS
from kinlint.conversion.rdf_triples import Triples
from kinlint.errors import KinlintError
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import (
    RDF,
    Term,
    Triple,
    iri,
    is_blank,
    is_literal,
    literal_datatype,
    literal_value,
)
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

SAMPLES = Path(__file__).resolve().parents[2] / "samples" / "urdf"
SUFFIXES = {"jsonld": "jsonld", "turtle": "ttl", "ntriples": "nt"}
MOST = 20_000
"""The size in bytes of the largest file that is tried."""


@pytest.mark.slow
@pytest.mark.parametrize("form", WRITERS)
@pytest.mark.parametrize("name", ["six-axis", "gripper"])
def test_samples(name, form):
    model = composed(SAMPLES / f"{name}.urdf")
    text = WRITERS[form](model)
    assert said(text, form) == meant(model)
    assert WRITERS[form](composed(SAMPLES / f"{name}.urdf")) == text


@pytest.mark.corpus
@pytest.mark.parametrize(("folder", "pattern"), [("urdf", "*.urdf"), ("sdf", "*.sdf")])
def test_real_robots(folder, pattern):
    tried = 0
    for path in sorted(locate_data("robots", folder).rglob(pattern))[::15]:
        if path.stat().st_size > MOST:
            continue
        try:
            model = composed(path)
        except KinlintError:
            continue
        assert said(WRITERS["jsonld"](model), "jsonld") == meant(model), path
        tried += 1
    assert tried >= 12


def composed(path: Path) -> Composition:
    return compose([read(decode(path.name, path.read_bytes()), ReadOptions())])


def said(text: str, form: str) -> set:
    return plain(read(SourceText(f"robot.{SUFFIXES[form]}", text), ReadOptions()).statements)


def meant(model: Composition) -> set:
    return plain((str(t.subject), str(t.predicate), str(t.object)) for t in Triples(model))


def plain(triples: Iterable[Triple]) -> set:
    """Statements with numbers by value and lists by their items; without the source layer."""
    found = [t for t in triples if not t[1].startswith(f"<{SRC}") and f"<{SRC}" not in t[2]]
    parts = {(s, p): o for s, p, o in found if is_blank(s)}

    def value(term: Term):
        if is_blank(term):
            items = []
            while is_blank(term):
                items.append(value(parts[term, iri(f"{RDF}first")]))
                term = parts[term, iri(f"{RDF}rest")]
            return tuple(items)
        if is_literal(term):
            text, datatype = literal_value(term), literal_datatype(term)
            return float(text) if datatype.endswith(("double", "integer", "decimal")) else text
        return term

    return {(s, p, value(o)) for s, p, o in found if not is_blank(s)}
