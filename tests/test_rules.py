"""Every rule keeps the promises its own file makes."""

from dataclasses import replace
from pathlib import Path

import pytest
from support.linting import book

from kinlint import resources
from kinlint.catalogue import rulebook
from kinlint.catalogue.rule_file import read_rules
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.errors import RuleInvalid
from kinlint.rule_testing import example_texts, rule_conformance
from kinlint.rule_testing.mutants import mutants
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens
from kinlint.terms import RDF

BOOK = book()

USERS = """
@prefix fact: <https://w3id.org/kinlint/fact#> .
@prefix kc:   <https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .

rule:space-in-identifier a kl:Rule, sh:NodeShape ;
    kl:code "ID900" ;
    rdfs:label "space in an identifier" ;
    rdfs:comment '''Simulators allow no spaces in names, and rewrite them.
        A script asks for the old ones in vain.''' ;
    kl:since "0.1.0" ; kl:format "jsonld" ; rdfs:seeAlso <https://www.rfc-editor.org/rfc/rfc3987> ;
    sh:severity sh:Warning ;
    sh:targetClass kc:Joint ;
    sh:sparql [
        sh:message "The identifier of joint '{$this}' has a space in it." ;
        sh:prefixes kl:prefixes ;
        sh:select '''SELECT $this WHERE { FILTER (CONTAINS(STR($this), "%20")) }''' ] ;
    kl:example [
        kl:bad '''{
            "@context": "https://w3id.org/kinlint/composable.json",
            "@id": [|"https://example.org/arm#left%20elbow"|], "@type": "Joint" }'''^^kl:jsonld ;
        kl:good '''{
            "@context": "https://w3id.org/kinlint/composable.json",
            "@id": "https://example.org/arm#left-elbow", "@type": "Joint" }'''^^kl:jsonld ] .
"""


each_rule = pytest.mark.parametrize("rule", BOOK.rules, ids=lambda rule: rule.name)


@each_rule
def test_a_rule_keeps_its_promises(rule):
    """Bad examples are found where marked, good ones left alone, the file has the right form."""
    assert list(rule_conformance.broken_promises(rule, BOOK)) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    "rule", [each for each in BOOK.rules if each.repairs], ids=lambda rule: rule.name
)
def test_repairs_make_of_bad_examples_what_they_promise(rule):
    assert list(rule_conformance.repair_failures(rule, BOOK)) == []


@pytest.mark.oracle
@each_rule
def test_pyshacl_agrees_with_a_rule_and_each_part_of_it_is_needed(rule):
    """The engines find the same, and an example shows why each part of a query is there."""
    assert list(rule_conformance.nonstandard_queries(rule)) == []
    assert list(rule_conformance.disagreements(rule, BOOK)) == []
    assert list(rule_conformance.untested_parts(rule, BOOK)) == []


def test_every_rule_file_is_one_rule():
    """The catalogue has one rule for each file, called as the file is."""
    files = sorted(resources.data("rules").rglob("*.ttl"))

    assert sorted(Path(rule.path).stem for rule in BOOK.rules) == sorted(f.stem for f in files)


def test_marks_are_taken_out_and_remembered():
    """`[|…|]` marks leave their content, and its place."""
    text, spans = example_texts.unmarked('{"a": [|1|], "b": [[|"x"|]]}')

    assert text == '{"a": 1, "b": ["x"]}'
    assert [text[span.start : span.end] for span in spans] == ["1", '"x"']


@pytest.fixture
def written(tmp_path):
    """Writes a user's rule file, and gives what it promises and does not keep."""
    file = tmp_path / "space-in-identifier.ttl"

    def failures(text):
        file.write_text(text)
        (rule,) = read_rules(file)
        files = (resources.data("shapes") / rulebook.PREFIXES, file)
        constraints = compile_shapes(files)
        book = replace(BOOK, rules=(rule,), constraints=constraints, shapes=files)
        return list(rule_conformance.failures(rule, book))

    return failures


