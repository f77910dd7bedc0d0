"""Descriptions of robots in files of different formats, and which of them are of one robot."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import PurePosixPath
from typing import TypeAlias

from kinlint.addresses import document_of, local_name
from kinlint.document import Document
from kinlint.facts.connected_components import joined_by
from kinlint.facts.elements_by_tag import robot_elements
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import attribute
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spanning_forest import DisjointSets
from kinlint.formats.records import FORMATS
from kinlint.light_dataclasses import dataclass, field
from kinlint.suggestion import LOOKED_UP
from kinlint.terms import Term, is_iri, literal_value

COMPOSED = "composed"
"""Format of all composable models of a run."""
DESCRIBING = frozenset(each.name for each in FORMATS if each.describes_robots)
"""Names of the formats whose files each describe robots of their own."""
SHARED = 2.0 / 3.0
"""Least share of common joints in two descriptions of one robot.

A variant of a robot with another gripper or base still shares two thirds.
"""


@dataclass
class Description:
    """Parts of a robot by name, as a file, or connected composable models, call them."""

    form: str
    """The name of the file format."""
    path: PurePosixPath = PurePosixPath()
    """The file; empty for composable models, which may be several files."""
    bodies: dict[str, Term] = field(default_factory=dict)
    """Bodies by name."""
    joints: dict[str, Term] = field(default_factory=dict)
    """Joints by name."""
    moving: dict[str, Term] = field(default_factory=dict)
    """Joints that are not fixed, by name."""
    ends: dict[str, frozenset[str]] = field(default_factory=dict)
    """Names of the bodies that each joint joins, by its name; of a joint without two, none."""

    def joined(self, joint: str) -> frozenset[str]:
        """Return the names of the bodies that the joint called *joint* joins."""
        return self.ends.get(joint, frozenset())

    @property
    def stem(self) -> str:
        """The name of the file without any suffix, in lower case."""
        return self.path.name.partition(".")[0].casefold()


Pair: TypeAlias = tuple[Description, Description, str]
"""Two descriptions, and what shows that they are of one robot; empty if only names suggest it."""


class DescriptionPairs:
    """Pairs of descriptions that may be of one robot.

    Both have the same names for the robot, for two thirds of the joints of one of them, and for a
    body that each of these joins: converters lump links behind fixed joints into one. Where several
    files qualify, the one with the same stem counts, then the only one in the folder, then the only
    one at all. Composable models have no name for the robot; of these each connected mechanism is a
    description.
    """

    def __init__(self, scan: PredicateIndex, mechanism: Mechanism) -> None:
        self.scan = scan
        self.mechanism = mechanism

    def pairs(self) -> Iterator[Pair]:
        """Yield each pair once, in the order of the run."""
        named: dict[str, list[Description]] = defaultdict(list)
        for document in self.scan.documents:
            if described := self._in_files.get(document.graph):
                for name in dict.fromkeys(self._names(document)):
                    named[name].append(described)
        for descriptions in named.values():
            yield from _paired(descriptions)
        for composed in self._composed:
            for described in self._in_files.values():
                if _alike(composed, described):
                    yield composed, described, ""

    @cached_property
    def _parts(self) -> Mapping[str, list[Term]]:
        """Joints and bodies of the run that have names."""
        found = {"joints": self.mechanism.joints, "bodies": self.mechanism.described}
        return {kind: list(filter(is_iri, nodes)) for kind, nodes in found.items()}

    @cached_property
    def _in_files(self) -> Mapping[Term, Description]:
        """The description in each document of a format that describes robots, in their order."""
        found = {
            document.graph: Description(
                document.format.name,
                PurePosixPath(document.source.name.replace("\\", "/")),
            )
            for document in self.scan.documents
            if document.format.name in DESCRIBING
        }
        for kind, nodes in self._parts.items():
            for node in nodes:
                if description := found.get(document_of(node)):
                    self._add(description, kind, node)
        return found

    @cached_property
    def _composed(self) -> list[Description]:
        """Connected mechanisms of the composable models."""
        files: Container[Term] = self._in_files
        own = {
            kind: [node for node in nodes if document_of(node) not in files]
            for kind, nodes in self._parts.items()
        }
        groups = DisjointSets()
        for joint in own["joints"]:
            for body in joined_by(self.scan, joint):
                groups.join(joint, body)
        found: dict[Term, Description] = {}
        for kind, nodes in own.items():
            for node in nodes:
                group = groups.representative(node)
                description = found.setdefault(group, Description(COMPOSED))
                self._add(description, kind, node)
        return [description for description in found.values() if description.joints]

    def _add(self, description: Description, kind: str, node: Term) -> None:
        name = local_name(node)
        parts = getattr(description, kind)
        if parts.setdefault(name, node) != node:
            # Nameless parts, such as the welds of MJCF, are called alike; none of them is left out.
            parts[node] = node
        elif kind == "joints":
            bodies = joined_by(self.scan, node)
            if self.mechanism.movement(node) != "fixed":
                description.moving[name] = node
            description.ends[name] = frozenset(map(local_name, bodies))

    @property
    def are_one(self) -> bool:
        """True if the run has two descriptions, so one pair."""
        return len(self._in_files) + len(self._composed) == 2  # noqa: PLR2004

    def unnamed(self) -> Iterator[tuple[Description, Description]]:
        """Yield pairs that may be of one robot by their files alone, of different formats each.

        Those with the same folder and stem, or the only two descriptions of the run.
        """
        if self.are_one:
            groups = [[*self._in_files.values(), *self._composed]]
        else:
            placed: dict[tuple[str, ...], list[Description]] = defaultdict(list)
            for each in self._in_files.values():
                placed[str(each.path.parent), each.stem].append(each)
            groups = [each for each in placed.values() if len(each) <= LOOKED_UP]
        for group in groups:
            for at, one in enumerate(group):
                yield from ((one, other) for other in group[at + 1 :] if other.form != one.form)

    def _names(self, document: Document) -> Iterator[str]:
        """Yield the names of the robots in *document*, in lower case."""
        tables = [self.scan.single(attribute(each)) for each in ("name", "model")]
        for robot in robot_elements(self.scan, document):
            for names in tables:
                if robot in names:
                    yield literal_value(names[robot]).casefold()


def _paired(descriptions: list[Description]) -> Iterator[Pair]:
    """Yield the pairs among *descriptions*, which have one name for the robot."""
    forms = tuple(dict.fromkeys(each.form for each in descriptions))
    if len(forms) < 2:  # noqa: PLR2004
        return
    nearby: dict[tuple[str, ...], list[Description]] = defaultdict(list)
    for each in descriptions:
        for place, _ in _places(each):
            nearby[each.form, *place].append(each)
    places = {id(each): place for place, each in enumerate(descriptions)}
    told: set[tuple[int, int]] = set()
    for one in descriptions:
        for form in forms:
            if form != one.form and (pair := _closest(one, form, nearby)):
                early, late = sorted((places[id(one)], places[id(pair[0])]))
                if (early, late) not in told:
                    told.add((early, late))
                    yield descriptions[early], descriptions[late], pair[1]


def _closest(
    one: Description, form: str, nearby: Mapping[tuple[str, ...], Sequence[Description]]
) -> tuple[Description, str] | None:
    """Return the description in *form* that *one* has to agree with, and what shows that.

    None if there is none, or if there are several.
    """
    for place, evidence in _places(one):
        near = nearby.get((form, *place), ())
        if len(near) > LOOKED_UP:
            return None
        if alike := [each for each in near if _alike(one, each)]:
            return (alike[0], evidence) if len(alike) == 1 else None
    return None


def _places(one: Description) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield where descriptions of the same robot are looked for, with what finding one there shows.

    The nearest comes first.
    """
    named = f"both files are called '{one.stem}'"
    yield ("folder and stem", str(one.path.parent), one.stem), named
    yield ("stem", one.stem), named
    yield ("folder", str(one.path.parent)), ""
    yield ("run",), ""


def _alike(one: Description, other: Description) -> bool:
    """Tell whether most joints of the smaller robot are in the other, on the same bodies."""
    ways = [each.moving or each.joints for each in (one, other)]
    least = min(map(len, ways))
    shared = ways[0].keys() & ways[1].keys()
    if not shared or len(shared) < SHARED * least:
        return False
    joined = [(one.joined(name), other.joined(name)) for name in shared]
    agreeing = [not mine.isdisjoint(yours) for mine, yours in joined if mine and yours]
    return sum(agreeing) >= SHARED * len(agreeing)


def are_several(documents: Iterable[Document]) -> bool:
    """Tell whether *documents* describe robots in two formats or more."""
    return len({_form(document) for document in documents} - {""}) > 1


def _form(document: Document) -> str:
    """Return the format of *document*, one for all composable ones.

    Empty if it describes no robot.
    """
    if document.format.describes_robots:
        return document.format.name
    return "" if document.format.is_tree else COMPOSED
