"""What the editor of JSON-LD does not say, and where it finds a place that is not obvious."""

from __future__ import annotations

import re

import pytest
from editing_json_ld import OPTIONS, document, domain, edited

from kinlint.edits import Delta, NotExpressible, applied
from kinlint.formats.jsonld.editing import editor, traced_expansion
from kinlint.terms import RDF_TYPE, Term, Triple
from kinlint.vocabulary import SRC

EX = "https://example.org/arm#"
CONTEXT = """{
    "ex": "https://example.org/arm#", "p": "ex:p", "q": { "@id": "ex:q", "@type": "@id" },
    "of": { "@reverse": "ex:has", "@type": "@id" },
    "by": { "@id": "ex:by", "@container": "@index" },
    "in": { "@id": "ex:in", "@container": "@language" },
    "T": { "@id": "ex:T", "@context": { "own": "ex:own" } },
    "list": { "@id": "ex:list", "@container": "@list" }
  }"""


def ex(name: str) -> Term:
    return f"<{EX}{name}>"


A, B, P, Q = map(ex, ("a", "b", "p", "q"))


def model(members: str) -> str:
    return f'{{\n  "@context": {CONTEXT},\n  {members}\n}}\n'


def graph(*nodes: str) -> str:
    return model('"@graph": [\n    ' + ",\n    ".join(nodes) + "\n  ]")


def stated(text: str, *names: str) -> list[Triple]:
    """The triples whose property, or else value, is one of *names* of the namespace."""
    terms = {ex(name) for name in names}
    return [triple for triple in domain(document(text)) if terms.intersection(triple[1:])]


def refusal(text: str, removed: list[Triple], added: list[Triple]) -> str:
    with pytest.raises(NotExpressible) as refused:
        editor.Editor(document(text), OPTIONS).edits(Delta(tuple(removed), tuple(added)))
    return str(refused.value)


def test_a_reverse_property_is_left_alone() -> None:
    text = graph('{ "@id": "ex:a", "of": "ex:b", "p": 1 }')
    assert "reverse property" in refusal(text, stated(text, "has"), [])


@pytest.mark.parametrize("key", ["by", "in"])
def test_a_map_is_left_alone(key: str) -> None:
    text = graph(f'{{ "@id": "ex:a", "{key}": {{ "de": "x", "en": "y" }} }}')
    assert "in a map" in refusal(text, stated(text, key)[:1], [])
    assert "another value already" in refusal(text, [], [(A, ex(key), '"z"')])


def test_a_node_within_one_that_goes_must_go_too() -> None:
    text = graph('{ "@id": "ex:a", "p": { "@id": "ex:b", "p": 1 } }')
    assert refusal(text, [(A, P, B)], []) == "what would go with it says more"


def test_a_type_that_gives_a_key_its_meaning_stays() -> None:
    text = graph('{ "@id": "ex:a", "@type": "T", "own": 1 }')
    assert "the key 'own' means something else" in refusal(text, [(A, RDF_TYPE, ex("T"))], [])


def test_a_type_goes_with_what_it_gives_a_meaning() -> None:
    text = graph('{ "@id": "ex:a", "@type": "T", "own": 1, "p": 2 }')
    removed = [(A, RDF_TYPE, ex("T")), *stated(text, "own")]
    assert edited(document(text), Delta(tuple(removed))) == graph('{ "@id": "ex:a", "p": 2 }')


def test_an_anonymous_node_cannot_be_pointed_to() -> None:
    text = graph('{ "@id": "ex:a", "p": { "p": 1 } }', '{ "@id": "ex:b", "p": 2 }')
    node = next(value for _, prop, value in domain(document(text)) if value[0] == "_")
    assert "without an identifier" in refusal(text, [], [(B, Q, node)])


def test_a_list_must_not_be_left_without_an_end() -> None:
    text = graph('{ "@id": "ex:a", "list": [ 1, 2 ] }')
    rest = [triple for triple in domain(document(text)) if triple[1].endswith("#rest>")]
    assert refusal(text, rest[:1], []) == "the list would be broken"


def test_statements_about_the_file_follow_from_it() -> None:
    text = graph('{ "@id": "ex:a", "lost": 1, "p": 1 }')
    said = next(t for t in document(text).statements if t[1] == f"<{SRC}offset>")
    assert refusal(text, [said], []) == "it follows from what the file says"


def test_a_lone_node_has_no_room_for_another() -> None:
    text = model('"@id": "ex:a", "p": 1')
    assert "no @graph" in refusal(text, [], [(B, P, '"x"')])


def test_a_lone_node_holds_another_that_it_points_to() -> None:
    text = model('"@id": "ex:a", "p": 1')
    delta = Delta((), ((A, Q, B), (B, P, '"x"')))
    assert edited(document(text), delta) == model(
        '"@id": "ex:a", "p": 1, "q": { "@id": "ex:b", "p": "x" }'
    )


