"""Bodies and joints that should be alike and are not, or are alike and should not be."""

from __future__ import annotations

import math
import re
from collections.abc import Container, Iterable, Iterator, Mapping
from itertools import product
from typing import NamedTuple
from urllib.parse import unquote

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.fact_statements import derived, fact, integer
from kinlint.facts.inertia import Inertias
from kinlint.facts.laterality import sideless, twin, without_side
from kinlint.facts.linear_algebra import IDENTITY, Matrix, length
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spatial_relations import RelativePosition, SpatialRelations
from kinlint.terms import Term, Triple, is_iri

LETTERED = re.compile(r"[_-][lL]$")
"""End that the names of twins and of axes have in common."""
LIMITS = tuple(kin(f"Actuator{name}Limit") for name in ("Force", "Velocity", "Acceleration"))
ASIDE = 2e-3
"""Distance in m from the plane of symmetry that tells a point from its mirror image."""
MIRRORED = 2
"""Fewest mirrored pairs that one unlike them is compared with."""
NEGLIGIBLE = 1e-3
"""Distance in m whose sign tells nothing."""
SEVERAL = 3
"""Fewest bodies of different shapes, or names, whose common inertia is no coincidence."""


class MirrorTwins:
    """Nodes that state the same quantity of a part on the left and of its twin on the right."""

    def __init__(self, scan: PredicateIndex, assemblies: Assemblies) -> None:
        self.scan = scan
        self.assemblies = assemblies

    def facts(self) -> Iterator[Triple]:
        """Yield each node of the left with that of the right, where there is one on each side."""
        inertias = self.assemblies.inertias
        for stating in (inertias.quantities.masses, inertias.tensors):
            yield from _paired(self._of_bodies(stating))
        ranges = self.scan.instances(kin("JointPositionLimit"))
        joints = self.scan.single(kin("of-joint")).items()
        yield from _paired((limit, joint) for limit, joint in joints if limit in ranges)
        for kind in LIMITS:
            yield from _paired(self._of_joints(kind))

    def odd_ones(self) -> Iterator[Triple]:
        """Yield each mass or bound that differs from all on the other sides, which agree.

        At least three of them do, such as those of the other legs of a walking robot.
        """
        masses = self.assemblies.inertias.quantities.masses
        yield from _odd(self._of_bodies(masses), masses)
        bounds = self.scan.numbers(kin("upper"))
        for kind in LIMITS:
            yield from _odd(self._of_joints(kind), bounds)

    def _of_bodies(self, stating: Iterable[Term]) -> Iterator[tuple[Term, Term]]:
        """Return the nodes of *stating* that are about a body, each with the body."""
        bodies = ((node, self.assemblies.body(node)) for node in stating)
        return ((node, body) for node, body in bodies if body is not None)

    def _of_joints(self, kind: Term) -> Iterator[tuple[Term, Term]]:
        """Yield the limits of *kind* on the actuator of a joint, each with the joint."""
        of_kind = self.scan.instances(kind)
        actuated = self.scan.single(kin("actuates"))
        for limit, actuator in self.scan.single(kin("of-actuator")).items():
            if limit in of_kind and actuator in actuated:
                yield limit, actuated[actuator]


def _grouped(stating: Iterable[tuple[Term, Term]]) -> Mapping[Term, list[Term]]:
    """Return the nodes of *stating* by the body or joint that they are about."""
    of: dict[Term, list[Term]] = {}
    for node, entity in stating:
        of.setdefault(entity, []).append(node)
    return of


def _paired(stating: Iterable[tuple[Term, Term]]) -> Iterator[Triple]:
    """Yield the twins among nodes that are each about one body or joint."""
    of = _grouped(stating)
    nested = _nested(of)
    for entity in sorted(of):
        other = twin_of(entity, of) or _nested_twin(entity, nested)
        if other is not None and len(of[entity]) == len(of[other]) == 1:
            yield of[entity][0], fact("twin"), of[other][0]


def _nested(entities: Iterable[Term]) -> Mapping[tuple[str, str], Term | None]:
    """Return *entities* by what they are in, without sides, and name; None for several."""
    found: dict[tuple[str, str], Term | None] = {}
    for each in entities:
        space, name = split_name(each)
        key = sideless(space), name
        found[key] = None if key in found else each
    return found


