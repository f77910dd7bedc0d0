"""What JSON-LD loses is stated at its place."""

from __future__ import annotations

import json
from typing import Any

import pytest
from reading import details, document, domain, losses

from kinlint.contexts.context_library import NEWEST
from kinlint.terms import literal
from kinlint.vocabulary import DOCUMENT_BASE, METAMODELS, SRC

EX = {"ex": "https://example.org/arm#", "p": "ex:p", "to": {"@id": "ex:to", "@type": "@id"}}
RELATIONS = f"{METAMODELS}geometry/spatial-relations.json"
QUANTITIES = f"{METAMODELS}qudt-quant.json"
COORDINATES = f"{METAMODELS}geometry/coordinates.json"
QUDT = f"{METAMODELS}qudt.json"


def model(*nodes: Any, context: Any = EX) -> dict[str, Any]:
    return {"@context": context, "@graph": list(nodes)}


def test_a_key_that_nothing_maps_is_dropped_with_all_below_it() -> None:
    read = document(model({"@id": "ex:a", "p": 1, "lost": {"@id": "ex:b", "lost too": 2}}))
    assert losses(read) == [("DroppedKey", '"lost"')]
    assert details(read, '"lost"')["node"] == ["https://example.org/arm#a"]
    assert details(read, '"lost"')["document"] == ["urn:kinlint:document:arm.jsonld"]


def test_a_key_mapped_to_null_is_dropped_on_purpose() -> None:
    read = document(model({"@id": "ex:a", "p": 1, "note": "x"}, context=[EX, {"note": None}]))
    assert losses(read) == []


def test_a_key_like_a_keyword_is_dropped() -> None:
    assert losses(document(model({"@id": "ex:a", "p": 1, "@tpye": "x"}))) == [
        ("DroppedKey", '"@tpye"')
    ]


def test_a_key_dropped_in_a_value_belongs_to_the_node_round_it() -> None:
    read = document(model({"@id": "ex:a", "@reverse": {"ex:r": {"@id": "ex:b"}, "lost": 1}}))
    assert details(read, '"lost"')["node"] == ["https://example.org/arm#a"]


@pytest.mark.parametrize(
    ("key", "types", "releases"),
    [
        ("x", ["PositionCoordinate"], ["59e0b06", "6d34a4f"]),
        ("xx", ["PositionCoordinate"], []),
    ],
)
def test_other_releases_are_asked_about_a_dropped_key(
    key: str, types: list[str], releases: list[str]
) -> None:
    node = {"@id": "ex:a", "@type": types, key: 1.0}
    read = document(model(node, context=[COORDINATES, EX]))
    assert losses(read, "DroppedKey") == [("DroppedKey", f'"{key}"')]
    assert details(read, f'"{key}"').get("mappedInRelease", []) == releases


def test_the_scope_that_types_and_properties_open_counts() -> None:
    scoped = {
        **EX,
        "T": {"@id": "ex:T", "@context": {"q": "ex:q"}},
        "in": {"@id": "ex:in", "@context": {"r": "ex:r"}},
    }
    inside = {"@id": "ex:b", "r": 1, "q": 2}
    node = {"@id": "ex:a", "@type": "T", "q": 1, "r": 1, "in": inside}
    read = document(model(node, {"@id": "ex:c", "q": 3}, context=scoped))
    assert losses(read) == [("DroppedKey", '"r"'), ("DroppedKey", '"q"'), ("DroppedKey", '"q"')]


def test_a_unit_is_relative_to_the_base_of_its_property() -> None:
    read = document(model({"@id": "ex:a", "unit": "M"}, context=[QUDT, EX]))
    assert losses(read) == []
    assert domain(read)[0][2] == "<http://qudt.org/vocab/unit/M>"


def test_a_context_in_a_node_replaces_terms_below_it() -> None:
    node = {"@context": {"p": "ex:own", "q": "ex:q"}, "@id": "ex:a", "p": 1, "q": 2}
    read = document(model(node, {"@id": "ex:b", "q": 3}))
    assert losses(read) == [("DroppedKey", '"q"')]


@pytest.mark.parametrize(
    ("base", "iri"), [(None, DOCUMENT_BASE), ("https://example.org/", "https://example.org/")]
)
def test_a_type_that_is_no_term_is_relative_whatever_the_base(base: str | None, iri: str) -> None:
    context = [EX, {"@base": base}] if base else EX
    read = document(model({"@id": "ex:a", "@type": ["ex:T", "3D"]}, context=context))
    assert losses(read) == [("RelativeType", '"3D"')]
    assert details(read, '"3D"')["iri"] == [f"{iri}3D"]
    assert details(read, '"3D"')["written"] == ["3D"]


