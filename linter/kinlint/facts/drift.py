"""Differences between files of different formats that describe one robot."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import combinations
from typing import TypeAlias

from kinlint.addresses import document_of, local_name
from kinlint.document import Document
from kinlint.facts.assembly import Assemblies
from kinlint.facts.elements_by_tag import robot_elements
from kinlint.facts.fact_statements import fact, fact_node, numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.joint_numbers import JointNumbers
from kinlint.facts.linear_algebra import Vector, length, subtract
from kinlint.facts.metamodel_terms import attribute, chain, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.records import FORMATS
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_iri, literal, literal_value

COMPOSED = "composed"
"""Format of all composable models of a run, which are one model."""
DESCRIBING = frozenset(each.name for each in FORMATS if each.describes_robots)
"""Names of the formats whose files each describe robots of their own."""
SHARED = 2.0 / 3.0
"""Least share of common joint names in two descriptions of one robot.

A variant of a robot with another gripper or base still shares two thirds.
"""
RELATIVE = 0.01
"""Largest relative difference of two numbers that rounding to two digits explains."""
MILLIMETRE = 1e-3
"""Largest distance in m, or change of a unit vector, that rounding on export explains."""


Difference: TypeAlias = tuple[Term, Term, str, float, float]
"""Two parts, the name of what differs, and both values."""


@dataclass
class Description:
    """Parts of a robot by name, as one file, or all composable models together, call them."""

    form: str
    """The name of the file format."""
    bodies: dict[str, Term] = field(default_factory=dict)
    """Bodies by name."""
    joints: dict[str, Term] = field(default_factory=dict)
    """Joints by name."""


class DescriptionDrifts:
    """Robots of a run that are described more than once."""

    def __init__(
        self,
        scan: PredicateIndex,
        assemblies: Assemblies,
        placements: Placements,
        joints: JointNumbers,
    ) -> None:
        self.scan = scan
        self.joints = joints
        self.assemblies = assemblies
        self.placements = placements

    def facts(self) -> Iterator[Triple]:
        """Yield each difference: the part, the quantity, and both values."""
        forms = {_form(document) for document in self.scan.documents}
        if len(forms - {""}) < 2:  # noqa: PLR2004
            return
        number = 0
        for one, other in self._pairs():
            for at, there, what, mine, yours in self._differences(one, other):
                node = fact_node("drift", number := number + 1)
                yield at, fact("drift"), node
                yield node, fact("from"), there
                yield node, fact("quantity"), literal(what)
                yield from numbers(node, [("here", mine), ("there", yours)])

    @cached_property
    def _described(self) -> Mapping[Term, Description]:
        """Description of a robot in each document."""
        forms = {document.graph: _form(document) for document in self.scan.documents}
        found: dict[Term, Description] = {}
        joints = sorted(filter(is_iri, self.scan.instances(chain("Joint"))))
        bodies = sorted(filter(is_iri, self.assemblies.masses))
        for kind, nodes in (("joints", joints), ("bodies", bodies)):
            for node in nodes:
                home = document_of(node)
                form = forms.get(home, COMPOSED)
                home = home if form in DESCRIBING else COMPOSED
                description = found.setdefault(home, Description(form))
                getattr(description, kind).setdefault(local_name(node), node)
        return found

    def _pairs(self) -> Iterator[tuple[Description, Description]]:
        """Yield the descriptions that are of one robot, in the order of the run."""
        named: dict[str, list[Term]] = defaultdict(list)
        for document in self.scan.documents:
            for name in self._names(document):
                named[name].append(document.graph)
        pairs = [pair for homes in named.values() for pair in combinations(homes, 2)]
        if COMPOSED in self._described:
            pairs += [(COMPOSED, document.graph) for document in self.scan.documents]
        for early, late in dict.fromkeys(pairs):
            one, other = self._described.get(early), self._described.get(late)
            if one and other and one.form != other.form and _alike(one, other):
                yield one, other

    def _names(self, document: Document) -> Iterator[str]:
        """Yield the names of the robots in *document*, in lower case.

        None if it describes no robots.
        """
        if not document.format.describes_robots:
            return
        names = self.scan.single(attribute("name"))
        for robot in robot_elements(self.scan, document):
            if robot in names:
                yield literal_value(names[robot]).casefold()

    def _differences(self, one: Description, other: Description) -> Iterator[Difference]:
        for name in sorted(one.bodies.keys() & other.bodies.keys()):
            yield from self._weights(one.bodies[name], other.bodies[name])
        for name in sorted(one.joints.keys() & other.joints.keys()):
            at, there = one.joints[name], other.joints[name]
            ranges = (self.joints.limits.get(each, (None, None)) for each in (at, there))
            for what, mine, yours in zip(("lower limit", "upper limit"), *ranges, strict=True):
                if mine is not None and yours is not None and _apart(mine, yours):
                    yield at, there, what, mine, yours
            yield from _moved(at, there, "axis", self.placements.axes)
            carriers = [self._carriers.get(each) for each in (at, there)]
            if len({each and local_name(each) for each in carriers}) == 1:
                yield from _moved(at, there, "origin", self.placements.origins)

    def _weights(self, at: Term, there: Term) -> Iterator[Difference]:
        """Yield differences of two bodies that the bodies welded to them do not make up for.

        Converters lump links behind fixed joints into one, as Gazebo does on loading.
        """
        masses, totals = self.assemblies.masses, self.assemblies.totals
        wholes = [totals.get(self.assemblies.assembly(body), 0.0) for body in (at, there)]
        if _apart(masses[at], masses[there]):
            if _apart(wholes[0], wholes[1]):
                yield at, there, "mass in kg", masses[at], masses[there]
        elif not _apart(wholes[0], wholes[1]):
            yield from _moved(at, there, "centre of mass", self.placements.centres)

    @cached_property
    def _carriers(self) -> Mapping[Term, Term]:
        """Body that carries each joint."""
        return self.scan.single(kin("parent-body"))


def _moved(at: Term, there: Term, what: str, known: Mapping[Term, Vector]) -> Iterator[Difference]:
    """Yield the component of a vector that differs most, if by more than `MILLIMETRE`."""
    mine, yours = known.get(at), known.get(there)
    if mine is None or yours is None or length(subtract(mine, yours)) <= MILLIMETRE:
        return
    apart = [abs(a - b) for a, b in zip(mine, yours, strict=True)]
    index = apart.index(max(apart))
    yield at, there, f"{what} along {'xyz'[index]}", mine[index], yours[index]


def _apart(mine: float, yours: float) -> bool:
    return abs(mine - yours) > RELATIVE * max(abs(mine), abs(yours)) + 1e-9


def _alike(one: Description, other: Description) -> bool:
    """Tell whether most joints of the smaller robot have their namesakes in the other."""
    least = min(len(one.joints), len(other.joints))
    shared = len(one.joints.keys() & other.joints.keys())
    return shared > 0 and shared >= SHARED * least


def _form(document: Document) -> str:
    """Return the format of *document*, one for all composable ones.

    Empty if it describes no robot.
    """
    if document.format.describes_robots:
        return document.format.name
    return "" if document.format.is_tree else COMPOSED
