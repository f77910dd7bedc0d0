"""Single components of SHACL Core where the W3C suite and random shapes leave something open."""

from __future__ import annotations

import pytest
from turtle_document import PREFIXES, document, ex

from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.terms import Term, is_blank, is_literal, literal_value


def compiled(shapes: str) -> tuple[Constraint, ...]:
    return compile_shapes([("shapes.ttl", PREFIXES + shapes)])


def results(shapes: str, data: str) -> list[Result]:
    store = Store()
    store.load([document(data)])
    constraints = compiled(shapes)
    assert all(each.deferred is None for each in constraints)
    return list(check(store, constraints))


def values(constraint: str, data: str) -> list[str]:
    """The values of `:p` that break *constraint*: local names, lexical forms, or nothing."""
    found = results(f":s sh:targetNode :a ; sh:property [ sh:path :p ; {constraint} ] .", data)
    assert all(each.focus == ex("a") and each.path == ex("p") for each in found)
    return sorted(plain(each.value or "") for each in found)


def plain(term: Term) -> str:
    if is_literal(term):
        return literal_value(term)
    return "" if is_blank(term) else term.rpartition("/")[2].rstrip(">")


@pytest.mark.parametrize(
    ("constraint", "objects", "expected"),
    [
        ("sh:datatype xsd:integer", '1, "x"^^xsd:integer, 1.0, "1"', ["1", "1", "x"]),
        ("sh:datatype xsd:decimal", '1.5, "1e5"^^xsd:decimal, ".5"^^xsd:decimal', ["1e5"]),
        ("sh:datatype xsd:double", '1e0, "INF"^^xsd:double, "one"^^xsd:double', ["one"]),
        ("sh:datatype xsd:boolean", 'true, "1"^^xsd:boolean, "yes"^^xsd:boolean', ["yes"]),
        ("sh:datatype xsd:date", '"2020-02-29"^^xsd:date, "2021-02-29"^^xsd:date', ["2021-02-29"]),
        ("sh:datatype rdf:langString", '"a"@en, "a"', ["a"]),
        ("sh:datatype :own", '"a"^^:own, "a"^^:other', ["a"]),
        ("sh:minExclusive 0", '"0.0000000000000000001"^^xsd:decimal, 0.0, -1e0', ["-1", "0"]),
        ("sh:maxInclusive true", 'false, true, "x"', ["x"]),
        ("sh:maxInclusive 2", '2, 2.0, 2.0e0, 2.5, "2"', ["2", "2.5"]),
        ("sh:minLength 2", '"a", "ab", :x', ["a"]),
        ("sh:pattern 'a.c' ; sh:flags 'q'", '"a.c", "abc"', ["abc"]),
        ("sh:in ( 1 'a' )", '1, 1.0, "a", "a"@en', ["1", "a"]),
        ("sh:in ()", "1", ["1"]),
        ("sh:languageIn ('en')", '"a"@en, "b"@en-GB, "c"@de, "d"', ["c", "d"]),
        ("sh:lessThan :q", "1, :x, 3", ["3", "3", "x", "x"]),
        ("sh:lessThanOrEquals :q", "1, 2, 2.5", ["2.5"]),
        ("sh:nodeKind sh:IRIOrLiteral", "1, :x, []", [""]),
        ("sh:minCount 0", "1", []),
        ("sh:qualifiedMinCount 0 ; sh:qualifiedValueShape [ sh:nodeKind sh:IRI ]", "1", []),
        ("sh:deactivated true ; sh:maxCount 0", "1", []),
        ("sh:maxCount 0 ; sh:severity sh:Info", "1", [""]),
    ],
)
def test_component_finds_just_these(constraint: str, objects: str, expected: list[str]) -> None:
    """Ill-formed literals are found, and nothing is an error."""
    assert values(constraint, f":a :p {objects} ; :q 2, 3 .") == expected


def test_shape_without_values_for_a_count_is_found() -> None:
    """A node with no value at all has fewer than two."""
    assert values("sh:minCount 2", ":a :q 1 .") == [""]


def test_target_that_is_nowhere_in_the_data_has_itself_as_value_of_a_path_of_no_steps() -> None:
    """SHACL: such a path always has the focus node among its value nodes."""
    shape = ":s sh:targetNode :a ; sh:property [ sh:path [ sh:zeroOrMorePath :p ] ; {} ] ."
    assert not results(shape.format("sh:minCount 1"), ":b :p :c .")
    assert not results(shape.format("sh:hasValue :a"), ":b :p :c .")


