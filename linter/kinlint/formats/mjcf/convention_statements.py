"""Statements about conventions of compilers: units of angles, the order of Euler angles."""

from __future__ import annotations

from kinlint.formats.mjcf.compiled_model import CompiledModel
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.terms import iri
from kinlint.vocabulary import UNIT

ANGLED = ("euler", "axisangle", "ref", "springref")
"""Attributes with angles in the unit of the compiler, beside ranges."""
DEFAULT_SEQUENCE = "xyz"


def state_conventions(model: CompiledModel, said: ModelStatements) -> None:
    """State the settings that later compilers overrule, and what angles are in."""
    settings = model.settings
    for written, later in settings.overruled:
        said.state(written[0], "overruledBy", later[0])
    unit = iri(f"{UNIT}{'DEG' if settings.degrees else 'RAD'}")
    # A part leaves the unit to the files that include it.
    is_known = model.root.tag == "mujoco" or bool(settings.text("angle"))
    is_open = not settings.text("eulerseq")
    for each in model.root.below():
        if not each.said.keys().isdisjoint(ANGLED):
            if is_known:
                said.state(each.node, "anglesIn", unit)
            if is_open and "euler" in each.said:
                said.word(each.node, "sequence", DEFAULT_SEQUENCE)
