"""Collects what is stated of a compiled model: triples, each with the one that it follows from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledPart
from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.rigid_transform import Transform, rounded
from kinlint.formats.source_layer import src
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import ATTRIBUTE, INHERITED

COMPONENTS = ("x", "y", "z", "qx", "qy", "qz", "qw")


@dataclass
class ModelStatements:
    """Statements of a model so far."""

    triples: dict[Triple, Triple | None] = field(default_factory=dict)
    """The statements; those that repeat a value, with the one in which it is written."""
    made_of: dict[Term, Term] = field(default_factory=dict)
    """Elements of the nodes that are none themselves, such as copies."""

    def state(self, node: Term, name: str, value: Term, of: Triple | None = None) -> None:
        """State that *value* is the property *name*, of the source layer, of *node*."""
        self.triples.setdefault((node, src(name), value), of)

    def word(self, node: Term, name: str, word: str) -> None:
        """State a *word*."""
        self.state(node, name, literal(word))

    def truth(self, node: Term, name: str, *, value: bool) -> None:
        """State a truth value."""
        self.state(node, name, literal("true" if value else "false", f"{XSD}boolean"))

    def number(self, node: Term, name: str, value: float, of: Triple | None = None) -> None:
        """State a number; where *of* is given, as it is spelled there."""
        spelled = of[2] if of is not None else number(value)
        self.state(node, name, spelled, of)

    def numbers(self, node: Term, names: Iterable[str], values: Sequence[float]) -> None:
        """State several numbers, without rounding errors of the arithmetic."""
        for name, value in zip(names, rounded(values), strict=True):
            self.number(node, name, value)

    def pose(self, node: Term, stem: str, place: Transform | None) -> None:
        """State a pose, if it is known, by properties that begin with *stem*."""
        if place is not None:
            self.numbers(node, (f"{stem}-{c}" for c in COMPONENTS), (*place[0], *place[1]))

    def undecided(
        self,
        node: Term,
        element: MjcfElement,
        settings: CompilerSettings,
        limited: str,
        range_: str,
    ) -> None:
        """State that nothing says whether the *range_* of *element* counts, if that is so."""
        if settings.autolimits or not element.numbers(range_):
            return
        if element.text(limited) in ("", "auto"):
            self.word(node, "undecided", limited)

    def element(self, part: CompiledBody | CompiledPart) -> None:
        """State what element *part* is made of, and what it inherits."""
        self.copy(part.node, part.element)

    def copy(self, node: Term, element: MjcfElement) -> None:
        """State that *node* is made of *element*, and what it has from there and its class."""
        self.state(node, "compiledFrom", element.node)
        if node != element.node:
            self.made_of[node] = element.node
            for said in element.said.values():
                for each in said:
                    self._inherit(node, each)
        for said in element.inherited.values():
            for each in said:
                self._inherit(node, each)

    def _inherit(self, node: Term, said: Triple) -> None:
        predicate = iri(f"{INHERITED}{said[1][len(ATTRIBUTE) + 1 : -1]}")
        self.triples.setdefault((node, predicate, said[2]), said)


def number(value: float) -> Term:
    """Return the literal of *value*."""
    spelled = repr(value)
    return literal(
        {"inf": "INF", "-inf": "-INF", "nan": "NaN"}.get(spelled, spelled), f"{XSD}double"
    )
