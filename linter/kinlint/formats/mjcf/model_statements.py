"""Collects what is stated of a compiled model: triples, each with the one that it follows from."""

from __future__ import annotations

from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledPart
from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import ATTRIBUTE, INHERITED


@dataclass
class ModelStatements(DerivedStatements):
    """Statements of a model so far."""

    def truth(self, node: Term, name: str, *, value: bool) -> None:
        """State a truth value."""
        self.state(node, name, literal("true" if value else "false", f"{XSD}boolean"))

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
