"""Lifted values lead to the attributes and texts that they were made of."""

from __future__ import annotations

import pytest

from kinlint.configuration.settings import Settings
from kinlint.engine.lifting import lift
from kinlint.engine.provenance import Provenance
from kinlint.engine.store import Store
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.terms import RDF, Term, iri, literal, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import KIN, METAMODELS

COORD = f"{METAMODELS}geometry/coordinates#"
CHAIN = f"{METAMODELS}kinematic-chain/structural-entities#"

URDF = """<robot name="arm">
  <link name="base"/>
  <link name="lower arm">
    <collision><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="lower arm"/>
    <origin xyz="1 1 1" rpy="1 1 1"/>
    <limit lower="1" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="wrist" type="revolute">
    <parent link="lower arm"/>
    <child link="base"/>
    <mimic joint="elbow" multiplier="1"/>
  </joint>
</robot>
"""

SDF = """<sdf version="1.11">
  <model name="arm">
    <link name="base"/>
    <link name="hand"><pose degrees="true">1 1 1 1 1 1</pose></link>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>hand</child>
      <axis><xyz>0 0 2</xyz></axis>
    </joint>
    <joint name="wrist" type="revolute">
      <parent>hand</parent>
      <child>base</child>
      <axis>
        <xyz>1 1 1</xyz>
        <mimic joint="elbow">
          <multiplier>3</multiplier><offset>3</offset><reference>3</reference>
        </mimic>
      </axis>
    </joint>
    <joint name="screw" type="screw">
      <parent>base</parent>
      <child>hand</child>
      <thread_pitch>3</thread_pitch>
    </joint>
    <joint name="gears" type="gearbox">
      <parent>base</parent>
      <child>hand</child>
      <gearbox_reference_body>base</gearbox_reference_body>
      <gearbox_ratio>3</gearbox_ratio>
    </joint>
  </model>
</sdf>
"""


class Model:
    """A robot that is lifted, and where its values come from."""

    def __init__(self, name: str, text: str) -> None:
        document = read(SourceText(name, text), ReadOptions.from_settings(Settings()))
        self.text, self.document, self.store = text, document, Store()
        self.store.load([document])
        lift(self.store)
        self.provenance = Provenance(self.store)

    def node(self, path: str) -> Term:
        return iri(f"urn:kinlint:document:{self.document.source.name}#{path}")

    def origins(self, path: str, property_: str) -> list[tuple[str, str, str]]:
        """Return elements, attributes and texts of the values of *property_*."""
        trace = self.provenance.property(self.node(path), iri(property_))
        return [
            (s.rpartition("#")[2][:-1], p.rpartition("#")[2][:-1], self._shown((s, p, o)))
            for _, (s, p, o) in trace.written
        ]

    def _shown(self, triple: tuple[Term, Term, Term]) -> str:
        span = self.document.map.triples[triple]
        return self.text[span.start : span.end]


@pytest.fixture(scope="module")
def urdf() -> Model:
    return Model("arm.urdf", URDF)


@pytest.fixture(scope="module")
def sdf() -> Model:
    return Model("arm.sdf", SDF)


@pytest.mark.parametrize(
    ("path", "property_", "attribute"),
    [
        ("position-limit", f"{KIN}lower", "lower"),
        ("position-limit", f"{KIN}upper", "upper"),
        ("force-limit", f"{KIN}upper", "effort"),
        ("velocity-limit", f"{KIN}upper", "velocity"),
    ],
)
def test_equal_values_lead_to_their_own_attributes(
    urdf: Model, path: str, property_: str, attribute: str
) -> None:
    """By the pattern that binds them, whatever they are."""
    found = urdf.origins(f"joint/elbow/{path}", property_)

    assert found == [("/joint/elbow/limit", attribute, "1")]