def test_a_type_under_a_vocabulary_is_not_relative() -> None:
    context = [EX, {"@vocab": "https://example.org/v#"}]
    assert losses(document(model({"@id": "ex:a", "@type": "3D"}, context=context))) == []


def test_a_relative_value_says_of_which_property_it_is() -> None:
    read = document(model({"@id": "ex:a", "to": "b"}))
    assert losses(read) == [("RelativeReference", '"b"')]
    said = details(read, '"b"')
    assert said["role"] == ["value"]
    assert said["property"] == ["https://example.org/arm#to"]
    assert said["iri"] == [f"{DOCUMENT_BASE}b"]


def test_a_relative_identifier_is_stated_once_and_its_references_are_not() -> None:
    read = document(model({"@id": "b", "p": 1}, {"@id": "ex:a", "to": ["b", {"@id": "b"}]}))
    assert losses(read, "RelativeReference") == [("RelativeReference", '"b"')]
    assert details(read, '"b"')["role"] == ["identifier"]


def test_what_the_author_gave_a_base_is_not_relative() -> None:
    context = [EX, {"@base": "https://example.org/arm/"}]
    assert losses(document(model({"@id": "b", "to": "c"}, context=context))) == []


def test_a_prefix_that_nobody_defined() -> None:
    node = {"@id": "rob:a", "@type": "geom:T", "geom:p": {"@id": "x:y"}, "to": "mailto:a@b.c"}
    read = document(model(node))
    assert losses(read) == [
        ("UndefinedPrefix", '"rob:a"'),
        ("UndefinedPrefix", '"geom:T"'),
        ("UndefinedPrefix", '"geom:p"'),
        ("UndefinedPrefix", '"x:y"'),
    ]
    assert details(read, '"geom:p"')["prefix"] == ["geom"]


def test_a_term_defined_with_a_prefix_that_nobody_defined() -> None:
    context = {**EX, "lost": "geom:p", "blank": "_:p", "name": "urn:p"}
    read = document(model({"@id": "ex:a", "lost": 1, "blank": 2, "name": 3}, context=context))
    assert losses(read) == [("UndefinedPrefix", '"lost"'), ("DroppedKey", '"blank"')]
    assert details(read, '"lost"')["prefix"] == ["geom"]


def test_every_repetition_of_a_key_is_stated() -> None:
    text = (
        '{"@context": {"p": "https://e.org/p"}, "@id": "https://e.org/a", "p": 1, "p": 2, "p": 3}'
    )
    read = document(text)
    assert losses(read) == [("DuplicateKey", '"p"')] * 2
    assert details(read, '"p"')["node"] == ["https://e.org/a"] * 2
    assert domain(read)[0][2].startswith('"3"')


def test_a_term_shadowed_by_a_later_context() -> None:
    node = {"@id": "ex:a", "@type": "Position", "of": "ex:b", "with-respect-to": "ex:c"}
    read = document(model(node, context=[RELATIONS, QUANTITIES, EX]))
    assert losses(read, "ShadowedTerm") == [("ShadowedTerm", '"Position"')]
    said = details(read, '"Position"')
    assert (said["context"], said["shadowed"]) == ([QUANTITIES], [RELATIONS])
    assert said["iri"] == ["http://qudt.org/vocab/quantitykind/Position"]
    assert len(losses(read, "DroppedKey")) == 2


def test_a_shadowed_term_that_is_restored_or_unused_is_none() -> None:
    restored = {"@context": RELATIONS, "@id": "ex:a", "@type": "Position", "of": "ex:b"}
    read = document(model(restored, context=[RELATIONS, QUANTITIES, EX]))
    assert losses(read) == []


def test_a_context_that_nobody_knows() -> None:
    context = ["file:///home/robot.json", EX]
    read = document(model({"@id": "ex:a", "@type": "Arm", "p": 1, "q": 2}, context=context))
    assert losses(read) == [
        ("UnresolvedContext", '"file:///home/robot.json"'),
        ("RelativeType", '"Arm"'),
        ("UnreadKey", '"q"'),
    ]
    said = details(read, '"file:///home/robot.json"')
    assert set(said["context"]) == {"file:///home/robot.json"}
    assert len(said["reason"]) == 1
    assert len(domain(read)) == 2


