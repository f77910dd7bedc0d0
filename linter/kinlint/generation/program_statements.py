"""Numbers that a model amounts to, as statements that the updates of a library rewrite.

SPARQL follows no chain of spatial relations, so the motion of each joint, and inertias about
centres of mass, come from the facts of the linter.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import count

from kinlint.addresses import is_address, lifted, split
from kinlint.facts.body_frames import Transform
from kinlint.facts.coordinate_pairs import CoordinatePairs
from kinlint.facts.fact_context import FactContext
from kinlint.facts.fact_statements import double, integer
from kinlint.facts.inertia import about_centre
from kinlint.facts.linear_algebra import Matrix, Vector, add, apply, product, scale, transpose
from kinlint.facts.mechanism import named
from kinlint.facts.metamodel_terms import chain, terms_in
from kinlint.facts.tree_motions import JointMotion
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, iri, literal
from kinlint.vocabulary import GENERATION, SRC

gen = terms_in(GENERATION)
PROGRAM = gen("program")
FILE, NAMED = gen("file"), gen("iri")
STAGE = iri(f"{SRC}stageOf")
AXES = "xyz"
FIXED, REVOLUTE, PRISMATIC = "fixed", "revolute", "prismatic"


@dataclass(frozen=True, slots=True)
class BodyInertia:
    """Inertia of a body, as the frame sees it that the body is described in."""

    mass: float
    """Mass in kg."""
    centre: Vector
    """Centre of mass in m."""
    tensor: Matrix
    """Tensor in kg m² about the centre of mass."""


class ModelStatements:
    """Statements of one model; *names* gives parts the names that programs show."""

    def __init__(
        self, context: FactContext, names: Callable[[Sequence[Term]], Mapping[Term, str]]
    ) -> None:
        self.context = context
        self.names = names
        self.motions = [context.motions.motion(each) for each in context.motions.in_tree_order]
        self._nodes = 0

    @property
    def files(self) -> Sequence[str]:
        """The names of the files that the model was read from."""
        documents = self.context.scan.documents
        return [source.name for document in documents for source in document.sources]

    def __iter__(self) -> Iterator[Triple]:
        """Yield all statements, each once."""
        yield from self._files()
        yield from self._tree([each for each in self.motions if each is not None])
        yield from self._couplings()
        yield from self._poses()
        yield from self._values()

    def _files(self) -> Iterator[Triple]:
        for name in self.files:
            yield PROGRAM, FILE, literal(name)

    def _tree(self, motions: Sequence[JointMotion]) -> Iterator[Triple]:
        bodies = [*self.context.motions.roots, *(each.edge.child or "" for each in motions)]
        names = self._distinct([*bodies, *(each.edge.joint for each in motions)])
        for number, body in enumerate(bodies):
            yield from self._part(body, "body", number, names)
            if (inertia := self.inertias.get(body)) is not None:
                yield from self._inertia(body, inertia)
        for number, each in enumerate(motions):
            joint = each.edge.joint
            yield from self._part(joint, "joint", number, names)
            yield joint, gen("parent"), each.edge.parent or ""
            yield joint, gen("child"), each.edge.child or ""
            yield from self._transform(joint, "placement", each.placement)
            yield from self._transform(joint, "zero", each.zero)
            yield from self._transform(joint, "rest", each.rest)
            if each.axis is not None:
                yield from self._numbers(joint, "axis", zip(AXES, each.axis, strict=True))
            if each.turned:
                yield joint, gen("turned"), literal("true")
        if (unweighed := self._unweighed(motions)) is None:
            yield PROGRAM, gen("weighed"), literal("true")
        elif unweighed in names:
            yield PROGRAM, gen("unweighed"), literal(names[unweighed])

    def _part(
        self, node: Term, kind: str, number: int, names: Mapping[Term, str]
    ) -> Iterator[Triple]:
        yield PROGRAM, gen(kind), node
        yield node, gen("order"), integer(number)
        yield node, gen("name"), literal(names[node])
        yield node, NAMED, literal(named(node))

    def _distinct(self, parts: Sequence[Term]) -> Mapping[Term, str]:
        """Return a name of each of *parts*, which no other body, or no other joint, has.

        Where several share one, these have their paths, numbered where others have such a name.
        """
        found: dict[Term, str] = {}
        joints = set(self.context.mechanism.joints)
        for group in (set(parts) - joints, joints):
            own = self.names([each for each in parts if each in group])
            shares = Counter(own.values())
            taken = {name for name, share in shares.items() if share == 1}
            for part, name in own.items():
                found[part] = name
                if shares[name] > 1:
                    path = _path(part)
                    spellings = (path if each == 1 else f"{path} {each}" for each in count(1))
                    found[part] = next(each for each in spellings if each not in taken)
                    taken.add(found[part])
        return found

    def _transform(self, subject: Term, name: str, pose: Transform) -> Iterator[Triple]:
        rows = (
            (row + column, pose.turn[i][j])
            for i, row in enumerate(AXES)
            for j, column in enumerate(AXES)
        )
        yield from self._numbers(subject, name, [*zip(AXES, pose.point, strict=True), *rows])

    def _numbers(
        self, subject: Term, name: str, numbers: Iterable[tuple[str, float]]
    ) -> Iterator[Triple]:
        self._nodes += 1
        node = iri(f"urn:kinlint:generation:{self._nodes}")
        yield subject, gen(name), node
        for key, number in numbers:
            yield node, gen(key), double(number + 0.0)

    def _inertia(self, body: Term, inertia: BodyInertia) -> Iterator[Triple]:
        moments = ((AXES[i] + AXES[j], inertia.tensor[i][j]) for i in range(3) for j in range(i, 3))
        centre = zip(AXES, inertia.centre, strict=True)
        yield from self._numbers(body, "inertia", [("mass", inertia.mass), *centre, *moments])

    @cached_property
    def inertias(self) -> Mapping[Term, BodyInertia]:
        """The inertias that are known completely, by body."""
        own = self.context.inertias
        pairs = CoordinatePairs(self.context.scan)
        masses = pairs.with_mass(own.quantities.masses)
        moments = pairs.with_moment(own.first_moments)
        found: dict[Term, BodyInertia] = {}
        for node in sorted(own.tensors):
            heavy, shifted = masses.match(node), moments.match(node)
            body = self.context.assemblies.body(node)
            about = pairs.points.get(pairs.relations.get(node, node))
            frame = pairs.frames.get(node)
            if None in (heavy, shifted, body, about, frame):
                continue
            mass = own.quantities.masses[heavy or ""]
            point = self.context.motions.frames.point(body or "", about or "")
            turn = self.context.motions.frames.turn(body or "", frame or "")
            if point is None or turn is None or not mass > 0.0:
                continue
            away = scale(1.0 / mass, own.first_moments[shifted or ""])
            tensor = about_centre(own.tensors[node], mass, away)
            found.setdefault(
                body or "",
                BodyInertia(
                    mass,
                    add(point, apply(turn, away)),
                    product(product(turn, tensor), transpose(turn)),
                ),
            )
        return found

    def _unweighed(self, motions: Sequence[JointMotion]) -> Term | None:
        """Return a body that moves, or is stated to have a mass, without a complete inertia.

        None if there is none. What is between the joints of one body of MJCF has no mass.
        """
        assemblies = self.context.assemblies
        known = self.inertias
        stages = {lifted(each) for each, _ in self.context.scan.table(STAGE).items()}
        moved = [each.edge.child or "" for each in motions if each.edge.child not in stages]
        lumps = {assemblies.assembly(body) for body in known}
        still = assemblies.assembly(self.context.motions.roots[0]) if motions else ""
        for body in moved:
            stated = body in assemblies.masses and body not in known
            if stated or assemblies.assembly(body) not in {*lumps, still}:
                return body
        return None if motions else ""

    def _couplings(self) -> Iterator[Triple]:
        for joint, gearings in self.context.joints.gearings.items():
            for each in gearings:
                if each.multiplier is not None and math.isfinite(each.multiplier):
                    yield joint, gen("leader"), each.leader
                    yield joint, gen("multiplier"), double(each.multiplier)
                    yield joint, gen("offset"), double(each.offset or 0.0)

    def _poses(self) -> Iterator[Triple]:
        """Yield the numbers of poses that state both a position and an orientation."""
        relations = self.context.relations
        turns = {each.relation: each.matrix for each in relations.turns}
        for each in relations.shifts:
            if each.relation in turns and each.seen_by == relations.axes(
                relations.base[each.relation]
            ):
                yield from self._transform(
                    each.relation, "value", Transform(turns[each.relation], each.vector)
                )

    def _values(self) -> Iterator[Triple]:
        """Yield the numbers of quantities in SI units, such as the position of a joint."""
        joints = self.context.scan.table(chain("Joint"))
        for node, name, number in self.context.values.values:
            if name == "value" and node not in joints:
                yield node, gen("number"), double(number)


def _path(part: Term) -> str:
    """Return the path of *part* in its file, or its IRI if it has one of its own."""
    name = named(part)
    return split(name)[1] if is_address(name) else name
