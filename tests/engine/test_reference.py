from __future__ import annotations

import logging
import subprocess
import sys
import warnings

import pytest
from turtle_document import PREFIXES, document, ex, triples

from kinlint import resources
from kinlint.document import Document
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check as engine_check
from kinlint.engine.reference.owl import owlrl_closure
from kinlint.engine.reference.rdflib_terms import graph, node, term
from kinlint.engine.reference.shacl import check, check_deferred, check_store
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.terms import RDF_TYPE, XSD, literal
from kinlint.vocabulary import SH

SHAPES = """
    @prefix kl: <https://w3id.org/kinlint/ns#> .
    kl:prefixes sh:declare [ sh:prefix "e" ; sh:namespace "https://example.org/"^^xsd:anyURI ] .
    :rule a kl:Rule, sh:NodeShape ;
        sh:targetClass :Joint ;
        sh:severity sh:Warning ;
        sh:property [ sh:path :mass ; sh:minExclusive 0 ; sh:message "Too light." ] ;
        sh:sparql [
            sh:message "Lower '{?value}' is above '{?upper}'." ;
            sh:prefixes kl:prefixes ;
            sh:select '''SELECT $this (e:lower AS ?path) ?value ?upper WHERE {
                $this e:lower ?value ; e:upper ?upper FILTER (?value > ?upper) }''' ] .
"""
MODEL = ":j a :Joint ; :lower 3 ; :upper 2.50 . _:k a :Joint ; :mass -1.50 ."


def shapes(turtle: str = SHAPES) -> list[tuple[str, str]]:
    return [("shapes.ttl", PREFIXES + turtle)]


def judged(model: str = MODEL, turtle: str = SHAPES) -> list[Result]:
    found = check_store(stored(document(model)), shapes(turtle))
    return sorted(found, key=lambda result: result.constraint.component)


def test_an_ill_typed_literal_is_passed_on_in_silence(caplog):
    """rdflib would log a traceback."""
    text = literal("0.3 m, as it was measured", f"{XSD}double")

    assert term(node(text)) == text
    assert not caplog.records


def test_results_have_the_terms_of_the_document():
    """Blank nodes keep their labels and literals their spelling, so that they can be located."""
    source = document(MODEL)
    (blank,) = {s for s, _, _ in source.statements if s.startswith("_:")}
    mass = literal("-1.50", f"{XSD}decimal")

    light, swapped = sorted(check([source], shapes()), key=lambda each: each.constraint.component)

    assert (light.focus, light.path, light.value) == (blank, ex("mass"), mass)
    assert (blank, ex("mass"), mass) in source.map.triples
    assert (swapped.focus, swapped.path) == (ex("j"), ex("lower"))
    assert swapped.value == literal("3", f"{XSD}integer")


def test_results_know_their_rule_and_what_messages_name():
    """The shape inside a rule belongs to the rule; templates are filled in elsewhere."""
    light, swapped = judged()

    assert light.constraint.owner == swapped.constraint.owner == "https://example.org/rule"
    assert light.constraint.component == f"{SH}MinExclusiveConstraintComponent"
    assert light.constraint.messages == ("Too light.",)
    assert light.constraint.path == ex("mass")
    assert light.constraint.shape.startswith("_:")
    assert swapped.constraint.severity == f"{SH}Warning"
    assert swapped.constraint.messages == ("Lower '{?value}' is above '{?upper}'.",)
    assert swapped.bindings["upper"] == literal("2.50", f"{XSD}decimal")
    assert swapped.bindings["this"] == ex("j")


def test_inner_results_are_no_results():
    """What a referenced shape finds counts for the shape that refers to it."""
    turtle = """
        :s a sh:NodeShape ; sh:targetClass :A ;
            sh:node [ sh:property [ sh:path :p ; sh:minCount 1 ] ] ."""

    (result,) = judged(":a a :A .", turtle)

    assert result.constraint.component == f"{SH}NodeConstraintComponent"
    assert result.constraint.owner == "https://example.org/s"
    assert result.path is None


