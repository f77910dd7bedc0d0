"""Values that JSON-LD ignores, and whose node a loss belongs to."""

from __future__ import annotations

import json
from typing import Any

import pytest
from reading import details, document, domain, losses

from kinlint.errors import SourceError
from kinlint.terms import RDF

EX = {"ex": "https://example.org/arm#", "p": "ex:p", "to": {"@id": "ex:to", "@type": "@id"}}
KIND = {"kind": {"@id": "ex:kind", "@type": "@vocab"}, "alias": "@type"}


def model(*nodes: Any, **terms: Any) -> dict[str, Any]:
    return {"@context": {**EX, **terms}, "@graph": list(nodes)}


@pytest.mark.parametrize(
    ("content", "node"),
    [
        (model({"@id": "ex:a", "lost": 1}), "https://example.org/arm#a"),
        ({**model({"@id": "ex:a", "lost": 1}), "@id": "ex:g"}, "https://example.org/arm#a"),
        (model({"@id": "ex:b", "p": [{"@set": [1], "lost": 1}]}), "https://example.org/arm#b"),
        (model({"@id": "ex:b", "p": {"@value": 1, "lost": 1}}), "https://example.org/arm#b"),
        (model({"@id": "ex:b", "p": {"@id": "ex:c", "lost": 1}}), "https://example.org/arm#c"),
    ],
)
def test_a_dropped_key_belongs_to_the_node_it_is_written_on(content: Any, node: str) -> None:
    """Even if nothing is stated about that node, and in whatever graph it stands."""
    assert details(document(content), '"lost"')["node"] == [node]


def test_a_node_without_name_that_loses_all_its_keys_is_a_blank_node() -> None:
    read = document({**model({"lost": 1}, {"lost": 2}), "@id": "ex:g"})
    nodes = details(read, '"lost"')["node"]
    assert len(set(nodes)) == 2
    assert all(node.startswith("_:") for node in nodes)


@pytest.mark.parametrize(
    "node",
    [
        {"@id": "@foo", "p": 1},
        {"@id": "ex:a", "p": {"@id": "@foo", "p": 1}},
        {"@id": "ex:a", "to": "@foo"},
        {"@id": "ex:a", "to": ["ex:b", "@foo"]},
        {"@id": "ex:a", "kind": "@foo"},
    ],
)
def test_an_identifier_like_a_keyword_is_stated(node: Any) -> None:
    assert losses(document(model(node, **KIND))) == [("MalformedIri", '"@foo"')]


@pytest.mark.parametrize(
    ("node", "token"),
    [
        ({"@id": "ex:a", "@type": "@id"}, '"@id"'),
        ({"@id": "ex:a", "to": "@type"}, '"@type"'),
        ({"@id": "ex:a", "kind": "alias"}, '"alias"'),
    ],
)
def test_a_keyword_is_no_identifier(node: Any, token: str) -> None:
    assert losses(document(model(node, **KIND))) == [("MalformedIri", token)]


def test_keywords_where_they_belong_are_no_losses() -> None:
    node = {"@id": "ex:a", "p": {"@value": {"@id": "@foo"}, "@type": "@json"}}
    assert losses(document(model(node))) == []


@pytest.mark.parametrize(
    ("stray", "token"),
    [
        ("x", '"x"'),
        (1, "1"),
        ({"@value": True}, '{"@value": true}'),
        ({"@list": ["x"]}, '{"@list": ["x"]}'),
    ],
)
@pytest.mark.parametrize("top", ["array", "graph"])
def test_a_value_of_no_property_is_stated(stray: Any, token: str, top: str) -> None:
    node = {"@context": EX, "@id": "ex:a", "p": 1}
    content = [node, stray] if top == "array" else model({"@id": "ex:a", "p": 1}, stray)
    read = document(json.dumps(content))
    assert losses(read) == [("LostValue", token)]
    assert len(domain(read)) == 1


