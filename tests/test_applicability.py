"""Which rules speak of which files."""

from dataclasses import replace

import pytest
from support.linting import book

from kinlint.catalogue.applicability import applicability, applicable, applies, axioms_for, formats
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.engine.constraint import Constraint
from kinlint.engine.result import Result
from kinlint.formats.records import BY_NAME
from kinlint.terms import iri
from kinlint.text import SourceText, Span

BOOK = book()
RULE = BOOK.rules[0]


def document(form, *nodes):
    name = f"arm.{form}"
    spans = {node: NodeSpans(Span(0, 0)) for node in nodes}
    graph = iri(f"urn:kinlint:document:{name}")
    return Document(SourceText(name, ""), graph, (), SourceMap(nodes=spans), format=BY_NAME[form])


def constraint(*named):
    return Constraint("urn:x:r", "<urn:x:s>", "", "", formats=named)


@pytest.mark.parametrize(
    ("named", "form", "expected"),
    [
        ((), "sdf", True),
        ((), "turtle", True),
        (("jsonld",), "turtle", True),
        (("turtle",), "jsonld", True),
        (("jsonld",), "urdf", False),
        (("urdf",), "jsonld", False),
        (("urdf",), "xacro", True),
        (("xacro",), "urdf", False),
        (("urdf", "jsonld"), "srdf", False),
    ],
)
def test_a_rule_speaks_of_the_formats_that_it_names(named, form, expected):
    """Of all if it names none; expanded xacro is URDF, and composable models are alike."""
    rule = replace(RULE, iri="urn:x:r", formats=named)
    owners = applicability([rule], [document(form)])

    assert owners == ({"urn:x:r": {BY_NAME[form]}} if expected else {})


def test_a_constraint_may_name_fewer_formats_than_its_rule():
    """It is left out of runs in which its rule speaks of others alone."""
    every, lifted, xacro = constraint(), constraint("urdf"), constraint("xacro")
    given = [every, lifted, xacro]

    assert applicable(given, {"urn:x:r": frozenset({BY_NAME["urdf"]})}) == [every, lifted]
    assert applicable(given, {"urn:x:r": frozenset({BY_NAME["xacro"]})}) == given
    assert applicable(given, {"urn:x:r": frozenset({BY_NAME["jsonld"]})}) == [every]
    assert applicable(given, {}) == []


def test_results_about_files_of_other_formats_are_dropped():
    """Where a file is known, by address or because the node is described there."""
    documents = [document("urdf", "_:lost"), document("sdf", "_:gone")]
    owners = {"urn:x:r": frozenset({BY_NAME["urdf"]})}
    foci = [
        *("<urn:kinlint:document:arm.urdf#link/a>", "<urn:kinlint:document:arm.sdf#link/a>"),
        *("_:lost", "_:gone", "<https://example.org/elsewhere>"),
    ]
    kept = applies((Result(constraint(), focus) for focus in foci), documents, owners)

    assert [result.focus for result in kept] == [foci[0], foci[2], foci[4]]
    own = [Result(constraint("sdf"), foci[0]), Result(constraint("urdf"), foci[0])]
    assert list(applies(own, documents, owners)) == own[1:]


def test_a_run_of_one_format_keeps_every_result():
    """There, rules that speak of no file were left out before; so among composable models."""
    results = [Result(constraint(), "_:lost"), Result(constraint(), "<https://example.org/x>")]
    owners = {"urn:x:r": frozenset({"jsonld", "turtle"})}

    for documents in ([document("jsonld")], [document("jsonld"), document("turtle", "_:lost")]):
        assert list(applies(results, documents, owners)) == results


def test_axioms_are_left_out_only_where_every_file_is_lifted():
    """What people write may lack anything, and be anything."""
    axioms = BOOK.axioms

    assert axioms_for([document("urdf"), document("jsonld")], axioms, frozenset()) == axioms
    assert axioms_for([document("urdf")], axioms, None) == axioms
    assert len(axioms_for([document("xacro")], axioms, frozenset())) < len(axioms)


def test_texts_have_the_format_that_they_are_read_as():
    """Each piece of an expanded file that of the robot."""
    main, macro = SourceText("a.xacro", ""), SourceText("b.xacro", "")
    made = replace(document("xacro"), source=main, pieces=((0, main), (9, macro)))

    assert formats([made, document("sdf")]) == {
        "a.xacro": "urdf",
        "b.xacro": "urdf",
        "arm.sdf": "sdf",
    }