def test_a_longer_path_is_none():
    """Only a predicate can be located."""
    turtle = ":s sh:targetClass :A ; sh:property [ sh:path ( :p :q ) ; sh:minCount 1 ] ."

    (result,) = judged(":a a :A .", turtle)

    assert (result.path, result.constraint.path) == (None, None)


def test_prefixes_of_files_do_not_leak_into_queries():
    """A query that names an undeclared prefix is refused, as by any other SHACL engine."""
    with pytest.raises(RuleInvalid, match="pySHACL cannot run these shapes"):
        judged(turtle=SHAPES.replace('sh:prefix "e"', 'sh:prefix "f"'))


def test_what_shacl_forbids_is_refused():
    """MINUS is not defined under pre-binding."""
    with pytest.raises(RuleInvalid, match="MINUS"):
        judged(turtle=SHAPES.replace("FILTER (?value > ?upper)", "MINUS { ?value e:p ?upper }"))


def test_nothing_to_group_gives_no_group():
    """rdflib joins the focus node with an empty group, which SPARQL does not know."""
    group = "{ SELECT $this (COUNT(?x) AS ?n) WHERE { $this e:none ?x } GROUP BY $this }"

    assert len(judged(turtle=SHAPES)) == 2
    assert len(judged(turtle=SHAPES.replace("FILTER (?value > ?upper)", group))) == 1


def test_shapes_see_what_follows(tmp_path):
    """A target may be met by inference alone."""
    ontology = tmp_path / "ontology.ttl"
    ontology.write_text(PREFIXES + ":attachment rdfs:domain :Joint .")
    model = document(":j :attachment :a ; :lower 3 ; :upper 2 .")

    assert len(check([model], shapes(), [ontology])) == 1
    assert check([model], shapes()) == []


def test_shapes_see_what_was_computed():
    """Facts are data like any other."""
    model = document(":j :lower 3 ; :upper 2 .")

    assert len(check([model], shapes(), computed=[(ex("j"), RDF_TYPE, ex("Joint"))])) == 1


def test_several_documents_are_one_graph():
    """Limits in one file and the joint in another are judged together."""
    one, two = document(":j a :Joint .", "one"), document(":j :lower 3 ; :upper 2 .", "two")

    assert len(check([one, two], shapes())) == 1


def stored(source: Document) -> Store:
    store = Store()
    store.load([source])
    return store


def test_results_belong_to_the_compiled_constraints_they_mean():
    """Both engines report the same constraints, so that whatever is said of one holds of both."""
    swapped = judged()[1].constraint
    compiled = Constraint(
        **{name: getattr(swapped, name) for name in ("owner", "shape", "component", "messages")},
        severity=f"{SH}Info",
        select="SELECT ...",
    )

    found = check_store(stored(document(MODEL)), shapes(), [compiled])

    assert sorted(result.constraint is compiled for result in found) == [False, True]


def test_only_deferred_constraints_are_judged_for_the_default_engine():
    """The rest it judges itself."""
    _, swapped = judged()
    meant = swapped.constraint
    compiled = Constraint("r", meant.shape, meant.component, "", deferred="LIMIT")

    (found,) = check_deferred(stored(document(MODEL)), shapes(), [compiled])

    assert found.constraint is compiled
    assert check_deferred(stored(document(MODEL)), shapes(), []) == []


def test_advanced_targets_are_understood():
    """What the compiler defers, the deputy must run."""
    turtle = """
        :p sh:declare [ sh:prefix "e" ; sh:namespace "https://example.org/"^^xsd:anyURI ] .
        :s a sh:NodeShape ; sh:property [ sh:path :p ; sh:minCount 1 ] ;
            sh:target [ a sh:SPARQLTarget ; sh:prefixes :p ;
                sh:select "SELECT ?this WHERE { ?this e:lower ?x }" ] ."""

    assert [result.focus for result in judged(MODEL, turtle)] == [ex("j")]


def test_everything_is_left_as_it_was():
    """The patches, the recursion limit and logging last as long as a check."""
    limit = sys.getrecursionlimit()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")

        judged(":j a :Joint ; :mass 'none'^^xsd:boolean, 'x'^^xsd:integer .")

    assert caught == []
    assert sys.getrecursionlimit() == limit
    assert logging.root.manager.disable == logging.NOTSET


