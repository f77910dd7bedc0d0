"""In public robots, the text at the place of a lifted value is that value, as formats read it."""

from __future__ import annotations

from collections.abc import Iterator
from html import unescape

import pytest
from data import locate_data

from kinlint.configuration.settings import Settings
from kinlint.document import FROM, Document
from kinlint.engine.lifting import lift
from kinlint.engine.provenance import Provenance, Written
from kinlint.engine.store import Store
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import (
    NUMERIC,
    RDF_TYPE,
    Term,
    Triple,
    is_literal,
    literal_datatype,
    literal_value,
)

pytestmark = pytest.mark.corpus

SUFFIXES = {
    "urdf": (".urdf",),
    "sdf": (".sdf", ".world"),
    "xacro": (".xacro",),
}
CONSTANT = {"0", "1", "xyz"}
"""What queries state of their own: nothing, one of something, and the order of angles."""
COMPOSED = ("parent-", "placed-")
"""How the properties begin that readers of SDF compose of several poses."""
ATTRIBUTES = {
    ("JointPositionLimit", "lower"): "lower",
    ("JointPositionLimit", "upper"): "upper",
    ("ActuatorForceLimit", "upper"): "effort",
    ("ActuatorVelocityLimit", "upper"): "velocity",
    ("ActuatorAccelerationLimit", "upper"): "acceleration",
    ("JointCoupling", "multiplier"): "multiplier",
    ("JointCoupling", "offset"): "offset",
    ("MassScalar", "mass"): "value",
    **{("MomentOfInertiaXYZ", name): name for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")},
    **{("VectorXYZ", "xyz"[i]): f"xyz-{i + 1}" for i in range(3)},
    **{("EulerAngles", name): f"rpy-{i}" for i, name in enumerate(("alpha", "beta", "gamma"), 1)},
    **{("Quaternion", f"q{'xyzw'[i]}"): f"quat_xyzw-{i + 1}" for i in range(4)},
    **{(kind, "radius"): "radius" for kind in ("Sphere", "Cylinder", "Capsule")},
    **{(kind, "length"): "length" for kind in ("Cylinder", "Capsule")},
}
"""The attributes of URDF that have the values of the properties of a class."""


def documents(form: str) -> Iterator[Document]:
    """Yield the files of a format that can be read."""
    folder = locate_data("robots", form)
    for path in sorted(each for each in folder.rglob("*") if each.suffix in SUFFIXES[form]):
        yield read(decode(str(path), path.read_bytes()), ReadOptions.from_settings(Settings()))


def local(term: Term) -> str:
    return term.rpartition("#")[2][:-1]


def shown(written: Written) -> str:
    """Return the text at the place of a triple."""
    location = written.document.location(written.document.map.triples[written.triple])
    return unescape(location.source[location.span])


def says(text: str, value: Term) -> bool:
    """Whether *text* is *value*, as XML formats read it; what xacro computes is not looked into."""
    if "${" in text or "$(" in text:
        return True
    if literal_datatype(value) in NUMERIC:
        return float(text) == float(literal_value(value))
    return text.strip() == literal_value(value).strip()


def negative(value: Term) -> Term:
    return value.replace('"', '"-', 1) if value[1] != "-" else value.replace('"-', '"', 1)


class Lifted:
    """What was lifted of one document."""

    def __init__(self, document: Document) -> None:
        store = Store()
        store.load([document])
        lift(store)
        self.document, self.store, self.provenance = document, store, Provenance(store)
        self.triples: list[Triple] = list(store.lifted())
        self.types: dict[Term, set[str]] = {}
        for subject, predicate, value in self.triples:
            if predicate == RDF_TYPE:
                self.types.setdefault(subject, set()).add(local(value))

    def check(self) -> None:
        """Fail where a value leads to a text that does not say it, or to one of another value."""
        taken: dict[tuple[Term, Term, Term], Term] = {}
        for triple in self.triples:
            subject, predicate, value = triple
            if not is_literal(value):
                continue
            trace = self.provenance.trace(triple)
            where = f"{self.document.source.name}: {triple}"
            if not trace.written:
                self._is_left_out(triple, where)
            for each in trace.written:
                assert says(shown(each), each.triple[2]), where
            if trace.sign and len(trace.written) == 1:
                (written,) = trace.written
                assert says(shown(written), value if trace.sign > 0 else negative(value)), where
                key = (subject, *written.triple[:2])
                assert taken.setdefault(key, predicate) == predicate, where
                self._is_called_so(written.triple, subject, predicate, where)

    def _is_left_out(self, triple: Triple, where: str) -> None:
        """What is written nowhere is a constant of a query, and its element has a place.

        Or the reader worked it out from the poses of other frames than those that it joins.
        """
        subject, _, value = triple
        elements = list(self.store.values(subject, FROM))
        composed = any(
            said == value and local(way).startswith(COMPOSED)
            for element in elements
            for way, said in self.store.predicate_objects(element)
        )
        assert composed or literal_value(value) in CONSTANT, where
        for element in elements:
            assert element in self.document.map.nodes, where

    def _is_called_so(self, written: Triple, subject: Term, predicate: Term, where: str) -> None:
        """The attribute of URDF is that of the table."""
        for kind in self.types.get(subject, ()) if self.document.format.lifted_as == "urdf" else ():
            wanted = ATTRIBUTES.get((kind, local(predicate)))
            assert wanted in (None, local(written[1])), where


@pytest.mark.parametrize("form", SUFFIXES)
def test_the_text_at_the_place_of_a_lifted_value_is_that_value(form: str) -> None:
    """Of each value of each public robot; what is worked out leads to numbers that are there."""
    count = 0
    for document in documents(form):
        lifted = Lifted(document)
        lifted.check()
        count += len(lifted.triples)
    assert count, f"nothing was lifted of any file of {form}"
