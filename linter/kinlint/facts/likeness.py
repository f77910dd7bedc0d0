"""Bodies and joints that should be alike and are not, or are alike and should not be."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.geometry import Geometries
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear import IDENTITY, Matrix
from kinlint.facts.names import kin
from kinlint.facts.scan import Scan
from kinlint.facts.sides import sideless, twin
from kinlint.facts.statement import derived, fact, integer
from kinlint.terms import Term, Triple, is_iri

LETTERED = re.compile(r"[_-][lL]$")
"""How the names of twins and of axes end alike."""
LIMITS = tuple(kin(f"Actuator{name}Limit") for name in ("Force", "Velocity", "Acceleration"))
SEVERAL = 3
"""Bodies of fewer different shapes, or names, may well have one inertia."""


class Twins:
    """The nodes that say the same of what is on the left and of what is on the right."""

    def __init__(self, scan: Scan, assemblies: Assemblies) -> None:
        self.scan = scan
        self.assemblies = assemblies

    def facts(self) -> Iterator[Triple]:
        """From each node of the left to that of the right, where there is one on each side."""
        inertias = self.assemblies.inertias
        for stating in (inertias.quantities.masses, inertias.tensors):
            bodies = ((node, self.assemblies.body(node)) for node in stating)
            yield from self._paired((node, body) for node, body in bodies if body is not None)
        ranges = self.scan.instances(kin("JointPositionLimit"))
        joints = self.scan.single(kin("of-joint")).items()
        yield from self._paired((limit, joint) for limit, joint in joints if limit in ranges)
        actuated = self.scan.single(kin("actuates"))
        limits = self.scan.single(kin("of-actuator")).items()
        for kind in LIMITS:
            of_kind = self.scan.instances(kind)
            yield from self._paired(
                (limit, actuated[actuator])
                for limit, actuator in limits
                if limit in of_kind and actuator in actuated
            )

    def _paired(self, stating: Iterable[tuple[Term, Term]]) -> Iterator[Triple]:
        """The twins among nodes that each state something of one body or joint."""
        of: dict[Term, list[Term]] = {}
        for node, entity in stating:
            of.setdefault(entity, []).append(node)
        for entity in sorted(of):
            other = _twin(entity, of)
            if other is not None and len(of[entity]) == len(of[other]) == 1:
                yield of[entity][0], fact("twin"), of[other][0]


def _twin(left: Term, known: Container[Term]) -> Term | None:
    """The one on the right of an entity on the left.

    Joints and links lettered by the axes of an arm, S L E U R B T, are no twins.
    """
    space, name = _split(left)
    right = twin(name)
    if not is_iri(left) or right is None or f"{space}{right}>" not in known:
        return None
    lettered = LETTERED.search(name) and f"{space}{_axis_u(name)}>" in known
    return None if lettered else f"{space}{right}>"


def _split(node: Term) -> tuple[str, str]:
    """The namespace of an IRI, and the name in it."""
    text = node[:-1]
    at = max(text.rfind("#"), text.rfind("/")) + 1
    return text[:at], text[at:]


def _axis_u(name: str) -> str:
    """The name of the axis U beside *name*, which ends in L."""
    return name[:-1] + ("u" if name.endswith("l") else "U")


def repeated(
    inertias: Inertias, assemblies: Assemblies, geometries: Geometries
) -> Iterator[Triple]:
    """The inertias that several bodies of one file share though their shapes differ.

    Each points to the first of them; the identity matrix is a case of its own.
    """
    groups: dict[tuple[object, ...], list[tuple[Term, Term]]] = {}
    for node, tensor in inertias.tensors.items():
        body = assemblies.body(node)
        mass = assemblies.masses.get(body, 0.0) if body is not None else 0.0
        if body is not None and mass > 0.0 and tensor != IDENTITY and _any(tensor):
            groups.setdefault((_split(body)[0], mass, tensor), []).append((node, body))
    for group in groups.values():
        if len(group) >= SEVERAL:
            yield from _group(group, geometries)


def _group(group: list[tuple[Term, Term]], geometries: Geometries) -> Iterator[Triple]:
    forms = {_shapes(geometries.form(body)) for _, body in group}
    several = len(forms - {frozenset()})
    if several < SEVERAL or len({sideless(_split(body)[1]) for _, body in group}) < SEVERAL:
        return
    nodes = sorted(node for node, _ in group)
    for node in nodes:
        yield node, fact("shared-with"), nodes[0]
        yield node, fact("shapes"), integer(several)
    yield from derived(nodes[0], nodes[1:])


def _shapes(form: frozenset[tuple[object, ...]]) -> frozenset[object]:
    """What is left of *form* once left and right are the same, and front and rear."""
    return frozenset(tuple(map(_plain, shape)) for shape in form)


def _plain(part: object) -> object:
    return sideless(part) if isinstance(part, str) else part


def _any(tensor: Matrix) -> bool:
    return any(entry != 0.0 for row in tensor for entry in row)
