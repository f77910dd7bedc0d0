"""Statements that follow from a document, in the source layer, and where they come from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.formats.rigid_transform import Transform, rounded
from kinlint.formats.source_layer import src
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import XSD, Term, Triple, literal

_SPECIAL = {"inf": "INF", "-inf": "-INF", "nan": "NaN"}
_DOUBLE = f'"^^<{XSD}double>'
COMPONENTS = ("x", "y", "z", "qx", "qy", "qz", "qw")


@dataclass
class DerivedStatements:
    """Statements so far."""

    triples: dict[Triple, Triple | None] = field(default_factory=dict)
    """The statements, in order; those that repeat a value, with the one in which it is written."""
    made_of: dict[Term, Term] = field(default_factory=dict)
    """Elements of the nodes that are none themselves, such as copies."""

    def state(self, node: Term, name: str, value: Term, of: Triple | None = None) -> None:
        """State that *value* is the property *name* of *node*, which *of* says, if it is given."""
        self.triples.setdefault((node, src(name), value), of)

    def word(self, node: Term, name: str, word: str) -> None:
        """State a *word*."""
        self.state(node, name, literal(word))

    def number(self, node: Term, name: str, value: float) -> None:
        """State a number."""
        self.state(node, name, number(value))

    def numbers(self, node: Term, names: Iterable[str], values: Sequence[float]) -> None:
        """State several numbers, without rounding errors of the arithmetic."""
        for name, value in zip(names, rounded(values), strict=True):
            self.number(node, name, value)

    def pose(self, node: Term, stem: str, place: Transform | None) -> None:
        """State a pose, if it is known, by properties that begin with *stem*."""
        if place is not None:
            self.numbers(node, (f"{stem}-{c}" for c in COMPONENTS), (*place[0], *place[1]))


def number(value: float) -> Term:
    """Return the literal of *value*."""
    spelled = repr(value)
    return f'"{_SPECIAL.get(spelled, spelled)}{_DOUBLE}'