@pytest.mark.parametrize("number", [1, 2, 3])
def test_numbers_of_a_list_lead_to_their_words(urdf: Model, number: int) -> None:
    position, orientation = "joint/elbow/pose/position", "joint/elbow/pose/orientation"
    origin = "/joint/elbow/origin"

    assert urdf.origins(position, COORD + "xyz"[number - 1]) == [(origin, f"xyz-{number}", "1")]
    angle = ("alpha", "beta", "gamma")[number - 1]
    assert urdf.origins(orientation, KIN + angle) == [(origin, f"rpy-{number}", "1")]


def test_members_of_a_lifted_list_lead_to_theirs(urdf: Model) -> None:
    """Each by itself, and the list to all of them."""
    shape = urdf.node("link/lower%20arm/collision")
    ((cell),) = urdf.store.values(shape, iri(f"{KIN}size"))
    sides = []
    for _ in range(3):
        (value,) = urdf.store.values(cell, iri(f"{RDF}first"))
        trace = urdf.provenance.trace((cell, iri(f"{RDF}first"), value))
        sides += [triple[1].rpartition("#")[2] for _, triple in trace.written]
        (cell,) = urdf.store.values(cell, iri(f"{RDF}rest"))

    assert sides == ["size-1>", "size-2>", "size-3>"]
    assert len(urdf.origins("link/lower%20arm/collision", f"{KIN}size")) == len(sides)


def test_what_is_not_written_was_made_of_nothing(urdf: Model) -> None:
    """A default, a unit, and what was never lifted."""
    coupling, offset = "joint/wrist/coupling", iri(f"{KIN}offset")

    assert urdf.origins(coupling, f"{KIN}multiplier") == [("/joint/wrist/mimic", "multiplier", "1")]
    assert [*map(literal_value, urdf.store.values(urdf.node(coupling), offset))] == ["0"]
    assert urdf.origins(coupling, f"{KIN}offset") == []
    assert urdf.origins("joint/wrist/axis", f"{COORD}x") == []
    assert urdf.origins("joint/elbow/position-limit", "http://qudt.org/schema/qudt/unit") == []
    assert not urdf.provenance.trace((urdf.node("x"), iri(f"{KIN}lower"), literal("1"))).written


def test_a_name_is_where_the_name_is_written(urdf: Model) -> None:
    """Of what an address is made of, the elements on the way are not."""
    between = f"{CHAIN}between-attachments"

    assert urdf.origins("joint/wrist/coupling", f"{KIN}leader") == [
        ("/joint/wrist/mimic", "joint", "elbow")
    ]
    assert urdf.origins("joint/elbow", between) == [("/joint/elbow/child", "link", "lower arm")]


def test_what_is_worked_out_leads_to_all_that_enters(sdf: Model) -> None:
    """In queries and by the reader."""
    mimic = "/model/arm/joint/wrist/axis/mimic"
    coupling = "model/arm/joint/wrist/coupling"

    assert sdf.origins(coupling, f"{KIN}multiplier") == [(f"{mimic}/multiplier", "text", "3")]
    assert sdf.origins(coupling, f"{KIN}leader") == [(mimic, "joint", "elbow")]
    assert sdf.origins(coupling, f"{KIN}offset") == [
        (f"{mimic}/{tag}", "text", "3") for tag in ("offset", "multiplier", "reference")
    ]
    axis = [("/model/arm/joint/elbow/axis/xyz", f"text-{i}", "002"[i - 1]) for i in (1, 2, 3)]
    assert sdf.origins("model/arm/joint/elbow/axis", f"{COORD}z") == axis


def test_the_way_back_is_known_where_it_is_simple(urdf: Model, sdf: Model) -> None:
    """Of a value that is written, and of its negative; not of one that is worked out."""
    limit = urdf.node("joint/elbow/force-limit")
    pitch = sdf.node("model/arm/joint/screw/thread-pitch")

    assert urdf.provenance.property(limit, iri(f"{KIN}upper")).sign == 1
    found = sdf.provenance.property(pitch, iri(f"{KIN}advance-per-turn"))
    assert (len(found.written), found.sign) == (1, 0)
