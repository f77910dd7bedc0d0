"""SPARQL of rule authors: what it means, what SHACL forbids, what pySHACL must run."""

from __future__ import annotations

import json

import pytest
from turtle_document import PREFIXES, document, ex

from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.constraint import FOCUS, Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid

DECLARED = (
    "prefixes.ttl",
    PREFIXES
    + """
    <https://example.org/> a owl:Ontology ;
        sh:declare [ sh:prefix "" ; sh:namespace "https://example.org/"^^xsd:anyURI ] .
    """,
)


def compiled(text: str, shape: str = "sh:targetSubjectsOf :p", more: str = "") -> list[Constraint]:
    constraint = f'sh:sparql [ sh:prefixes <https://example.org/> ; sh:select """{text}""" ]'
    shapes = ("rule.ttl", f"{PREFIXES} :s a sh:NodeShape ; {shape} ; {constraint} . {more}")
    return list(compile_shapes([DECLARED, shapes]))


def results(text: str, data: str, shape: str = "sh:targetSubjectsOf :p") -> list[Result]:
    store = Store()
    store.load([document(data)])
    constraints = compiled(text, shape)
    assert all(each.deferred is None for each in constraints)
    return list(check(store, constraints))


def test_result_has_what_the_query_says() -> None:
    """Path, value, message and the other variables; predicates that are no IRI do not count."""
    text = """SELECT $this (:q AS ?path) ?value ('why' AS ?message) (1 AS ?n) WHERE {
        $this :p ?value }"""
    (found,) = results(text, ":a :p :b .")
    assert (found.focus, found.path, found.value) == (ex("a"), ex("q"), ex("b"))
    assert found.message == "why"
    assert found.bindings["n"] == '"1"^^<http://www.w3.org/2001/XMLSchema#integer>'
    assert found.constraint.component.endswith("#SPARQLConstraintComponent")


@pytest.mark.parametrize("head", ["$this", "$this ?value", "DISTINCT $this (?none AS ?value)"])
def test_value_is_the_focus_node_where_the_query_has_none(head: str) -> None:
    """For node shapes."""
    (found,) = results(f"SELECT {head} WHERE {{ $this :p ?o }}", ":a :p :b .")
    assert found.value == ex("a")


def test_path_variable_stands_for_the_path_of_the_shape() -> None:
    """Before the query is parsed; in strings too there is nothing else it could mean."""
    text = "SELECT $this ?value WHERE { $this $PATH ?value FILTER NOT EXISTS { ?value $PATH ?x } }"
    shape = "sh:targetSubjectsOf :r ; sh:path ( :p [ sh:inversePath :q ] )"
    (found,) = results(text, ":a :r 1 ; :p :b . :c :q :b .", shape)
    assert (found.value, found.path) == (ex("c"), None)


def test_each_solution_is_one_result_and_equal_ones_are_one() -> None:
    """As pySHACL has it."""
    text = "SELECT $this ?value WHERE { $this :p ?value . $this :q ?other }"
    assert len(results(text, ":a :p :b, :c ; :q 1, 2 .")) == 2


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("SELECT $this WHERE { FILTER (BOUND($this)) }", "ab"),
        (
            (
                "SELECT $this { { FILTER ($this = :a) } UNION "
                "{ BIND ($this AS ?x) FILTER (?x = :b) } }"
            ),
            "ab",
        ),
        (
            (
                "SELECT $this { { SELECT $this (COUNT(?o) AS ?n) { $this :p ?o } GROUP BY $this } "
                "FILTER (?n > 1) }"
            ),
            "b",
        ),
        ("SELECT $this { $this :p ?o } GROUP BY $this HAVING (COUNT(?o) > 1)", "b"),
        ("SELECT $this ?value WHERE { $this :p ?value } ORDER BY ?value LIMIT 1", "ab"),
        ("SELECT * WHERE { $this :p 1 }", "ab"),
        (
            (
                "SELECT $this { $this :p 1 OPTIONAL { $this :p ?o FILTER (?o > 1) } "
                "FILTER (!BOUND(?o)) }"
            ),
            "a",
        ),
        ("SELECT $this WHERE { FILTER NOT EXISTS { { SELECT $this { $this :p 2 } } } }", "a"),
    ],
)
def test_focus_node_is_bound_wherever_it_is_named(text: str, expected: str) -> None:
    """In nested groups, branches, sub-selects, aggregates and under LIMIT."""
    found = results(text, ":a :p 1 . :b :p 1, 2 . :c :q 1 .")
    assert [each.focus for each in sorted(found, key=lambda each: each.focus)] == [
        ex(name) for name in expected
    ]


