"""New nodes of the lifted model become the elements that lifting reads them from."""

from __future__ import annotations

import pytest
from support.linting import document

from kinlint.edits import Delta, NotExpressible
from kinlint.engine.lifting import lift
from kinlint.engine.provenance import Provenance
from kinlint.engine.store import Store
from kinlint.fixes.placing import place_delta
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import KIN, METAMODELS

CHAIN = f"{METAMODELS}kinematic-chain/structural-entities#"
REL = f"{METAMODELS}geometry/spatial-relations#"
COORD = f"{METAMODELS}geometry/coordinates#"
DYNAMICS = f"{METAMODELS}newtonian-rigid-body-dynamics/"

URDF = """<robot name="arm">
  <link name="base"/>
  <link name="hand">{}</link>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="hand"/>{}</joint>
</robot>
"""
SDF = """<sdf version="1.9"><model name="arm">
  <link name="base"/>
  <link name="hand">{}</link>
  <joint name="elbow" type="revolute"><parent>base</parent><child>hand</child>{}</joint>
</model></sdf>
"""


def number(value: float) -> Term:
    return literal(str(value), f"{XSD}decimal")


def axis(joint: Term) -> list[Triple]:
    """Return what says that *joint* has the axis 0 1 0."""
    return [
        (joint, iri(f"{CHAIN}common-axis"), "_:new0x0xa"),
        ("_:new0x0xa", iri(f"{REL}lines"), "_:new0x0xb"),
        *(("_:new0x0xb", iri(COORD + name), number(int(name == "y"))) for name in "xyz"),
    ]


def mass(body: Term) -> list[Triple]:
    """Return what says that *body* has 2.5 kg."""
    return [
        ("_:new1x0xm", iri(f"{DYNAMICS}coordinates#of-inertia"), "_:new1x0xi"),
        ("_:new1x0xm", iri(f"{DYNAMICS}coordinates#mass"), number(2.5)),
        ("_:new1x0xi", iri(f"{DYNAMICS}structural-entities#of-body"), body),
    ]


def spelled(text: str, name: str, *added: Triple) -> list[str]:
    """Return what *added* is as statements of a file, by local names."""
    home = document(text, name)
    store = Store()
    store.load([home])
    lift(store)
    (delta,) = place_delta(Provenance(store), Delta((), added), home).deltas.values()
    assert not delta.removed
    return [" ".join(map(_short, triple)) for triple in delta.added]


def _short(term: Term) -> str:
    return term if term[0] in '_"' else term.rpartition("#")[2][:-1]


def node(name: str, path: str) -> Term:
    return iri(f"urn:kinlint:document:{name}#{path}")


def test_elements_are_made_as_far_as_they_are_missing() -> None:
    """And an attribute of several numbers is written as one."""
    joint = node("arm.urdf", "joint/elbow")

    made = spelled(URDF.format("", ""), "arm.urdf", *axis(joint))
    assert made == ["/joint/elbow axis _:new0x0xae0", '_:new0x0xae0 xyz "0 1 0"']
    made = spelled(URDF.format("", "<axis/>"), "arm.urdf", *axis(joint))
    assert made == ['/joint/elbow/axis xyz "0 1 0"']


def test_a_format_has_the_elements_that_its_own_queries_read() -> None:
    """The same repair is an attribute in one and the text of an element in another."""
    joint, body = (node("arm.sdf", f"model/arm/{each}") for each in ("joint/elbow", "link/hand"))

    made = spelled(SDF.format("", ""), "arm.sdf", *axis(joint))
    assert made == [
        "/model/arm/joint/elbow axis _:new0x0xae0",
        "_:new0x0xae0 xyz _:new0x0xae1",
        '_:new0x0xae1 text "0 1 0"',
    ]
    made = spelled(SDF.format("<inertial/>", ""), "arm.sdf", *mass(body))
    assert made == [
        "/model/arm/link/hand/inertial mass _:new1x0xme1",
        '_:new1x0xme1 text "2.5"^^<http://www.w3.org/2001/XMLSchema#decimal>',
    ]


def test_an_element_stands_for_what_is_lifted_from_it() -> None:
    """So that a repair may begin there, though a joint without a parent has no axis yet."""
    text = '<robot name="arm"><joint name="elbow" type="revolute"/></robot>'

    made = spelled(text, "arm.urdf", *axis(node("arm.urdf", "/joint/elbow")))
    assert made == ["/joint/elbow axis _:new0x0xae0", '_:new0x0xae0 xyz "0 1 0"']


def test_several_insertions_do_not_mix() -> None:
    """Each is written where what it is connected with is."""
    joint, body = (node("arm.urdf", each) for each in ("joint/elbow", "link/hand"))

    made = spelled(URDF.format("", ""), "arm.urdf", *axis(joint), *mass(body))
    assert [each.split()[0] for each in made] == [
        "/joint/elbow",
        "_:new0x0xae0",
        "/link/hand",
        "_:new1x0xme0",
        "_:new1x0xme1",
    ]


@pytest.mark.parametrize(
    ("inside", "added"),
    [
        ('<axis xyz="1 0 0"/>', axis(node("arm.urdf", "joint/elbow"))),
        ("", axis(node("arm.urdf", "joint/elbow"))[1:]),
        ("", axis(node("arm.urdf", "joint/elbow"))[:2]),
        ("", [("_:new0x0xa", iri(f"{KIN}of-joint"), node("arm.urdf", "joint/elbow"))]),
        ("", axis(node("arm.urdf", "link/hand"))),
    ],
    ids=["written already", "no anchor", "no value", "no word", "of something else"],
)
def test_what_no_element_says_is_refused(inside: str, added: list[Triple]) -> None:
    with pytest.raises(NotExpressible):
        spelled(URDF.format("", inside), "arm.urdf", *added)