def _nested_twin(left: Term, nested: Mapping[tuple[str, str], Term | None]) -> Term | None:
    """Return the twin of *left* in the twin of what *left* is in, such as the body above."""
    space, name = split_name(left)
    right = twin(name)
    found = nested.get((sideless(space), right)) if right is not None and is_iri(left) else None
    return found if found is not None and split_name(found)[0] != space else None


def _odd(stating: Iterable[tuple[Term, Term]], values: Mapping[Term, float]) -> Iterator[Triple]:
    """Yield the one of each group of siblings whose value differs while all others agree."""
    siblings: dict[tuple[str, str], list[Term]] = {}
    for entity, nodes in sorted(_grouped(stating).items()):
        space, name = split_name(entity)
        if len(nodes) == 1 and nodes[0] in values and without_side(name) != unquote(name):
            siblings.setdefault((sideless(space), without_side(name)), []).append(nodes[0])
    for group in siblings.values():
        if len(group) <= SEVERAL:
            continue
        by_value = sorted(group, key=lambda node: values[node])
        for odd, others in ((by_value[0], by_value[1:]), (by_value[-1], by_value[:-1])):
            least, most = values[others[0]], values[others[-1]]
            if _near(least, most) and not _near(values[odd], least):
                yield odd, fact("unlike-siblings"), others[0]


def _near(one: float, other: float) -> bool:
    """Tell whether two values differ by no more than one percent, the rounding of two digits."""
    return math.isclose(one, other, rel_tol=0.01)


def twin_of(left: Term, known: Container[Term]) -> Term | None:
    """Return the twin on the right of an entity on the left.

    Joints and links lettered by the axes of an arm, S L E U R B T, are no twins.
    """
    space, name = split_name(left)
    right = twin(name)
    if not is_iri(left) or right is None or f"{space}{right}>" not in known:
        return None
    lettered = LETTERED.search(name) and f"{space}{_axis_u(name)}>" in known
    return None if lettered else f"{space}{right}>"


def split_name(node: Term) -> tuple[str, str]:
    """Return the namespace of an IRI, and the name in it."""
    text = node[:-1]
    at = max(text.rfind("#"), text.rfind("/")) + 1
    return text[:at], text[at:]


def _axis_u(name: str) -> str:
    """Return the name of the axis U next to *name*, which ends in L."""
    return name[:-1] + ("u" if name.endswith("l") else "U")


def shared_inertias(
    inertias: Inertias, assemblies: Assemblies, geometries: BodyShapes
) -> Iterator[Triple]:
    """Yield the inertias that several bodies of one file share though their shapes differ.

    Each points to the first of them; the identity matrix is a case of its own.
    """
    groups: dict[tuple[object, ...], list[tuple[Term, Term]]] = {}
    for node, tensor in inertias.tensors.items():
        weighed = assemblies.weighed(node)
        if weighed is not None and tensor != IDENTITY and _any(tensor):
            body, mass = weighed
            groups.setdefault((split_name(body)[0], mass, tensor), []).append((node, body))
    for group in groups.values():
        if len(group) >= SEVERAL:
            yield from _group(group, geometries)


def _group(group: list[tuple[Term, Term]], geometries: BodyShapes) -> Iterator[Triple]:
    forms = {_shapes(geometries.form(body)) for _, body in group}
    several = len(forms - {frozenset()})
    if several < SEVERAL or len({without_side(split_name(body)[1]) for _, body in group}) < SEVERAL:
        return
    nodes = sorted(node for node, _ in group)
    for node in nodes:
        yield node, fact("shared-with"), nodes[0]
        yield node, fact("shapes"), integer(several)
    yield from derived(nodes[0], nodes[1:])


def _shapes(form: frozenset[tuple[object, ...]]) -> frozenset[object]:
    """Return *form* with left and right made the same, and front and rear."""
    return frozenset(tuple(map(_plain, shape)) for shape in form)


def _plain(part: object) -> object:
    return without_side(part) if isinstance(part, str) else part