LOCATED = {
    "'foo:' is not declared",
    "the query ends too early",
    "not SPARQL 1.1 near 'LATERAL'",
    "not SPARQL 1.1 near '}'",
    "not SPARQL 1.1 near '§ }'",
}
"""What the grammar refuses is told with its line."""


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        ("SELECT $this WHERE { $this :p ?o MINUS { $this :q ?o } }", "MINUS is not allowed"),
        ("SELECT $this WHERE { VALUES ?x { 1 } }", "VALUES is not allowed"),
        ("SELECT $this WHERE { $this :p ?o } VALUES ?o { 1 }", "VALUES is not allowed"),
        ("SELECT $this WHERE { SERVICE :s { $this :p ?o } }", "SERVICE is not allowed"),
        ("SELECT $this FROM :g WHERE { $this :p ?o }", "FROM is not allowed"),
        ("SELECT $this WHERE { $this :p ?o FILTER (:own(?o)) }", "the function"),
        ("SELECT $this WHERE { BIND (1 AS ?this) }", "BIND gives a value to ?this"),
        ("SELECT (1 AS ?this) WHERE { ?x :p 1 }", "AS gives a value to ?this"),
        ("SELECT $this WHERE { { SELECT ?x { ?x :p ?o } } }", "a sub-select lacks ?this"),
        ("SELECT ?x WHERE { $this :p ?x }", "does not return $this"),
        ("SELECT $this WHERE { $this $PATH ?x }", "no meaning in a node shape"),
        ("SELECT $this WHERE { $this foo:p ?x }", "'foo:' is not declared"),
        ("SELECT $this WHERE { $this :p ?x ", "the query ends too early"),
        ("SELECT $this WHERE { $this :p ?x } LATERAL", "not SPARQL 1.1 near 'LATERAL'"),
        ("SELECT $this WHERE { $this :p ?x FILTER (?x = ) }", "not SPARQL 1.1 near '}'"),
        ("SELECT $this WHERE { § }", "not SPARQL 1.1 near '§ }'"),
        ("ASK { $this :p ?x }", "sh:select is a query of another kind"),
    ],
)
def test_what_shacl_forbids_is_refused(text: str, cause: str) -> None:
    """Naming the file, the shape and the cause."""
    with pytest.raises(RuleInvalid) as error:
        compiled(text)
    place = "rule.ttl:8: " if cause in LOCATED else "rule.ttl: <https://example.org/s>: "
    assert str(error.value).startswith(place)
    assert cause in str(error.value)


def test_words_inside_names_and_strings_are_no_keywords() -> None:
    """`kc:origin-offset` holds OFFSET, and a message may say MINUS."""
    text = "SELECT $this ?value WHERE { $this :origin-offset 'a MINUS b # no comment' ; :p ?value }"
    (found,) = results(text, ":a :origin-offset 'a MINUS b # no comment' ; :p 1 .")
    assert found.focus == ex("a")


