"""The six anti-patterns that rules witness, as a taxonomy.

They were named for URDF and COLLADA by Schneider, Hochgeschwender and Bruyninckx,
"Domain-specific languages for kinematic chains and their solver algorithms: lessons learned
for composable models". The descriptions here are ours.
"""

from __future__ import annotations

from typing import NamedTuple

from kinlint.vocabulary import KL


class AntiPattern(NamedTuple):
    """A way in which a robot description keeps others from building on it."""

    id: str
    """Number, such as `AP1`."""
    name: str
    """Name."""
    description: str
    """Description, in a sentence or two."""

    @property
    def iri(self) -> str:
        """The IRI by which rule files name it."""
        return f"{KL}{self.id}"


ANTIPATTERNS = (
    AntiPattern(
        "AP1",
        "Underutilised identifiers",
        "Entities have no identifier, or one that is not unique or not absolute, so that others "
        "cannot annotate, extend or compose them.",
    ),
    AntiPattern(
        "AP2",
        "Single conformance",
        "An element is held to one type where its meaning needs several at once, so that "
        "constraints of the other types go unchecked or hide in ad hoc notation.",
    ),
    AntiPattern(
        "AP3",
        "Artificial structural constraints",
        "The notation, not the robot, limits what can be said: one root, trees instead of "
        "graphs, one representation, one measurement, or a fixed list of variants.",
    ),
    AntiPattern(
        "AP4",
        "Tight coupling",
        "Concerns that change independently, such as kinematics, dynamics, visualisation and "
        "control, are tied together, so that none can be replaced or reused alone.",
    ),
    AntiPattern(
        "AP5",
        "Incomplete metamodel",
        "What a term means, requires or permits is not stated for computers, so that a wrong, "
        "missing or misspelt statement passes unnoticed.",
    ),
    AntiPattern(
        "AP6",
        "Implicit assumptions",
        "Frames, units, defaults or conventions that give numbers their meaning are left for "
        "the reader to guess, and readers guess differently.",
    ),
)
