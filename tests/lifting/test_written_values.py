"""In public robots, the text at the place of a lifted value is that value, as formats read it."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from html import unescape

import pytest
from data import locate_data

from kinlint.addresses import document_of
from kinlint.configuration.settings import Settings
from kinlint.document import FROM, Document
from kinlint.engine.lifting import lift
from kinlint.engine.provenance import Provenance, Written
from kinlint.engine.store import Store
from kinlint.file_format import Format
from kinlint.formats.dependencies.companions import paired_among
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import BY_NAME, TREES
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
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

pytestmark = pytest.mark.corpus

CONSTANT = {"0", "1", "xyz"}
"""What queries state of their own: nothing, one of something, and the order of angles."""
COMPOSED = ("parent-", "placed-", "child-", "centre-", "mass", "i", "size-")
"""How the properties begin that readers compose of several poses, or compute of several shapes."""
EACH = 1 if os.environ.get("KINLINT_EACH_ROBOT") == "1" else 3
"""One public robot of so many is looked at in `MANY`; `KINLINT_EACH_ROBOT=1` looks at all."""
MANY = ("mjcf", "urdf")
UNTOLD = {"mjcf": (".xml",)}
"""Ends of the names of files in the data that tell no format, by format."""
ATTRIBUTES = {
    "urdf": {
        ("JointPositionLimit", "lower"): "lower",
        ("JointPositionLimit", "upper"): "upper",
        ("ActuatorForceLimit", "upper"): "effort",
        ("ActuatorVelocityLimit", "upper"): "velocity",
        ("ActuatorAccelerationLimit", "upper"): "acceleration",
        ("JointCoupling", "multiplier"): "multiplier",
        ("JointCoupling", "offset"): "offset",
        ("MassScalar", "mass"): "value",
        **{
            ("MomentOfInertiaXYZ", name): name
            for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        },
        **{("VectorXYZ", "xyz"[i]): f"xyz-{i + 1}" for i in range(3)},
        **{
            ("EulerAngles", name): f"rpy-{i}"
            for i, name in enumerate(("alpha", "beta", "gamma"), 1)
        },
        **{("Quaternion", f"q{'xyzw'[i]}"): f"quat_xyzw-{i + 1}" for i in range(4)},
        **{(kind, "radius"): "radius" for kind in ("Sphere", "Cylinder", "Capsule")},
        **{(kind, "length"): "length" for kind in ("Cylinder", "Capsule")},
    },
    "srdf": {("JointPosition", "value"): "value-1"},
}
"""The attributes, by format, that have the values of the properties of a class."""


def texts(form: Format) -> Iterator[SourceText]:
    """Yield the files of a format."""
    folder = locate_data("robots", form.name)
    suffixes = UNTOLD.get(form.name, form.suffixes)
    for path in sorted(each for each in folder.rglob("*") if each.suffix in suffixes):
        yield decode(str(path), path.read_bytes())


def models(form: Format) -> Iterator[tuple[Document, ...]]:
    """Yield the files of a format, each with the one that it speaks of, if that is there."""
    own = {each.name: each for each in texts(form)}
    others = {} if form.speaks_of is None else {t.name: t for t in texts(BY_NAME[form.speaks_of])}
    pairings = paired_among([*own.values(), *others.values()]) if others else {}
    for name, text in [*own.items()][:: EACH if form.name in MANY else 1]:
        partner = pairings[name].partner if name in pairings else ""
        files = (text, others[partner]) if partner else (text,)
        options = ReadOptions.from_settings(Settings())
        yield tuple(join_companions([read(each, options) for each in files]))


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
    """What was lifted of the documents of a model; it is called by the name of the first."""

    def __init__(self, documents: Sequence[Document]) -> None:
        store = Store()
        store.load(documents)
        lift(store)
        self.documents, self.store, self.provenance = documents, store, Provenance(store)
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
            where = f"{self.documents[0].source.name}: {triple}"
            if not trace.written:
                self._is_left_out(triple, where)
            for each in trace.written:
                assert says(shown(each), each.triple[2]), where
            if trace.sign and len(trace.written) == 1:
                (written,) = trace.written
                assert says(shown(written), value if trace.sign > 0 else negative(value)), where
                key = (subject, *written.triple[:2])
                assert taken.setdefault(key, predicate) == predicate, where
                self._is_called_so(written, subject, predicate, where)

    def _is_left_out(self, triple: Triple, where: str) -> None:
        """What is written nowhere is a constant of a query, and its element has a place.

        Or the reader worked it out from the poses of other frames than those that it joins.
        """
        subject, _, value = triple
        elements = list(self.store.values(subject, FROM))
        composed = any(
            said == value and way.startswith(f"<{SRC}") and local(way).startswith(COMPOSED)
            for element in elements
            for way, said in self.store.predicate_objects(element)
        )
        assert composed or literal_value(value) in CONSTANT, where
        for element in elements:
            assert any(element in each.map.nodes for each in self.documents), where

    def _is_called_so(self, written: Written, subject: Term, predicate: Term, where: str) -> None:
        """The attribute is that of the table of its format."""
        names = ATTRIBUTES.get(written.document.format.lifted_as, {})
        for kind in self.types.get(subject, ()):
            wanted = names.get((kind, local(predicate)))
            assert wanted in (None, local(written.triple[1])), where


@pytest.mark.parametrize("form", TREES, ids=lambda form: form.name)
def test_the_text_at_the_place_of_a_lifted_value_is_that_value(form: Format) -> None:
    """Of each value of public robots; what is worked out leads to numbers that are there."""
    count = 0
    for documents in models(form):
        lifted = Lifted(documents)
        lifted.check()
        count += sum(_of(documents[0], each) for each in lifted.triples)
    assert count, f"nothing was lifted of any file of {form.name}"


def _of(document: Document, triple: Triple) -> bool:
    """Tell whether *triple* is about a node that is lifted from *document*."""
    return document_of(triple[0]) == document.graph
