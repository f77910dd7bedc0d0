"""Tables that are renewed hold what a scan of the store would read now, in its order."""

from __future__ import annotations

import pyoxigraph as ox
from hypothesis import given
from hypothesis import strategies as st

from kinlint.engine.store import Store
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.incremental.change import TYPE, Changes
from kinlint.incremental.tracked_index import TrackedIndex
from kinlint.terms import RDF_TYPE, XSD

PROPERTIES = ("<p:p>", "<p:q>")
CLASSES = ("<c:a>", "<c:b>")


def quad(subject: int, predicate: int, value: int, graph: int) -> ox.Quad:
    """One of few statements: a number, which has two spellings, or a type."""
    node, place = ox.NamedNode(f"s:{subject}"), ox.NamedNode(f"g:{graph}")
    if predicate == len(PROPERTIES):
        return ox.Quad(node, TYPE, ox.NamedNode(CLASSES[value % 2][1:-1]), place)
    number = ox.Literal(f"{value // 2}.{'0' * (value % 2)}", datatype=ox.NamedNode(f"{XSD}double"))
    return ox.Quad(node, ox.NamedNode(PROPERTIES[predicate][1:-1]), number, place)


QUADS = st.frozensets(
    st.builds(quad, st.integers(0, 5), st.integers(0, 2), st.integers(0, 3), st.integers(0, 1))
)


def read(scan: PredicateIndex) -> list[object]:
    """All that *scan* has, in its order."""
    tables = [scan.table(each) for each in (*PROPERTIES, RDF_TYPE)]
    return [
        *((list(each.one.items()), list(each.several.items())) for each in tables),
        *(list(scan.numbers(each).items()) for each in PROPERTIES),
        *(scan.instances(each) for each in CLASSES),
    ]


@given(QUADS, st.lists(st.tuples(QUADS, QUADS), max_size=4))
def test_it_is_as_if_it_were_read_now(held, turns):
    """Whatever is removed and added, one after the other."""
    store = Store()
    store.oxigraph.extend(held)
    kept = TrackedIndex(store)
    read(kept)
    for removed, added in turns:
        changes = Changes(store)
        changes.apply(removed, added)
        kept.forget(changes)
        assert read(kept) == read(PredicateIndex(store))
