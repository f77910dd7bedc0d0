"""Robots as links, joints and couplings in trees, which pictures and outlines show."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import PurePath

from kinlint.addresses import element_of, is_address, last_tag
from kinlint.engine.store import Store
from kinlint.facts import inputs
from kinlint.facts.fact_context import FactContext
from kinlint.facts.finding_owners import FindingOwners
from kinlint.facts.joint_numbers import NEEDED
from kinlint.facts.joint_trees import Edge, arrange_joints
from kinlint.facts.mechanism import FRAME, KINDS, ON_BODY, model_of, named
from kinlint.facts.metamodel_terms import attribute, chain, geom, kin
from kinlint.facts.part_names import NAMELESS, PartNames, PartPlaces, element_name
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.robot_groups import RobotGroups
from kinlint.facts.zero_configuration import ZeroConfiguration
from kinlint.finding import Finding
from kinlint.structure import Coupling, Frame, Joint, Link, Structure
from kinlint.terms import Term, iri, literal_value
from kinlint.text import Location
from kinlint.vocabulary import SRC

NAMES = (attribute("name"), iri(f"{SRC}name"))
"""Properties of the element of a robot with its name."""

ASKED = frozenset(
    {
        *(
            *inputs.TREES,
            *inputs.RELATIONS,
            *inputs.PLACED,
            *inputs.RANGES,
            *NEEDED,
            *inputs.AT_ZERO,
            FRAME,
            ON_BODY,
        ),
        *(geom("simplices"), kin("JointCoupling"), kin("TwoAxisJoint")),
        *(chain("between-attachments"), chain("joints"), *(kind for kind, _ in KINDS)),
    }
)
"""Properties and classes that a store has to have for these structures."""


def structures(
    store: Store,
    places: PartPlaces,
    findings: Iterable[Finding] = (),
    *,
    placed: bool = False,
) -> tuple[Structure, ...]:
    """Return the robots that the documents of *store*, which is closed, describe, in text order.

    Each knows which of its parts *findings* are about and, if *placed*, where its parts are with
    all joints at zero. Takes time linear in joints.
    """
    context = FactContext(PredicateIndex(store))
    return Extraction(context, places, findings, placed=placed).structures()


class Extraction:
    """Parts of all robots of the store that *context* computes facts of.

    Unless *located*, they know neither frames nor where anything is described.
    """

    def __init__(
        self,
        context: FactContext,
        places: PartPlaces,
        findings: Iterable[Finding] = (),
        *,
        placed: bool = False,
        located: bool = True,
    ) -> None:
        self.scan = context.scan
        self.findings = findings
        self.mechanism = context.mechanism
        self.numbers = context.joints
        self.locator = places
        self.located = located
        self.names = PartNames(places)
        self.trees = arrange_joints(self.mechanism.bodies, self.mechanism.edges)
        self.roots = frozenset(self.trees.roots)
        self.zero = (
            ZeroConfiguration(
                self.mechanism, context.relations, context.placements, self.trees.edges
            )
            if placed
            else None
        )

    def structures(self) -> tuple[Structure, ...]:
        """Return all robots; each knows its parts that findings are about."""
        robots = RobotGroups(self.scan, self.mechanism, self.trees.edges)
        chains: dict[Term, list[Term]] = {}
        for whole, joints in robots.chains.items():
            for joint in joints:
                chains.setdefault(joint, []).append(whole)
        return tuple(self._structure(bodies, edges, chains) for bodies, edges in robots.groups())

    def _structure(
        self,
        bodies: Sequence[Term],
        edges: Sequence[Edge],
        chains: Mapping[Term, Sequence[Term]],
    ) -> Structure:
        joints = [each.joint for each in edges]
        parts = (*bodies, *joints)
        own = Counter(chain for joint in joints for chain in chains.get(joint, ()))
        names = self.names.names(parts)
        links = tuple(self._link(body, names[body]) for body in bodies)
        made = tuple(self._joint(each, names[each.joint]) for each in edges)
        places = [*(link.location for link in links), *(joint.location for joint in made)]
        roots = [body for body in bodies if body in self.roots]
        whole = self._whole((*roots, *parts), next(iter(own.most_common(1)), None), len(joints))
        return Structure(
            iri=named(whole),
            name=self._title(whole, names),
            links=links,
            joints=made,
            couplings=tuple(each for joint in joints for each in self._couplings(joint)),
            roots=tuple(map(named, roots)),
            files=tuple(dict.fromkeys(place.source.name for place in places if place is not None)),
            location=self._node(whole),
            whole=self._all(whole),
            owners={
                **{each: named(whole) for each in (whole, *own)},
                **{focus: named(part) for part in parts for focus in self._owned.get(part, ())},
            },
        )

    def _whole(self, parts: Sequence[Term], longest: tuple[Term, int] | None, joints: int) -> Term:
        """Return the node for a whole robot.

        Its element, the chain of all its joints, or its first part.
        """
        models = {model_of(part) for part in parts if is_address(part)}
        if models:
            inner = {each for each in models if last_tag(each) == "model"}
            return min(inner or models, key=self.mechanism.place)
        return longest[0] if longest is not None and longest[1] == joints else parts[0]

    def _title(self, whole: Term, names: Mapping[Term, str]) -> str:
        if is_address(whole):
            element = element_of(whole)
            tables = (self.scan.table(each) for each in NAMES)
            if said := [name for table in tables for name in table.values(element)]:
                return literal_value(said[0])
            name = element_name(whole, self.locator.kinds)
            place = self._node(whole)
            return name if name != NAMELESS or place is None else PurePath(place.source.name).stem
        return names.get(whole) or self.names.names((whole,))[whole]

    @cached_property
    def _owned(self) -> Mapping[Term, list[Term]]:
        """Entities that findings are about, by the part that each belongs to."""
        parts = {*self.mechanism.bodies, *self.mechanism.joints}
        owners = FindingOwners(self.scan.store, parts, frozenset(self.mechanism.joints)).owners(
            self.findings
        )
        found: dict[Term, list[Term]] = {}
        for focus, part in owners.items():
            found.setdefault(part, []).append(focus)
        return found

    def _node(self, node: Term) -> Location | None:
        """Return the place where *node* is described."""
        return self.locator.node(node) if self.located else None

    def _all(self, node: Term) -> Location | None:
        """Return all of the description of *node*."""
        return self.locator.whole(node) if self.located else None

    @cached_property
    def _described(self) -> frozenset[Term]:
        return frozenset(self.mechanism.described)

    def _link(self, body: Term, name: str) -> Link:
        frames = self.mechanism.frames.get(body, ()) if self.located else ()
        titles = self.names.names(frames)
        zero = self.zero
        return Link(
            iri=named(body),
            name=name,
            location=self._node(body),
            whole=self._all(body),
            frames=tuple(
                Frame(named(each), titles[each], self._node(each), self._all(each))
                for each in frames
            ),
            absent=body not in self._described,
            point=zero.origin(body) if zero else None,
            centre=zero.centre(body) if zero else None,
        )

    def _joint(self, edge: Edge, name: str) -> Joint:
        joint = edge.joint
        lower, upper = self.numbers.limits.get(joint, (None, None))
        zero = self.zero
        return Joint(
            iri=named(joint),
            name=name,
            kind=self.mechanism.kind(joint),
            parent=edge.parent and named(edge.parent),
            child=edge.child and named(edge.child),
            others=tuple(map(named, edge.others)),
            closes=edge.closes,
            origin=self.numbers.origin(edge),
            axis=self.numbers.axis(joint),
            lower=lower,
            upper=upper,
            point=zero.joint_point(edge) if zero else None,
            end=zero.child_point(edge) if zero else None,
            direction=zero.direction(edge) if zero else None,
            placed=zero is not None and zero.is_stated(joint),
            location=self._node(joint),
            whole=self._all(joint),
        )

    def _couplings(self, joint: Term) -> Iterator[Coupling]:
        for each in self.numbers.gearings.get(joint, ()):
            yield Coupling(
                iri=named(each.node),
                name=named(each.node).rpartition("#")[2],
                leader=named(each.leader),
                follower=named(joint),
                multiplier=each.multiplier,
                offset=each.offset,
                location=self.locator.node(each.node),
                whole=self.locator.whole(each.node),
            )
