"""A shared lifting query makes of a reading what it would make of the records that this makes."""

from __future__ import annotations

import pyoxigraph as ox
import pytest

from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.engine.lifting_compiler import SHARED
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.engine.unfolding import is_reading, unfolded
from kinlint.errors import RuleInvalid
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.resources import data
from kinlint.sparql.ast import Construct, render
from kinlint.sparql.parser import parse_construct
from kinlint.terms import iri_value
from kinlint.vocabulary import INTERMEDIATE

PREFIXES = {**model_prefixes(), "ir": INTERMEDIATE, "": "urn:x:"}
ASSERTED = ox.NamedNode(iri_value(ASSERTED_GRAPH))
READING = """CONSTRUCT { ?node a ir:Size ; ir:width ?w ; ir:height 2.0 ; ir:depth ?d }
    WHERE { ?node :width ?w OPTIONAL { ?node :depth ?d } }"""


def parsed(text: str) -> Construct:
    return parse_construct(text, PREFIXES)


def queries(directory: str) -> list[Construct]:
    files = sorted((data("shapes") / "lifting" / directory).glob("*.rq"))
    return [parsed(file.read_text("utf-8")) for file in files]


def made(store: ox.Store, query: Construct, graph: ox.NamedNode | None = None) -> set[str]:
    """What *query* makes, less lists, whose cells have no names; a number has one spelling."""
    found = store.query(render(query), default_graph=graph)
    named = ox.Store()
    named.extend(ox.Quad(*each) for each in found if not isinstance(each.subject, ox.BlankNode))
    return {str(quad.triple) for quad in named}


def unlisted(triples: set[str]) -> set[str]:
    return {each for each in triples if "_:" not in each}


@pytest.mark.slow
@pytest.mark.parametrize("form", ["urdf", "sdf"])
def test_records_need_not_be_stored(form):
    """Of every file, each shared query makes the same of records as in their place."""
    readings = [each for each in queries(form) if is_reading(each)]
    compared = 0
    for file in sorted((data("shapes").parent / "samples").glob(f"*/*.{form}"))[::6]:
        store = Store()
        store.load([read(decode(file.name, file.read_bytes()), ReadOptions())])
        for reading in readings:
            records = ox.Store()
            text = render(reading)
            found = store.oxigraph.query(text, default_graph=ASSERTED)
            records.extend(ox.Quad(*triple) for triple in found)
            for shared in queries(SHARED):
                flat = unfolded(shared, reading)
                meant = made(records, shared)
                if flat is None:
                    assert not meant
                else:
                    triples = made(store.oxigraph, flat, ASSERTED)
                    assert unlisted(triples) == unlisted(meant)
                    compared += len(triples)
    assert compared


def test_what_a_record_lacks_is_not_made():
    """Of another kind, or without a property that has to be there."""
    other = "CONSTRUCT { ?r :is ?w } WHERE { ?r a ir:Mass ; ir:width ?w }"
    lacking = "CONSTRUCT { ?r :is ?w } WHERE { ?r a ir:Size ; ir:mass ?w }"
    optional = "CONSTRUCT { ?r :is ?m } WHERE { ?r a ir:Size OPTIONAL { ?r ir:mass ?m } }"
    assert unfolded(parsed(other), parsed(READING)) is None
    assert unfolded(parsed(lacking), parsed(READING)) is None
    flat = unfolded(parsed(optional), parsed(READING))
    assert flat is not None
    assert made(store(), flat) == set()


def store() -> ox.Store:
    found = ox.Store()
    text = "<urn:x:a> <urn:x:width> 1 ; <urn:x:depth> 3 . <urn:x:b> <urn:x:width> 4 ."
    found.load(text.encode(), ox.RdfFormat.TURTLE)
    return found


def test_unbound_values_are_no_values():
    """A record has only the properties that the reading found; constants stand as they are."""
    query = """CONSTRUCT { ?r :is ?d ; :high ?h ; :sum ?w } WHERE {
        ?r a ir:Size ; ir:depth ?d ; ir:height ?h .
        BIND (IF(BOUND(?h), ?d + ?h, 0) AS ?w)
    }"""
    flat = unfolded(parsed(query), parsed(READING))
    assert flat is not None
    subjects = {each.split()[0] for each in made(store(), flat)}
    assert subjects == {"<urn:x:a>"}
    assert len(made(store(), flat)) == len(("is", "high", "sum"))


def test_what_has_to_be_there_is_not_optional():
    """A left join whose group has to match is a join; one that may bind it elsewhere stays."""
    query = parsed("CONSTRUCT { ?r :is ?v } WHERE { ?r a ir:Size ; ir:volume ?v }")
    one = """CONSTRUCT { ?n a ir:Size ; ir:volume ?v } WHERE { ?n :width ?w
        OPTIONAL { ?n :depth ?d FILTER (?d > ?w) } BIND (IF(?d > 2, ?d * ?w, ?none) AS ?v) }"""
    either = """CONSTRUCT { ?n a ir:Size ; ir:volume ?d } WHERE { ?n :width ?w
        OPTIONAL { ?n :depth ?d FILTER (?d > 5) } OPTIONAL { ?n :width ?d } }"""
    lenient = """CONSTRUCT { ?n a ir:Size ; ir:volume ?v } WHERE { ?n :width ?w
        OPTIONAL { ?n :depth ?d } BIND (COALESCE(?d, ?w) AS ?v) }"""
    for reading, left, found in ((one, 0, 1), (either, 2, 2), (lenient, 1, 2)):
        flat = unfolded(query, parsed(reading))
        assert flat is not None
        assert render(flat).count("OPTIONAL") == left
        assert len(made(store(), flat)) == found


@pytest.mark.parametrize(
    "query",
    [
        "CONSTRUCT { ?r :is 1 } WHERE { ?r a ir:Size . { ?r ir:width ?w } UNION { ?r :x ?w } }",
        "CONSTRUCT { ?r :is 1 } WHERE { ?r a ir:Size . MINUS { ?r ir:width 1 } }",
        "CONSTRUCT { ?r :is 1 } WHERE { ?r a ir:Size . FILTER EXISTS { ?r ir:width 1 } }",
    ],
)
def test_other_forms_are_refused(query):
    """A shared query matches a record, and works the rest out."""
    with pytest.raises(RuleInvalid):
        unfolded(parsed(query), parsed(READING))


def test_a_reading_makes_one_record_with_one_value_each():
    """Anything else would not be what the shared queries take it for."""
    query = parsed("CONSTRUCT { ?r :is ?w } WHERE { ?r a ir:Size ; ir:width ?w }")
    for template in (
        "?a a ir:Size ; ir:width ?w . ?b ir:height ?h",
        "?a a ir:Size ; ir:width ?w , ?h",
        "?a a ir:Size ; ir:width ?elsewhere",
    ):
        reading = parsed(f"CONSTRUCT {{ {template} }} WHERE {{ ?a :x ?w . ?b :y ?h }}")
        with pytest.raises(RuleInvalid):
            unfolded(query, reading)