@pytest.mark.parametrize("nothing", [None, {}, {"@value": None}, {"@id": "ex:only-mentioned"}])
def test_nothing_among_nodes_is_no_loss(nothing: Any) -> None:
    assert losses(document(model({"@id": "ex:a", "p": 1}, nothing))) == []


def test_a_text_in_no_possible_language_is_stated() -> None:
    node = {"@id": "ex:a", "p": [{"@value": "x", "@language": "no tag"}, "y"]}
    read = document(json.dumps(model(node)))
    assert losses(read) == [("LostValue", '"x"')]
    assert len(domain(read)) == 1


def test_a_datatype_with_a_prefix_that_the_context_lacks() -> None:
    """It is wrong at its place in the context, whether or not the term is used."""
    read = document(model({"@id": "ex:a", "x": 1}, x={"@id": "ex:x", "@type": "xsd:double"}))
    assert losses(read) == [("UndefinedPrefix", '"xsd:double"')]
    assert details(read, '"xsd:double"')["prefix"] == ["xsd"]


def test_names_relative_to_nothing_are_relative() -> None:
    content = {"@context": {**EX, "@base": None}, "@id": "a", "p": 1, "to": "b"}
    read = document(content)
    assert losses(read) == [("RelativeReference", '"a"'), ("RelativeReference", '"b"')]
    assert "iri" not in details(read, '"a"')
    assert domain(read) == []


@pytest.mark.parametrize("vocabulary", ["", "#"])
def test_keys_of_a_vocabulary_that_is_the_document(vocabulary: str) -> None:
    content = {"@context": {"@vocab": vocabulary}, "@id": "https://e.org/a", "key": 1}
    read = document(content)
    assert losses(read) == [("RelativeReference", '"key"')]
    assert details(read, '"key"')["role"] == ["property"]


def test_lists_of_lost_nodes_leave_no_cells() -> None:
    context = {**EX, "@base": None, "list": {"@id": "ex:list", "@container": "@list"}}
    content = {"@context": context, "@id": "a", "list": [1, {"@id": "ex:b", "p": 2}]}
    assert [triple[2][:3] for triple in domain(document(content))] == ['"2"']


@pytest.mark.parametrize("context", [42, True, False, 1.5])
def test_a_number_for_a_context_makes_no_json_ld(context: Any) -> None:
    for content in ({"@context": context, "p": 1}, [{"@context": {}}, {"@context": context}]):
        with pytest.raises(SourceError, match="a context must be") as caught:
            document(json.dumps(content))
        assert caught.value.column == json.dumps(content).rindex('"@context"') + 13


def test_contexts_in_arrays_of_arrays_are_placed() -> None:
    content = {"@context": [[EX, ["x.json"]]], "@id": "ex:a", "p": 1}
    assert losses(document(content)) == [("UnresolvedContext", '"x.json"')]


@pytest.mark.parametrize(
    ("value", "place"),
    [
        ('{"lost": true, "@value": true}', '"@value": true'),
        ('{"@value": true, "lost": true}', '"@value": true'),
        ('{"lost": [1], "@list": [1]}', '"@list": [1]'),
    ],
)
def test_a_place_is_that_of_the_value_and_not_of_one_like_it(value: str, place: str) -> None:
    text = f'{{"@context": {{"p": "https://e.org/p"}}, "@id": "https://e.org/a", "p": {value}}}'
    read = document(text)
    spans = [read.map.triples[triple] for triple in domain(read) if "/p>" in triple[1]]
    start = text.index(place) + place.index(":") + 2
    assert [span.start for span in spans] == [start]


def test_literals_in_maps_have_their_own_place() -> None:
    term = {"@id": "ex:m", "@container": "@index"}
    text = json.dumps({"@context": {**EX, "m": term}, "m": {"a": True, "b": False, "c": [True]}})
    read = document(text)
    found = {triple[2][:5]: read.source[read.map.triples[triple]] for triple in domain(read)}
    assert found == {'"true': "true", '"fals': "false"}
    assert all(not triple[1].startswith(f"<{RDF}") for triple in domain(read))
