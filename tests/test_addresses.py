"""Addresses of documents, elements and what is lifted from them."""

from __future__ import annotations

import pytest

from kinlint import addresses
from kinlint.addresses import owner_path, short_path
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xml.schema import kinds
from kinlint.term_format import TermFormatter
from kinlint.terms import Term, iri
from kinlint.text import SourceText

ARM = "urn:kinlint:document:arm.urdf"
KINDS = ("body", "geom", "link")


def at(path: str) -> Term:
    return iri(f"{ARM}#{path}")


def test_an_address_is_made_of_the_steps_to_an_element() -> None:
    """Of the tag, the quoted name, and the order if the path is taken."""
    body = addresses.child(addresses.root_of(at("")), "body", "upper arm")
    assert body == at("/body/upper%20arm")
    inner = addresses.child_address(body[1:-1], "geom", None)
    assert iri(addresses.repeated_address(inner, 2)) == at("/body/upper%20arm/geom;2")
    assert addresses.sibling(body, "body", "hand") == at("/body/hand")
    assert addresses.sibling(at("joint/elbow"), "link", "hand") == at("link/hand")


def test_what_is_lifted_from_an_element_has_its_path() -> None:
    """The root of a file has one address for both."""
    assert addresses.lifted(at("/body/a/body/b")) == at("body/a/body/b")
    assert addresses.element_of(at("body/a/body/b")) == at("/body/a/body/b")
    assert addresses.lifted(at("")) == addresses.element_of(at("")) == at("")


@pytest.mark.parametrize(
    ("path", "shown", "owner"),
    [
        ("/body/a/body/b", "a/b", "body/a/body/b"),
        ("/body/a/body/b/body/a", "a/b/a", "body/a/body/b/body/a"),
        ("/worldbody/body/a/body/b/geom;2", "worldbody/a/b/geom;2", "worldbody/body/a/body/b"),
        ("/worldbody/body/body/body/geom/inertial", "worldbody/body/geom/inertial", None),
        ("body/a/body/b;2/frame", "a/b;2/frame", "body/a/body/b;2"),
        ("/body", "body", ""),
        ("", "", ""),
    ],
)
def test_elements_nest_in_elements_of_the_same_kind(
    path: str, shown: str, owner: str | None
) -> None:
    """Which steps are names does not follow from where they stand, nor from what they are."""
    assert short_path(path, KINDS) == shown
    if owner is not None:
        assert owner_path(path, KINDS) == owner


def test_nested_bodies_lie_in_each_other() -> None:
    """From the inside out; the root stands for all and is not among them."""
    paths = ("body/a/body/b", "body/a/body", "body/a", "body")
    assert [*addresses.enclosing(at("body/a/body/b"))] == [at(path) for path in paths]
    assert addresses.is_within(at("/body/a/body/b"), at("/body/a"))
    assert not addresses.is_within(at("/body/ab"), at("/body/a"))
    assert addresses.last_tag(at("/body/a/body/b")) == "body"
    assert addresses.local_name(at("/body/a/body/b%2Fc")) == "b/c"


def test_the_first_of_elements_with_one_path_is_not_repeated() -> None:
    """A name may look like an order: it is quoted."""
    assert addresses.is_repeated(at("/body/a;2"))
    assert not addresses.is_repeated(addresses.child(at(""), "body", "a;2"))
    assert not addresses.is_repeated(at("/body/a"))


def test_people_read_an_address_without_its_quotes() -> None:
    """What is lifted is called like the element."""
    assert addresses.readable(f"{ARM}#body/upper%20arm") == "arm.urdf#/body/upper arm"
    assert addresses.readable(ARM) == addresses.readable(f"{ARM}#") == "arm.urdf"


def test_nested_models_are_read_at_the_addresses_made_here() -> None:
    """Models of SDF stand in models."""
    text = (
        '<sdf version="1.9"><model name="a"><model name="b"><link name="c"/></model></model></sdf>'
    )
    document = read(SourceText("a.sdf", text), ReadOptions())
    model = addresses.child(addresses.root_of(document.graph), "model", "a")
    link = addresses.child(addresses.child(model, "model", "b"), "link", "c")
    assert link in document.map.nodes
    assert (
        TermFormatter(nodes=document.map.nodes, kinds=kinds(document.format)).term(link) == "a/b/c"
    )
