"""What rules ask for is at least what they need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import pytest
from support.linting import book
from turtle_document import PREFIXES, ex

from kinlint import resources
from kinlint.catalogue.applicability import applicability, applicable, applies, axioms_for, demand
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.lifting import lift
from kinlint.engine.required_terms import behind, relevant, terms
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import LIFTED
from kinlint.formats.registry import read
from kinlint.missing_files import references
from kinlint.rule import Rule
from kinlint.rule_testing import example_texts
from kinlint.terms import RDF_TYPE, Term

FORMATS = [each.name for each in LIFTED]

pytestmark = pytest.mark.slow

BOOK = book()
OPTIONS = ReadOptions.from_settings(Settings())
JUDGED = {each.owner for each in BOOK.constraints}
LIFTED = [
    rule
    for rule in BOOK.rules
    if rule.iri in JUDGED and any(each.format in FORMATS for each in rule.examples)
]


def compiled(query: str, target: str = "sh:targetSubjectsOf :p") -> Sequence[Constraint]:
    prefixes = (
        "prefixes.ttl",
        f"""{PREFIXES} <https://example.org/> a owl:Ontology ; sh:declare
        [ sh:prefix "" ; sh:namespace "https://example.org/"^^xsd:anyURI ] ,
        [ sh:prefix "urdf" ; sh:namespace "https://w3id.org/kinlint/urdf#"^^xsd:anyURI ] .""",
    )
    constraint = f'sh:sparql [ sh:prefixes <https://example.org/> ; sh:select """{query}""" ]'
    shape = f"""{PREFIXES} @prefix urdf: <https://w3id.org/kinlint/urdf#> .
        :s a sh:NodeShape ; {target} ; {constraint} ."""
    return compile_shapes([prefixes, ("rule.ttl", shape)])


@pytest.mark.parametrize(
    "where",
    [
        "{ $this :q ?x } UNION { $this :r ?x }",
        "OPTIONAL { $this :q ?x } FILTER (!BOUND (?x)) FILTER NOT EXISTS { $this :r ?x }",
        "FILTER NOT EXISTS { $this (:q/:r)* ?x }",
        "{ SELECT $this { $this :q ?x FILTER EXISTS { ?x :r ?y } } }",
        "$this ?path ?x FILTER (?path IN (:q, :r))",
    ],
)
def test_what_stands_anywhere_in_a_query_is_asked_for(where: str) -> None:
    """Also in branches, in what is optional and in what is ruled out; and the target."""
    found = terms(compiled(f"SELECT $this WHERE {{ {where} }}"))
    assert found is not None
    assert found >= {ex("p"), ex("q"), ex("r")}


@pytest.mark.parametrize(
    "where",
    [
        "$this ?path ?x",
        "$this :q ?x ; ?path 1 .",
        "FILTER NOT EXISTS { $this ?path ?x }",
        "{ $this :q ?x } UNION { ?x ?path $this }",
        "OPTIONAL { $this :q ?x . ?x ?path 'left' }",
        "$this ?path ?x FILTER (?path NOT IN (:q, :r))",
        "$this ?path ?x FILTER (!(?path IN (:q, :r)))",
        "$this !:q ?x",
        "FILTER NOT EXISTS { $this !(:q|^:r) ?x }",
    ],
)
def test_a_pattern_of_any_property_asks_for_everything(where: str) -> None:
    """Wherever it stands."""
    assert terms(compiled(f"SELECT $this WHERE {{ {where} }}")) is None


def test_what_is_said_of_elements_is_in_their_file() -> None:
    """So no property of theirs asks for more."""
    query = "SELECT $this WHERE { FILTER NOT EXISTS { ?robot urdf:link $this ; ?kind $this } }"
    assert terms(compiled(query, "sh:targetObjectsOf urdf:link")) is not None


def test_a_target_is_asked_for_unless_the_query_matches_another() -> None:
    """One of several targets that a constraint matches itself stands for all of them."""
    alone = compiled("SELECT $this WHERE { $this :q ?x }")
    assert terms(alone) == {ex("p"), ex("q")}
    several = "sh:targetSubjectsOf :p , :q , :r"
    assert terms(compiled("SELECT $this WHERE { $this :q ?x }", several)) == {ex("q")}
    assert terms(compiled("SELECT $this WHERE { $this :z ?x }", several)) == {
        *map(ex, ("p", "q", "r", "z"))
    }


def test_axioms_are_relevant_through_others() -> None:
    """Of a chain of axioms all are needed for what its end makes, and nothing else is."""
    step = [
        Axiom("", (("?x", ex(one), "?y"),), ("?x", ex(other), "?y"))
        for one, other in ("pq", "qr", "st")
    ]
    kind = Axiom("", (("?x", ex("r"), "?y"),), ("?x", RDF_TYPE, ex("C")))
    assert relevant([*step, kind], frozenset({ex("C")})) == (step[0], step[1], kind)
    assert relevant([*step, kind], frozenset({ex("p")})) == ()


def examples(rule: Rule) -> Iterator[Sequence[Document]]:
    """The models that a rule shows in formats that are lifted, with what is read beside them."""
    for example in rule.examples:
        if example.format in FORMATS:
            for texts in example_texts.texts_of(example):
                yield join_companions([read(each, OPTIONS) for each in texts])


def state(
    documents: Sequence[Document], wanted: frozenset[Term] | None, axioms: Sequence[Axiom]
) -> Store:
    store = Store()
    store.load(documents)
    store.load_vocabulary(BOOK.vocabulary)
    lift(store, wanted, None if wanted is None else behind(BOOK.axioms, wanted))
    close(store, axioms)
    store.state((*facts(store, wanted), *references(documents, OPTIONS.packages_of, wanted)))
    return store


def found(
    store: Store,
    documents: Sequence[Document],
    constraints: Sequence[Constraint],
    owners: dict[str, frozenset[str]],
) -> Counter[tuple[object, ...]]:
    results = applies(check(store, constraints), documents, owners)
    return Counter(
        (
            *(each.constraint.owner, each.constraint.shape, each.constraint.messages),
            *(each.focus, each.path, each.value, *sorted(each.bindings.items())),
        )
        for each in results
    )


@pytest.mark.parametrize("rule", LIFTED, ids=lambda rule: rule.name)
def test_a_rule_alone_finds_what_it_finds_where_everything_is_made(rule: Rule) -> None:
    """Whatever is not lifted, inferred or computed because nothing asks for it is not missed."""
    told = 0
    for documents in examples(rule):
        owners = dict(applicability([rule], documents))
        constraints = applicable(BOOK.constraints, owners)
        wanted = demand(constraints)
        everything = state(documents, None, BOOK.axioms)
        asked_for = state(documents, wanted, axioms_for(documents, BOOK.axioms, wanted))

        expected = found(everything, documents, constraints, owners)

        assert found(asked_for, documents, constraints, owners) == expected
        told += len(expected)
    assert told


def test_no_rule_has_everything_made_of_a_lifted_format() -> None:
    about = {each.iri for each in BOOK.rules if set(each.formats or FORMATS) & set(FORMATS)}
    asking = [each.owner for each in BOOK.constraints if terms([each]) is None]
    assert not about.intersection(asking)


def test_every_lifted_format_has_rules() -> None:
    """Else the test above would show nothing."""
    assert set(FORMATS) <= {each for rule in BOOK.rules for each in rule.formats}
    assert any(resources.data("shapes").glob("lifting/*/*.rq"))
