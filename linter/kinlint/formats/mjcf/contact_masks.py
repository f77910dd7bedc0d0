"""States geoms whose contact bits meet those of no other geom."""

from __future__ import annotations

from math import isfinite
from typing import TypeAlias

from kinlint.formats.mjcf.compiled_model import CompiledModel
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.terms import Term

Bits: TypeAlias = tuple[int, int]
"""The bits `contype` and `conaffinity` of a geom."""
GROUND = frozenset({"plane", "hfield"})
OPAQUE = frozenset({"flex", "flexcomp", "composite"})
"""Elements with geoms, or what they touch, that are not listed."""


def state_unmet(model: CompiledModel, said: ModelStatements) -> None:
    """State the geoms of *model* that have contact bits, but none that another body's geom has.

    A model without ground, which others put into their scenes, is left alone, as is one in which
    nothing meets. Who switches contacts off keeps one of both numbers at 0.
    """
    geoms = [(body, each.element, each.node) for body in model.bodies for each in body.geoms]
    if not any(each.text("type") in GROUND for _, each, _ in geoms):
        return
    if any(each.tag in OPAQUE for each in model.root.below()):
        return
    sections = [*model.root.all("contact")]
    pairs = [each for section in sections for each in section.all("pair")]
    paired = {each.text(name) for each in pairs for name in ("geom1", "geom2")}
    owners: dict[Bits, set[Term]] = {}
    for body, each, _ in geoms:
        owners.setdefault(_bits(each), set()).add(body.node)
    met = {
        own: set[Term]().union(*(owners[bits] for bits in owners if _meet(own, bits)))
        for own in owners
    }
    if not any(len(met[own] | owners[own]) > 1 for own in owners if met[own]):
        return
    for body, each, node in geoms:
        own = _bits(each)
        alone = all(own) and body.parent is not None and not met[own] - {body.node}
        if alone and each.name not in paired:
            said.word(node, "unmet", "contype {} and conaffinity {}".format(*own))


def _bits(geom: MjcfElement) -> Bits:
    return _whole(geom.number("contype", 1.0)), _whole(geom.number("conaffinity", 1.0))


def _whole(number: float) -> int:
    """Return *number* as an integer, 0 for one that is none, which MuJoCo refuses."""
    return int(number) if isfinite(number) else 0


def _meet(one: Bits, other: Bits) -> bool:
    return bool(one[0] & other[1] or other[0] & one[1])