def test_what_is_known_again_below_null_is_judged_again() -> None:
    inner = {"@context": [None, EX], "@id": "ex:b", "q": 1, "p": 1}
    read = document(model(inner, {"q": 2}, context=["x.json", EX]))
    assert losses(read)[1:] == [("DroppedKey", '"q"'), ("UnreadKey", '"q"')]


@pytest.mark.parametrize(
    ("context", "at"),
    [
        ({**EX, "q": {"@id": "ex:q", "type": "@id"}}, '{"@id": "ex:q", "type": "@id"}'),
        ([EX, 5], "5"),
        ([EX, True], "true"),
        ({**EX, "a": "b:c", "b": "a:d"}, '"a:d"'),
        ([EX, {"@context": {}}], '{"@context": {}}'),
    ],
)
def test_an_invalid_context_spoils_no_more_than_it_must(context: Any, at: str) -> None:
    text = json.dumps(model({"@id": "ex:a", "p": 1, "q": 2}, context=context))
    read = document(text)
    assert losses(read) == [("InvalidContext", at), ("UnreadKey", '"q"')]
    assert [triple[1] for triple in domain(read)] == ["<https://example.org/arm#p>"]


def test_settings_may_be_withdrawn_that_were_never_made() -> None:
    nulls = {"@vocab": None, "@language": None, "@direction": None}
    read = document(model({"@id": "ex:a", "p": 1}, context=[nulls, EX]))
    assert losses(read) == []
    assert len(domain(read)) == 1


def test_graphs_are_flattened_and_their_names_kept() -> None:
    content = {**model({"@id": "ex:a", "p": 1}), "@id": "ex:g"}
    read = document(content)
    assert losses(read) == [("NamedGraph", '"ex:g"')]
    assert details(read, '"ex:g"')["name"] == ["https://example.org/arm#g"]
    assert domain(read)[0][0] == "<https://example.org/arm#a>"


def test_an_iri_with_impossible_characters_is_not_passed_on() -> None:
    read = document(model({"@id": "ex:a", "to": "https://e.org/a b", "p": {"@id": "ex:>"}}))
    assert [kind for kind, _ in losses(read)] == ["MalformedIri", "MalformedIri"]
    assert domain(read) == []


def test_the_contexts_that_are_used_and_their_release() -> None:
    read = document(model({"@id": "ex:a", "unit": "M"}, context=[QUDT, EX]))
    uses = [value for _, prop, value in read.statements if prop == f"<{SRC}usesContext>"]
    assert len(uses) == 1
    assert read.source[read.map.nodes[uses[0]].whole] == f'"{QUDT}"'
    assert (uses[0], f"<{SRC}release>", literal(NEWEST)) in read.statements
    assert (uses[0], f"<{SRC}context>", literal(QUDT)) in read.statements


def test_the_document_and_its_namespaces() -> None:
    nodes = [{"@id": "ex:a", "p": 1}, {"@id": "https://e.org/x/y", "p": 1}, {"p": 2}]
    nodes += [{"@id": "relative", "p": 3}, {"@id": "ex:only-mentioned"}]
    read = document(model(*nodes), "models/my arm.jsonld")
    assert read.graph == "<urn:kinlint:document:models/my%20arm.jsonld>"
    said = {(prop, value) for subject, prop, value in read.statements if subject == read.graph}
    assert (f"<{SRC}name>", '"models/my arm.jsonld"') in said
    assert (f"<{SRC}format>", '"jsonld"') in said
    spaces = {value for prop, value in said if prop == f"<{SRC}ownNamespace>"}
    assert spaces == {'"https://example.org/arm#"', '"https://e.org/x/"'}
    described = [s for s, prop, _ in read.statements if prop == f"<{SRC}describedIn>"]
    assert len(described) == 4


def test_blank_nodes_of_two_files_never_have_one_name() -> None:
    content = model({"@id": "_:b", "p": 1}, {"p": [{"@id": "_:b"}]})
    one, other = document(content, "a.jsonld"), document(content, "b.jsonld")
    names = [{term for triple in domain(read) for term in triple[::2]} for read in (one, other)]
    assert not {name for name in names[0] & names[1] if name.startswith("_:")}
    assert document(content, "a.jsonld").statements == one.statements


def test_prefixes_are_kept_for_messages() -> None:
    assert document(model({"@id": "ex:a"})).prefixes["ex"] == "https://example.org/arm#"
