from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from turtle_document import document, ex

from kinlint.document import Document, SourceMap
from kinlint.engine.store import CHUNK, Store, token
from kinlint.errors import RuleInvalid
from kinlint.terms import XSD, Triple, literal
from kinlint.text import Span

VALUE = ex("value")
ALL = "SELECT ?s ?p ?o WHERE { ?s ?p ?o }"


def spelled(store, subject, predicate, value):
    """Return the triple as spelled by the first document that states it; None if none does."""
    return next((triple for _, triple in store.written(subject, predicate, value)), None)


def loaded(*documents: Document) -> Store:
    store = Store()
    store.load(documents)
    return store


def stated(*triples: Triple) -> Document:
    spans = SourceMap({triple: Span(0, 0) for triple in triples})
    return replace(document(""), statements=triples, map=spans)


def test_blank_nodes_keep_their_labels():
    """A focus node that is blank can be looked up in the document's source map."""
    store = loaded(stated(("_:b7", VALUE, "_:c.1")))

    assert [tuple(row.values()) for row in store.rows(ALL)] == [("_:b7", VALUE, "_:c.1")]


def test_queries_see_all_documents_as_one_graph():
    """Two files may each say half of what a rule asks."""
    store = loaded(document(":a :p :b .", "one"), document(":b :q :c .", "two"))

    assert [
        row["z"] for row in store.rows("SELECT ?z { ?x ?p ?y . ?y <https://example.org/q> ?z }")
    ] == [ex("c")]


def test_a_statement_of_two_documents_is_one_solution():
    """Repetition across files does not multiply findings."""
    store = loaded(document(":a :p :b .", "one"), document(":a :p :b .", "two"))

    assert len(list(store.rows(ALL))) == 1


def test_loading_a_document_again_replaces_it():
    """An editor may load each state of a file."""
    store = loaded(document(":a :p :b ."), document(":a :p :c ."))

    assert [row["o"] for row in store.rows(ALL)] == [ex("c")]


def test_joins_over_repeated_statements_count_once():
    """A count of attachments does not grow with the number of files."""
    store = loaded(document(":a :p :b, :c .", "one"), document(":a :p :b .", "two"))

    (row,) = store.rows("SELECT (COUNT(*) AS ?n) { ?s ?p ?o . ?s ?q ?x }")

    assert row["n"] == literal("4", f"{XSD}integer")


def test_what_two_documents_say_stays_when_one_is_cleared():
    """Each file stands for itself."""
    one, two = document(":a :p :b .", "one"), document(":a :p :b .", "two")
    store = loaded(one, two)

    store.clear(one)

    assert store.holds((ex("a"), ex("p"), ex("b")))


def test_clearing_forgets_one_document_only():
    """Other files of a run stay."""
    one, two = document(":a :p :b .", "one"), document(":a :p :c .", "two")
    store = loaded(one, two)

    store.clear(one)

    assert [row["o"] for row in store.rows(ALL)] == [ex("c")]
    assert spelled(store, ex("a"), ex("p"), ex("b")) is None


def test_more_statements_than_fit_one_batch_are_all_loaded():
    """Batches meet without a gap."""
    many = tuple((ex("a"), VALUE, literal(str(number))) for number in range(CHUNK + 1))

    assert len(loaded(stated(*many)).oxigraph) == CHUNK + 1


@pytest.mark.parametrize(
    "bad",
    [
        (ex("a"), VALUE, '"x"@en_US'),
        (ex("a"), VALUE, '"\ud83d"'),
        (ex("a"), VALUE, "<https://example.org/a>b>"),
    ],
)
def test_what_no_store_accepts_is_returned_and_the_rest_loaded(bad: Triple):
    """One broken statement does not silence the rules about all others."""
    good = tuple((ex("a"), VALUE, literal(str(number))) for number in range(5))
    store = Store()

    refused = store.load([stated(*good[:3], bad, *good[3:])])

    assert refused == (bad,)
    assert len(store.oxigraph) == 5
    assert not store.holds(bad)


def test_odd_iris_are_kept():
    """JSON-LD lets through what is no IRI; rules must be able to say so."""
    odd = (ex("a b"), VALUE, "<3D>")
    store = loaded(stated(odd))

    assert [tuple(row.values()) for row in store.rows(ALL)] == [odd]
    assert [triple for _, triple in store.written(*odd)] == [odd]