def _any(tensor: Matrix) -> bool:
    return any(entry != 0.0 for row in tensor for entry in row)


def unmirrored_centres(
    inertias: Inertias, assemblies: Assemblies, relations: SpatialRelations
) -> Iterator[Triple]:
    """Yield the centres of mass on the left that are no mirror images of those on the right.

    Where the moments about each axis agree, as many components of both may have other signs as
    frames have that are mirrored; their sizes agree, and products of inertia have the signs of
    theirs, unless they have a frame of their own. Nor is one pair equal along an axis that all
    others are mirrored along. It is the coordinates of their positions that are told.
    """
    found = dict(_centres(inertias, assemblies, relations))
    pairs: dict[str, list[tuple[RelativePosition, RelativePosition]]] = {}
    for body, here in found.items():
        if (other := twin_of(body, found)) is None:
            continue
        there = found[other]
        if all(_near(here.tensor[at][at], there.tensor[at][at]) for at in range(3)):
            if here.framed or _is_image(here, there):
                pairs.setdefault(split_name(body)[0], []).append((here.shift, there.shift))
            else:
                yield here.shift.source, fact("unlike-centre"), there.shift.source
    for mirrored in pairs.values():
        for left, right in _copies(mirrored):
            yield left.source, fact("unlike-centre"), right.source


class _Centre(NamedTuple):
    """Centre of mass of a body."""

    tensor: Matrix
    """Inertia about it in kg m²."""
    shift: RelativePosition
    """Its position, along the axes that the inertia is about."""
    framed: bool
    """Sign that the inertia has a frame of its own, parallel to that of the position."""


def _centres(
    inertias: Inertias, assemblies: Assemblies, relations: SpatialRelations
) -> Iterator[tuple[Term, _Centre]]:
    """Yield the centre of mass of each body whose position and inertia are along the same axes."""
    shifts = {each.of: each for each in relations.shifts}
    parallel = {each.of: each.base for each in relations.turns if each.matrix == IDENTITY}
    for node, tensor in sorted(inertias.central.items()):
        body = assemblies.body(node)
        point = assemblies.companions.point(node)
        shift = shifts.get(point) if point is not None else None
        seen_by = assemblies.companions.frames.get(node)
        if body is None or shift is None or seen_by is None:
            continue
        axes = relations.axes(seen_by)
        if parallel.get(axes, axes) == shift.seen_by:
            yield body, _Centre(tensor, shift, axes != shift.seen_by)


def _copies(
    pairs: list[tuple[RelativePosition, RelativePosition]],
) -> Iterator[tuple[RelativePosition, RelativePosition]]:
    """Yield the only pair that is equal along an axis that all others are mirrored along."""
    for at in range(3):
        aside = [pair for pair in pairs if abs(pair[0].vector[at]) > ASIDE]
        equal = [pair for pair in aside if pair[0].vector[at] * pair[1].vector[at] > 0]
        if len(equal) == 1 and len(aside) > MIRRORED:
            others = [pair for pair in aside if pair not in equal]
            if all(_only_along(at, left, right) for left, right in others):
                yield from equal


def _only_along(at: int, left: RelativePosition, right: RelativePosition) -> bool:
    """Tell whether no other component than *at* has another sign on the right."""
    return all(
        one * two > 0 or abs(one) <= NEGLIGIBLE
        for axis, (one, two) in enumerate(zip(left.vector, right.vector, strict=True))
        if axis != at
    )


def _is_image(here: _Centre, there: _Centre) -> bool:
    """Tell whether some axes exist along which *there* is the mirror image of *here*."""
    left, right = here.shift.vector, there.shift.vector
    tensor, across = here.tensor, there.tensor
    slack = 1e-3 + 0.02 * length(left)
    least = 0.01 * max(tensor[at][at] for at in range(3))
    return any(
        all(
            abs(sign * one - two) <= slack
            for sign, one, two in zip(signs, left, right, strict=True)
        )
        and all(
            abs(signs[row] * signs[at] * tensor[row][at] - across[row][at]) <= least
            for row, at in ((0, 1), (0, 2), (1, 2))
        )
        for signs in product((1.0, -1.0), repeat=3)
    )