def test_property_of_a_property_reports_the_inner_focus_node() -> None:
    """Once for each way that leads there, as in the W3C test property-001."""
    shapes = """:s a sh:NodeShape ; sh:targetSubjectsOf :p ;
        sh:property [ sh:path ( :p :q ) ; sh:property [ sh:path :r ; sh:minCount 1 ] ] ."""
    found = results(shapes, ":a :p :b, :c . :d :p :b . :b :q :x . :c :q :x .")
    assert [each.focus for each in found] == [ex("x")] * 2
    assert {each.constraint.component.rpartition("#")[2] for each in found} == {
        "MinCountConstraintComponent"
    }


def test_class_shape_is_its_own_target() -> None:
    """Through rdfs:subClassOf in the data as well."""
    shapes = ":Joint a rdfs:Class, sh:NodeShape ; sh:property [ sh:path :p ; sh:minCount 1 ] ."
    found = results(shapes, ":Hinge rdfs:subClassOf :Joint . :j a :Hinge . :k a :Joint ; :p 1 .")
    assert [each.focus for each in found] == [ex("j")]


def test_shapes_may_refer_to_other_files() -> None:
    """The node shape of one file is used by the target of another."""
    target = (
        ":s sh:targetSubjectsOf :p ; sh:node :t .",
        ":t sh:property [ sh:path :q ; sh:minCount 1 ] .",
    )
    files = [(f"{at}.ttl", PREFIXES + text) for at, text in enumerate(target)]
    store = Store()
    store.load([document(":a :p 1 . :b :p 1 ; :q 1 .")])
    assert [each.focus for each in check(store, compile_shapes(files))] == [ex("a")]


@pytest.mark.parametrize(
    ("constraint", "reason"),
    [
        ("sh:node :s", "refers to itself"),
        ("sh:property [ sh:path :p ; sh:node [ sh:not :s ] ]", "refers to itself"),
        ("sh:property :t", "refers to itself"),
        ("sh:datatype xsd:byte", "does not keep"),
        ("sh:in ( []  )", "blank node"),
        ("sh:hasValue '1'^^xsd:long", "does not keep"),
        ("sh:pattern '(?=a)'", "regular expression"),
        ("sh:target [ a sh:SPARQLTarget ] ; sh:nodeKind sh:IRI", "not part of SHACL"),
    ],
)
def test_what_is_not_covered_is_deferred(constraint: str, reason: str) -> None:
    """With a reason, and without a query."""
    found = compiled(
        f":s a sh:NodeShape ; sh:targetNode :a ; {constraint} . :t sh:path :p ; sh:property :t ."
    )
    deferred = [each for each in found if each.deferred]
    assert deferred
    assert all(reason in (each.deferred or "") and not each.select for each in deferred)
    store = Store()
    assert not list(check(store, deferred))


@pytest.mark.parametrize(
    ("shape", "cause"),
    [
        ("sh:property [ sh:path :p ; sh:minCount 'one' ]", "sh:minCount is not an xsd:integer"),
        ("sh:minCount 1", "a node shape cannot have sh:minCount"),
        ("sh:property [ sh:minCount 1 ]", "needs a sh:path"),
        ("sh:property [ sh:path [] ]", "not a property path"),
        ("sh:property [ sh:path ( :p ) ]", "two members"),
        ("sh:in :nowhere", "not a well-formed list"),
        ("sh:nodeKind :Thing", "is not a node kind"),
        ("sh:datatype xsd:int, xsd:string", "2 values"),
        ("sh:node 'text'", "a literal is not a shape"),
        ("sh:js []", "scripts are not run"),
    ],
)
def test_ill_formed_shape_is_refused(shape: str, cause: str) -> None:
    """Naming the file, the shape and the cause."""
    with pytest.raises(RuleInvalid) as error:
        compiled(f":s sh:targetNode :a ; {shape} .")
    assert "shapes.ttl: " in str(error.value)
    assert cause in str(error.value)


def test_path_that_contains_itself_is_refused() -> None:
    """Blank nodes can do that."""
    with pytest.raises(RuleInvalid, match="contains itself"):
        compiled(":s sh:targetNode :a ; sh:property [ sh:path _:x ] . _:x sh:inversePath _:x .")


def test_file_that_is_no_turtle_is_refused_with_its_line() -> None:
    """Lines count from one."""
    with pytest.raises(RuleInvalid, match=r"shapes\.ttl:2: "):
        compile_shapes([("shapes.ttl", "\n:a :b .")])