@pytest.mark.parametrize(
    ("written", "stored"),
    [
        (literal("1.0E-1", f"{XSD}double"), "0.1"),
        (literal("007", f"{XSD}integer"), "7"),
        (literal("1.50", f"{XSD}decimal"), "1.5"),
        (literal("1", f"{XSD}boolean"), "true"),
        (literal("Elbow", language="EN"), "Elbow"),
    ],
)
@pytest.mark.parametrize("predicate", [VALUE, None])
def test_a_value_leads_back_to_the_spelling_of_the_document(written, stored, predicate):
    """Oxigraph rewrites typed literals; the source map knows them as they were read."""
    store = loaded(
        stated((ex("a"), VALUE, written), (ex("a"), VALUE, literal("9", f"{XSD}double")))
    )
    values = [row["o"] for row in store.rows(ALL)]
    (value,) = [value for value in values if value.startswith(f'"{stored}"')]

    assert value != written
    assert spelled(store, ex("a"), predicate, value) == (ex("a"), VALUE, written)


def test_each_document_is_asked_for_its_own_spelling():
    """Two files that give one number differently each have their own place for it."""
    store = loaded(document(":a :value 1.0e0 .", "one"), document(":a :value 10.0e-1 .", "two"))

    found = {
        each.source.name: triple[2]
        for each, triple in store.written(ex("a"), VALUE, literal("1", f"{XSD}double"))
    }

    assert found == {
        "one": literal("1.0e0", f"{XSD}double"),
        "two": literal("10.0e-1", f"{XSD}double"),
    }


@pytest.mark.parametrize("value", [ex("b"), "_:c", '"text"'])
def test_a_result_without_path_finds_the_triple_of_its_value(value):
    """A rule may name only the focus node and the value."""
    store = loaded(stated((ex("a"), VALUE, value)))

    assert spelled(store, ex("a"), None, value) == (ex("a"), VALUE, value)


def test_what_no_document_says_has_no_spelling():
    """A computed value, a literal focus node and the vocabulary are written nowhere."""
    store = loaded(document(":a :value 1 ."))

    assert spelled(store, ex("a"), VALUE, literal("2", f"{XSD}integer")) is None
    assert spelled(store, '"a"', VALUE, ex("b")) is None


def test_vocabulary_is_visible_but_not_written(tmp_path):
    """Rules may ask for subclasses; nobody is told to edit the ontology."""
    file = tmp_path / "ontology.ttl"
    file.write_text("<https://example.org/a> <https://example.org/p> <https://example.org/b> .")
    store = loaded(document(":a :value 1 ."))

    store.load_vocabulary([file])

    triple = (ex("a"), ex("p"), ex("b"))
    assert store.holds(triple)
    assert not store.is_inferred(triple)
    assert spelled(store, *triple) is None


def test_broken_vocabulary_is_named_with_its_line(tmp_path):
    """Whoever extends the ontology sees where."""
    file = tmp_path / "ontology.ttl"
    file.write_text("<https://example.org/a>\n<https://example.org/p> .")

    with pytest.raises(RuleInvalid, match=r"ontology\.ttl:2: "):
        Store().load_vocabulary([file])


def test_variables_can_be_given_terms_even_blank_ones():
    """No query text can name a blank node."""
    store = loaded(stated(("_:b", VALUE, ex("x")), ("_:c", VALUE, ex("y"))))

    rows = store.rows(f"SELECT * {{ ?s {VALUE} ?o }}", {"s": "_:c"})

    assert [row["o"] for row in rows] == [ex("y")]


def test_unbound_variables_are_left_out_of_rows():
    """None is no token."""
    store = loaded(document(":a :p :b ."))

    assert list(store.rows("SELECT ?s ?x { ?s ?p ?o OPTIONAL { ?o ?p ?x } }")) == [{"s": ex("a")}]


@pytest.mark.slow
@given(st.text(st.characters(codec="utf-8")))
def test_strings_return_as_they_were_stated(text: str):
    """Whatever a string holds, its token finds its span."""
    value = literal(text)
    store = loaded(stated((ex("a"), VALUE, value)))

    (quad,) = store.oxigraph
    assert token(quad.object) == value
    assert token(quad.predicate) == VALUE
