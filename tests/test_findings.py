"""What a finding says of the terms it names, and where it says that it is."""

from __future__ import annotations

import pytest
from support.linting import lint

from kinlint.finding import Finding
from kinlint.term_format import LONGEST, TermFormatter
from kinlint.terms import XSD, iri, literal

CONTEXT = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'


def found(*texts: str, code: str) -> list[Finding]:
    report = lint({f"{index}.jsonld": text for index, text in enumerate(texts)})
    return [finding for finding in report.findings if finding.rule.code == code]


@pytest.mark.parametrize(
    ("term", "shown"),
    [
        (literal('a "b"\n\tc'), 'a "b"\\n\\tc'),
        (literal("Arm", language="de"), "Arm"),
        (literal("\N{ROBOT FACE}\u2028\x7f"), "\N{ROBOT FACE}\\u2028\\u007f"),
        (literal("1.0E-1", f"{XSD}double"), "0.1"),
        (literal("12345678901234567890", f"{XSD}integer"), "12345678901234567890"),
        (literal("true", f"{XSD}boolean"), "true"),
        (iri("https://e.org/#arm"), "ex:arm"),
        (iri("https://else.org/"), "https://else.org/"),
        ("_:d1n1", "an anonymous node"),
    ],
)
def test_terms_as_people_read_them(term: str, shown: str) -> None:
    assert TermFormatter({"ex": "https://e.org/#"}).term(term) == shown


@pytest.mark.parametrize(
    ("path", "shown"),
    [
        ("/joint/elbow", "elbow"),
        ("joint/elbow", "elbow"),
        ("/link/upper%20arm/visual/geometry", "upper arm/visual/geometry"),
        ("/model/arm/joint/elbow/axis", "arm/elbow/axis"),
        ("/joint/tool", "joint/tool"),
        ("/link/tool/inertial", "link/tool/inertial"),
        ("link/tool/mass", "link/tool/mass"),
        ("/link/base;2", "link/base;2"),
        ("/material/tool", "material/tool"),
    ],
)
def test_elements_go_by_their_names_where_no_other_has_them(path: str, shown: str) -> None:
    """Else by their kinds too."""
    nodes = ("/joint/elbow", "/joint/tool", "/link/tool", "/link/base", "/link/base;2")
    kinds = ("model", "link", "joint")
    address = "urn:kinlint:document:arm.urdf#{}".format
    display = TermFormatter(nodes=[iri(address(node)) for node in nodes], kinds=kinds)
    assert display.term(iri(address(path))) == shown


def test_of_very_long_terms_both_ends_are_shown() -> None:
    shown = TermFormatter().term(literal("a" * 10_000 + "z"))
    assert len(shown) == LONGEST + 1
    assert shown[0] == "a"
    assert shown[-1] == "z"


def test_a_node_in_several_files_is_where_its_type_is() -> None:
    """What a node lacks is reported where somebody says what it is."""
    mentions = f'{{{CONTEXT}, "@id": "ex:p", "of": "ex:a"}}'
    says = f'{{{CONTEXT}, "@id": "ex:p", "@type": "Position", "with-respect-to": "ex:b"}}'
    typed = f'{{{CONTEXT}, "@id": "ex:q", "@type": "Position", "of": "ex:p"}}'
    more = f'{{{CONTEXT}, "@id": "ex:q", "quantity-kind": "Length"}}'
    assert not found(mentions, says, code="FRM001")
    places = {finding.location.source.name for finding in found(more, typed, code="FRM001")}
    assert places == {"1.jsonld"}


def names(*nodes: str) -> list[str]:
    text = (
        f'{{{CONTEXT}, "@id": "ex:arm", "@type": "KinematicChain", "joints": [{", ".join(nodes)}]}}'
    )
    return [finding.iri for finding in found(text, code="LD007")]


def test_anonymous_nodes_have_names_of_their_own_that_last() -> None:
    """Their names do not change when other things are written elsewhere."""
    joint = '{"@type": "Joint", "between-attachments": []}'
    two = names(joint, joint)
    assert len(set(two)) == 2
    assert all(name.startswith("_:") for name in two)
    assert names(joint, joint, '"ex:elbow"') == two


def test_what_nothing_describes_is_shown_where_it_is_referred_to() -> None:
    """A point on two bodies that no file describes is found in the first that lists it."""
    body = '{{"@id": "ex:{}", "@type": "RigidBody", "simplices": ["ex:p"]}}'
    text = f'{{{CONTEXT}, "@graph": [{body.format("base")}, {body.format("arm")}]}}'

    (finding,) = found(text, code="TOP011")

    assert finding.location.span.start == text.index('"ex:p"')