@pytest.mark.parametrize(
    ("text", "shape", "reason"),
    [
        ("SELECT $this { GRAPH $shapesGraph { $this :p ?o } }", "", "shapesGraph"),
        ("SELECT $this { $currentShape :p $this }", "", "currentShape"),
        ("SELECT $this { GRAPH ?g { $this :p ?o } }", "", "GRAPH"),
        ("SELECT $this { $this :p ?o FILTER (REGEX(STR(?o), '(?=a)')) }", "", "regular expression"),
        (
            "SELECT $this { $this :p ?o FILTER (:own(?o)) }",
            "sh:name 's' . :own a sh:SPARQLFunction . :s ",
            "custom function",
        ),
        ("SELECT $this { $this :p* ?o }", "sh:targetNode :a ; ", "outside the graph"),
        ("SELECT $this { ?o :p* :a . FILTER (?o != $this) }", "", "no steps"),
    ],
)
def test_what_is_not_covered_is_deferred(text: str, shape: str, reason: str) -> None:
    """Rather than run with another meaning."""
    (found,) = compiled(text, f"{shape}sh:targetSubjectsOf :p")
    assert reason in (found.deferred or "")
    assert not found.select


def test_constraints_of_one_rule_file_belong_to_the_rule() -> None:
    """Also those of shapes elsewhere that it uses; other shapes speak for themselves."""
    rule = """@prefix kl: <https://w3id.org/kinlint/ns#> .
        :rule a kl:Rule ; sh:targetSubjectsOf :p ;
        sh:property [ sh:path :q ; sh:minCount 1 ], :shared ."""
    other = (
        ":shared sh:path :q ; sh:maxCount 1 . :own sh:targetSubjectsOf :p ; sh:property :shared ."
    )
    found = compile_shapes([("rule.ttl", PREFIXES + rule), ("other.ttl", PREFIXES + other)])
    assert [each.owner.rpartition("/")[2] for each in found] == ["rule", "rule", "own"]


def test_message_for_readers_of_english_comes_first() -> None:
    """Untagged and @en before others; those of the constraint before those of the shape."""
    shape = 'sh:targetSubjectsOf :p ; sh:message "shape" ; sh:nodeKind sh:BlankNode'
    found = compiled("SELECT $this WHERE { $this :p ?o }", shape)
    assert [each.messages for each in found] == [("shape",), ("shape",)]
    own = (
        ':t a sh:NodeShape ; sh:targetSubjectsOf :q ; sh:sparql :c ; sh:message "shape" .'
        ':c sh:message "auf Deutsch"@de, "in English"@en ; sh:select "SELECT $this WHERE {}" .'
    )
    *_, last = compiled("SELECT $this WHERE { $this :p ?o }", more=own)
    assert last.messages == ("in English", "auf Deutsch")


def test_premises_are_the_patterns_that_must_hold() -> None:
    """Of target and WHERE, paths taken apart; not those of OPTIONAL, UNION and EXISTS."""
    text = """SELECT $this ?value WHERE { $this :p/^:q ?value ; :n 1 . { ?value a :C }
        OPTIONAL { $this :o ?o } FILTER EXISTS { $this :e ?e }
        { $this :u 1 } UNION { $this :u 2 } }"""
    (found,) = compiled(text, "sh:targetSubjectsOf :t")
    one = '"1"^^<http://www.w3.org/2001/XMLSchema#integer>'
    rdf_type = "<http://www.w3.org/1999/02/22-rdf-syntax-ns#type>"
    assert found.premises == (
        ("?this", ex("t"), "?k_t"),
        ("?this", ex("p"), "?k_2000"),
        ("?value", ex("q"), "?k_2000"),
        ("?this", ex("n"), one),
        ("?value", rdf_type, ex("C")),
    )


def test_constraint_survives_json() -> None:
    """Through text, as the cache keeps it."""
    for each in compiled("SELECT $this WHERE { $this :p ?o }", "sh:targetSubjectsOf :p"):
        assert Constraint.from_json(json.loads(json.dumps(each.to_json()))) == each
        assert FOCUS in each.single