def test_a_value_is_added_where_one_goes_or_else_where_the_types_are() -> None:
    nodes = '{ "@id": "ex:a", "p": 1 }', '{ "@id": "ex:a", "@type": "T", "q": "ex:b" }'
    text = graph(*nodes)
    assert edited(document(text), Delta((), ((A, ex("r"), '"x"'),))) == graph(
        nodes[0], nodes[1].replace(" }", ', "ex:r": "x" }')
    )
    delta = Delta(tuple(stated(text, "p")), ((A, ex("r"), '"x"'),))
    assert edited(document(text), delta) == graph('{ "@id": "ex:a", "ex:r": "x" }', nodes[1])


def test_what_is_written_twice_is_taken_out_twice_and_replaced_once() -> None:
    text = graph('{ "@id": "ex:a", "p": [ 1, 2, 1 ] }', '{ "@id": "ex:a", "p": 1, "q": "ex:b" }')
    one = next(triple for triple in stated(text, "p") if triple[2].startswith('"1"'))
    assert edited(document(text), Delta((one,))) == graph(
        '{ "@id": "ex:a", "p": [ 2 ] }', '{ "@id": "ex:a", "q": "ex:b" }'
    )
    assert edited(document(text), Delta((one,), ((A, P, '"x"'),))) == graph(
        '{ "@id": "ex:a", "p": [ "x", 2 ] }', '{ "@id": "ex:a", "q": "ex:b" }'
    )


def test_a_node_that_is_still_pointed_to_becomes_a_reference() -> None:
    text = graph('{ "@id": "ex:a", "q": { "@id": "ex:b", "p": 1 } }')
    removed = tuple(stated(text, "p"))
    assert edited(document(text), Delta(removed)) == graph('{ "@id": "ex:a", "q": "ex:b" }')


def test_a_text_is_expanded_once_for_all_deltas(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[object] = []
    trace = editor.Trace

    def counted(*arguments: object) -> object:
        calls.append(arguments)
        return trace(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(editor, "Trace", counted)
    text = graph('{ "@id": "ex:a", "p": [ 1, 2, 3 ] }')
    made = editor.Editor(document(text), OPTIONS)
    assert not calls
    for triple in stated(text, "p"):
        assert made.edits(Delta((triple,)))
    assert len(calls) == 1


def test_only_the_elements_in_question_are_traced(monkeypatch: pytest.MonkeyPatch) -> None:
    traced: list[str] = []
    trace = traced_expansion.Tracing.trace_element

    def noted(processor: traced_expansion.Tracing, element: dict[str, str]) -> None:
        traced.append(element["@id"])
        trace(processor, element)

    monkeypatch.setattr(traced_expansion.Tracing, "trace_element", noted)
    nodes = [f'{{ "@id": "ex:n{number}", "p": {number} }}' for number in range(20)]
    text = graph(*nodes, '{ "@id": "ex:a", "p": 0.5, "q": "ex:n7" }')
    (one,) = [triple for triple in stated(text, "p") if triple[0] == A]
    assert edited(document(text), Delta((one,))) == text.replace('"p": 0.5, ', "")
    assert traced == ["ex:a"]


LAYOUTS = {
    "minified": '{"@context":{"p":"urn:p"},"@id":"urn:a"<,"p":[0.5,"x"]>}',
    "one line": '{ "@context": { "p": "urn:p" }, "@id": "urn:a"<, "p": [ 0.5, "x" ]> }',
    "wide colons": '{"@context" : {"p" : "urn:p"}, "@id" : "urn:a"<, "p" : [0.5, "x"]>}',
    "tabs": '{|\t"@context": {|\t\t"p": "urn:p"|\t},|\t"@id": "urn:a"<,|\t"p": [0.5, "x"]>|}',
    "all in lines": '{| "@context": {|  "p": "urn:p"| },| "@type": [|  "urn:T"| ],| "@id": "urn:a"'
    '<,| "p": [|  0.5,|  "x"| ]>|}|',
    "by four": '{|    "@context": {"p": "urn:p"},|    "@id": "urn:a"<,|    "p": [0.5, "x"]>|}',
}


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("name", LAYOUTS)
def test_the_layout_is_that_of_the_file(name: str, newline: str) -> None:
    before, added, after = re.split("[<>]", LAYOUTS[name].replace("|", newline))
    number = '"0.5"^^<http://www.w3.org/2001/XMLSchema#double>'
    delta = Delta((), (("<urn:a>", "<urn:p>", number), ("<urn:a>", "<urn:p>", '"x"')))
    assert edited(document(before + after), delta) == before + added + after


def test_a_type_that_gets_a_meaning_may_give_keys_one() -> None:
    text = graph('{ "@id": "ex:a", "@type": "Typ", "own": 1 }')
    wrong = next(triple for triple in domain(document(text)) if triple[1] == RDF_TYPE)
    edits = editor.Editor(document(text), OPTIONS).edits(Delta((wrong,), ((A, RDF_TYPE, ex("T")),)))
    assert applied(text, edits) == text.replace("Typ", "T")
