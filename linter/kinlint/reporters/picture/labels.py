"""Labels of links and joints in pictures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from kinlint.structure import Coupling, Joint, Structure, Vector

LEAST = 5e-7
"""Values below this, in m or rad, are shown as zero."""


def number(value: float) -> str:
    """Format *value* with at most five significant digits."""
    return "0" if abs(value) < LEAST else f"{value:.5g}"


def vector(values: Vector) -> str:
    """Three numbers with blanks between them."""
    return " ".join(map(number, values))


def origin(joint: Joint) -> Iterator[str]:
    """Yield the origin of the joint on its parent, as `urdf_to_graphviz` writes it."""
    if joint.origin is not None:
        if joint.origin.xyz is not None:
            yield f"xyz: {vector(joint.origin.xyz)}"
        if joint.origin.rpy is not None:
            yield f"rpy: {vector(joint.origin.rpy)}"


def limits(joint: Joint) -> str:
    """The range of a joint in rad or m, or nothing where none is known."""
    if joint.lower is None and joint.upper is None:
        return ""
    least = "−∞" if joint.lower is None else number(joint.lower)  # noqa: RUF001
    most = "∞" if joint.upper is None else number(joint.upper)
    return f"[{least}, {most}]"


def mimics(structure: Structure) -> Mapping[str, Sequence[str]]:
    """Return the coupling of each joint that follows others, as text, by its IRI."""
    found: dict[str, list[str]] = {}
    for each in structure.couplings:
        leader = structure.joint(each.leader)
        name = each.leader.rpartition("/")[2] if leader is None else leader.name
        found.setdefault(each.follower, []).append(f"mimics {name}{_law(each)}")
    return found


def _law(coupling: Coupling) -> str:
    factor, offset = coupling.multiplier, coupling.offset
    text = f" × {number(factor)}" if factor not in {None, 1.0} and factor is not None else ""  # noqa: RUF001
    if offset is not None and math.isfinite(offset) and abs(offset) >= LEAST:
        text += f" {'+' if offset > 0 else '-'} {number(abs(offset))}"
    return text


def heading(structure: Structure) -> str:
    """Return the heading of a robot: `arm: 3 links, 2 joints, 1 loop`."""
    counts = [
        _counted(len(structure.links), "link"),
        _counted(len(structure.joints), "joint"),
    ]
    if structure.loops:
        counts.append(_counted(len(structure.loops), "loop"))
    if len(structure.roots) > 1:
        counts.append(f"{len(structure.roots):,} trees")
    return f"{structure.name}: {', '.join(counts)}"


def _counted(number_: int, noun: str) -> str:
    return f"{number_:,} {noun}{'' if number_ == 1 else 's'}"