@pytest.mark.parametrize(
    ("path", "others"),
    [
        ("kc:a", []),
        ("kc:a*", ["<kc:a> ?", "<kc:a> +"]),
        ("kc:a/kc:b+", ["<kc:b>"]),
        (
            "(kc:a|kc:b+)*",
            ["( <kc:a> | <kc:b> ) *", "( <kc:a> | <kc:b> + ) ?", "( <kc:a> | <kc:b> + ) +"],
        ),
        ("kc:l/rdf:rest*/rdf:first", []),
    ],
)
def test_a_path_that_repeats_is_tried_with_other_numbers_of_steps(path, others):
    """A path to the members of a list is not: which of them are wrong makes no difference."""
    query = f"PREFIX kc: <kc:> PREFIX rdf: <{RDF}> SELECT $this WHERE {{ $this {path} ?d }}"
    tried = [gone.partition(" and not ")[2] for gone, _ in mutants(parse(tokens(query, {})))]

    assert [" ".join(each.split()[1:-1]) for each in tried if each] == others


@pytest.mark.slow
def test_a_rule_of_a_user_that_is_right_passes(written):
    """What the next tests break is whole."""
    assert written(USERS) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("a space in it.", "a space in it", "does not end in a period"),
        ("'{$this}'", "{$this}", "outside single quotes"),
        ("'{$this}' has", "'{$this}' has '{?none}',", "a variable of the message is empty"),
        ("sh:severity", 'kl:groupBy "none" ; sh:severity', "groups by ?none"),
        ("[|", "", "marks nothing"),
        ("{ FILTER", "{ $this fact:least-momnt 1 FILTER", "line 20: nothing computes fact:least-"),
        ("{ FILTER", "{ $this fact:least-momnt 1 FILTER", "did you mean 'least-moment'?"),
        ("{ FILTER", "{ $this fact:free-name 1 FILTER", "computed for repairs only"),
        ("sh:targetClass kc:Joint", "sh:targetSubjectsOf fact:slip", "line 16: nothing computes"),
        ('"%20"', '"%21"', "is marked and not found"),
        ("#left-elbow", "#left%20elbow", "good example 1 is flagged at 3:"),
        ("^^kl:jsonld", "", "example 1 is in none of the formats jsonld"),
        ('"Joint" }', '"Joint"', "example 1 cannot be read: example.jsonld:"),
        ("rdfs:label", "rdfs:seeAlso", "A rule has one rdfs:label"),
        ("{ FILTER", "{ { } LATERAL { } FILTER", "line 20: not SPARQL 1.1 near '"),
        ("{ FILTER", "{ $this a ?type FILTER", "shows why the query needs ?this rdf:type ?type"),
        ("{ FILTER", "{ $this kc:between* ?any FILTER", "and not ?this kc:between ? ?any"),
        ("{ FILTER", "{ FILTER (isIRI($this)) FILTER", "needs FILTER ( isIRI ( ?this ) )"),
        ("SELECT $this WHERE {", "SELECT $this WHERE { OPTIONAL { $this a kc:Joint }", "kc:Joint"),
    ],
)
def test_what_a_rule_promises_and_does_not_keep_is_said(written, right, wrong, said):
    """Each fault of a rule file is named in a sentence."""
    assert said in " ".join(written(USERS.replace(right, wrong)))


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ('    kl:code "ID900" ;\n', "", "rule space-in-identifier has no kl:code"),
        ("rule:space-in", "rule:spaces-in", "so its file must be spaces-in-identifier.ttl"),
        ('"%20"))', '"%20")', ".ttl:20: '}' stands where ) is due"),
        ("CONTAINS(", "CONTAIN(", ".ttl:20: not SPARQL 1.1 near '"),
        ("FILTER", "$this foo:bar 1 . FILTER", ".ttl:20: the prefix 'foo:' is not declared"),
        ('kl:since "0.1.0" ;', 'kl:since "0.1.0"', ".ttl:14: A dot is expected"),
        ("targetClass kc:", "targetClass zz:", ".ttl:16: The prefix zz: has not been declared"),
    ],
)
def test_what_is_no_rule_is_refused(written, right, wrong, said):
    """A rule file that cannot be used is refused in one line with its cause."""
    with pytest.raises(RuleInvalid) as refusal:
        written(USERS.replace(right, wrong))

    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)