@pytest.mark.parametrize(
    "token",
    [
        "<https://example.org/a b>",
        "_:b0",
        '"a\\n\\"b\\\\"',
        '"Ellbogen"@de',
        literal("1.570", f"{XSD}double"),
        literal("x", f"{XSD}integer"),
    ],
)
def test_terms_pass_through_rdflib_unchanged(token):
    """Or findings would point nowhere."""
    assert term(node(token)) == token


def test_graphs_know_no_prefix():
    """rdflib offers the prefixes of a graph to queries, which would hide undeclared ones."""
    assert {str(name) for name, _ in graph([]).namespaces()} <= {"", "xml"}


def test_owlrl_is_asked_about_things_only(tmp_path):
    """Half of what owlrl adds is about the schema, equality or literals."""
    ontology = tmp_path / "ontology.ttl"
    ontology.write_text(
        PREFIXES
        + """:A a owl:Class ; rdfs:subClassOf :B, [ owl:onProperty :p ; owl:someValuesFrom :B ] .
             :p a owl:FunctionalProperty ; rdfs:range xsd:decimal . :u a :A ."""
    )

    found = owlrl_closure(triples(":a a :A ; :p 1.0, 1.00, 2.0 ."), [ontology])

    assert found == {(ex("a"), RDF_TYPE, ex("B")), (ex("u"), RDF_TYPE, ex("B"))}


@pytest.mark.slow
def test_a_rule_runs_in_plain_pyshacl(tmp_path):
    """What `kinlint rule --output-format turtle` prints is SHACL that needs nothing of kinlint."""
    printed = [sys.executable, "-m", "kinlint", "rule", "UNI001", "--output-format", "turtle"]
    rule = tmp_path / "rule.ttl"
    rule.write_text(subprocess.run(printed, capture_output=True, text=True, check=True).stdout)
    model = tmp_path / "model.ttl"
    model.write_text(
        "<https://example.org/c> a "
        "<https://comp-rob2b.github.io/metamodels/geometry/coordinates#PoseCoordinate> ; "
        "<https://comp-rob2b.github.io/metamodels/geometry/coordinates#x> 1.0 ."
    )
    ontology = sorted(map(str, (resources.data("shapes") / "ontology").glob("*.ttl")))
    command = [sys.executable, "-m", "pyshacl", "-im", "-s", str(rule), "-i", "rdfs", str(model)]

    done = subprocess.run([*command, *ontology], capture_output=True, text=True, check=False)

    assert done.returncode == 1
    assert "Results (1):" in done.stdout
    assert "https://example.org/c" in done.stdout


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ("isNumeric(?m)", False),
        ("?m > 0 || ?m <= 0", False),
        ("COALESCE(?m * 2 > 0, true)", True),
        ("?nan < 1 || ?nan >= 1", False),
        ("'0.4' < 1 || '0.4' > 1", False),
        ("ROUND(?big) = ?big", True),
        ("ROUND(?infinite) = ?infinite", True),
    ],
)
def test_what_cannot_be_computed_is_an_error(condition, holds):
    """Of the expression, not of the run; and both engines agree on what it is."""
    turtle = f"""
        @prefix kl: <https://w3id.org/kinlint/ns#> .
        kl:prefixes sh:declare [ sh:prefix "e" ; sh:namespace "https://example.org/"^^xsd:anyURI ] .
        :s a sh:NodeShape ; sh:targetClass :Joint ; sh:sparql [
            sh:prefixes kl:prefixes ; sh:select '''
            SELECT $this WHERE {{ $this e:mass ?m ; e:nan ?nan ; e:big ?big ; e:infinite ?infinite
                FILTER ({condition}) }}''' ] ."""
    model = """:j a :Joint ; :mass "0,4"^^xsd:double ; :nan "NaN"^^xsd:double ;
        :big 1e64 ; :infinite "INF"^^xsd:double ."""

    assert [each.focus for each in judged(model, turtle)] == [ex("j")] * holds
    assert len(list(engine_check(stored(document(model)), compile_shapes(shapes(turtle))))) == holds
