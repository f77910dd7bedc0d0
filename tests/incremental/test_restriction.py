"""A lifting query that is asked for some elements answers what it would of all, about those."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pyoxigraph as ox
import pytest

from kinlint.engine.lifting import queries
from kinlint.engine.store import ASSERTED_GRAPH, Store, token
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.incremental.restriction import GIVEN, find_restriction
from kinlint.incremental.tracked_lifting import Unit
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens
from kinlint.terms import iri_value, is_iri
from kinlint.text import SourceText

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
ASSERTED = ox.NamedNode(iri_value(ASSERTED_GRAPH))


def solutions(store: Store, select: str, names: tuple[str, ...]) -> Counter[tuple[str, ...]]:
    """How often each solution of *select* is there, as the tokens of *names*."""
    found = store.oxigraph.query(select, default_graph=ASSERTED)
    assert isinstance(found, ox.QuerySolutions)
    return Counter(
        tuple("" if row[name] is None else token(row[name]) for name in names) for row in found
    )


@pytest.mark.slow
@pytest.mark.parametrize("form", ["urdf", "sdf"])
def test_nothing_else_is_found(form):
    """For each element that a query is narrowed by, the same solutions, as often."""
    units = [Unit.from_lifting(each, None) for each in queries(form)]
    narrowed = 0
    for file in sorted(SAMPLES.glob(f"*/*.{form}"))[::8]:
        source = SourceText(file.name, file.read_text("utf-8"))
        store = Store()
        store.load([read(source, ReadOptions())])
        for unit in filter(lambda unit: unit.narrow is not None, units):
            meant = solutions(store, unit.select, unit.names)
            roots = sorted({row[-1] for row in meant if is_iri(row[-1])})
            for some in (roots[:1], roots[1:3]):
                select = unit.restricted.replace(GIVEN, " ".join(some))
                found = solutions(store, select, unit.names)
                assert found == {row: n for row, n in meant.items() if row[-1] in some}
                narrowed += bool(some)
    assert narrowed


@pytest.mark.parametrize(
    "select",
    [
        "SELECT * WHERE { OPTIONAL { ?a <p:p> ?b } ?a <p:p> ?c }",
        "SELECT * WHERE { }",
    ],
)
def test_what_cannot_be_narrowed(select):
    """Nothing is known of a variable that no leading pattern binds, or of some solutions."""
    assert find_restriction(parse(tokens(select, {})).group) is None