def test_compiling_twice_gives_the_same() -> None:
    """Names of blank shapes and variables included."""
    text = "SELECT $this WHERE { FILTER NOT EXISTS { $this :p/:q ?o } }"
    shape = "sh:targetSubjectsOf :p ; sh:or ( [ sh:nodeKind sh:IRI ] [ sh:class :C ] )"
    assert compiled(text, shape) == compiled(text, shape)


def test_rule_is_no_result_where_only_conformance_is_asked() -> None:
    """A shape with sh:sparql may be used by sh:node, sh:not and sh:property of others."""
    more = """:t a sh:NodeShape ; sh:targetSubjectsOf :r ; sh:not :s ;
        sh:property [ sh:path :r ; sh:node :s ] ."""
    text = "SELECT $this ?value WHERE { $this :p ?value FILTER NOT EXISTS { $this :q ?value } }"
    constraints = compiled(text, "sh:nodeKind sh:IRI", more)
    store = Store()
    store.load([document(":a :r :b ; :p 1 ; :q 1 . :b :p 1 ; :r :a .")])
    found = {
        (each.focus, each.constraint.component.rpartition("#")[2])
        for each in check(store, constraints)
    }
    assert found == {(ex("a"), "NotConstraintComponent"), (ex("a"), "NodeConstraintComponent")}


@pytest.mark.parametrize(
    ("pattern", "found"),
    [
        ("$this :p ( 1 ?x )", True),
        ("$this :p ( )", True),
        ("$this :p [ :q ?x , 2 ; :r [] ; ]", True),
        ("[ :q 2 ] :r ?x . $this :p ?any", True),
        ("( 1 ) :p ?x . $this :p ?any", False),
        ("$this !(:q|^:q) ?x", True),
        ("_:one :q ?x . _:one :r ?y . $this :p _:one", True),
        ("$this :p/(:q|:r)/:none? ?x", True),
        ("$this ?link ?x FILTER (?link = :p && DATATYPE(?x) = xsd:integer)", True),
    ],
)
def test_abbreviated_patterns_mean_in_exists_what_they_mean_outside(
    pattern: str,
    found: bool,  # noqa: FBT001
) -> None:
    """Lists, blank node descriptions, negated sets: the rewrite writes them out."""
    pattern = pattern.replace("xsd:integer", "<http://www.w3.org/2001/XMLSchema#integer>")
    data = ":a :p ( 1 2 ), (), [ :q 1, 2 ; :r [] ], 5 ."
    where = f"$this :p 5 FILTER EXISTS {{ {pattern} . $this :p 5 }}"
    assert bool(results(f"SELECT $this WHERE {{ {where} }}", data)) == found
    everything = f"SELECT $this WHERE {{ $this :p 5 {{ {pattern} }} }}"
    assert bool(results(everything, data)) == found


@pytest.mark.parametrize(
    ("declarations", "cause"),
    [
        ("sh:prefix 'x' ; sh:namespace 'urn:1', 'urn:2'", "2 values"),
        ("sh:prefix 'x'", "lacks sh:namespace"),
        ("sh:prefix '' ; sh:namespace 'urn:1'", "is declared for two namespaces"),
    ],
)
def test_prefix_must_be_declared_once(declarations: str, cause: str) -> None:
    """Over all that sh:prefixes names and imports."""
    more = f"<https://example.org/> owl:imports :more . :more sh:declare [ {declarations} ] ."
    more += ":more owl:imports <https://example.org/> ."
    with pytest.raises(RuleInvalid) as error:
        compiled("SELECT $this WHERE { $this :p 1 }", more=more)
    assert cause in str(error.value)


def test_query_may_declare_prefixes_of_its_own() -> None:
    """They come before those of sh:prefixes; a base resolves relative IRIs."""
    text = """PREFIX own: <https://example.org/> BASE <https://example.org/x/>
        SELECT $this ?value WHERE { $this own:p ?value ; <../q> 'tag'@en , '''it's''' }"""
    (found,) = results(text, ':a :p 1 ; :q "tag"@en, "it\'s" .')
    assert found.focus == ex("a")
