"""The inputs of the stages: documents, and what is asked about them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from pathlib import Path

from kinlint.catalogue.applicability import axioms_for, demand, named_by, spoken_of
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint
from kinlint.engine.lifting import lifts
from kinlint.engine.required_terms import behind
from kinlint.facts.computation import asked
from kinlint.file_format import Format
from kinlint.files.packages import Packages
from kinlint.light_dataclasses import dataclass
from kinlint.missing_files import asks_for_files, references
from kinlint.terms import Term, Triple, iri
from kinlint.vocabulary import METAMODELS

UNNAMED = frozenset(
    iri(f"{METAMODELS}geometry/structural-entities#vector-{axis}") for axis in "xyz"
)
"""Properties from frames to their vectors; nothing that is lifted refers to these."""


@dataclass(frozen=True)
class Inputs:
    """The documents of one run of the stages."""

    documents: Sequence[Document]
    """All documents, each of a graph of its own."""
    own: Sequence[Document] = ()
    """The documents that missing files are looked for in: all but companions."""
    packages_of: Callable[[str], Packages] | None = None
    """Returns the packages that a file, by its name, can name; None to look for no files."""
    looked_up: Sequence[Triple] | None = None
    """Statements about such files that are known already; None to look for them."""
    repairing: bool = True
    """False if nobody asks for repairs this time, so that their hints may be out of date."""

    def missing(self, demand: Demand) -> Iterator[Triple]:
        """Yield statements about files that documents refer to and that are not there."""
        if self.looked_up is not None:
            yield from self.looked_up if asks_for_files(demand.terms) else ()
        elif self.packages_of is not None:
            yield from references(self.own, self.packages_of, demand.terms)


@dataclass(frozen=True)
class Demand:
    """The input of the stages apart from documents; by default, all that can be lifted."""

    terms: frozenset[Term] | None = None
    """The properties and classes that are looked at; None for any."""
    named: frozenset[Term] | None = None
    """The terms that are looked at by name, where `terms` is None; None for any."""
    lifted: frozenset[Term] | None = None
    """The properties and classes that lifted statements are kept for; None for any."""
    axioms: Sequence[Axiom] = ()
    """The axioms to close the graph under."""
    hints: frozenset[Term] = frozenset()
    """The terms that repairs look at."""
    constraints: Sequence[Constraint] = ()
    """The constraints to check."""
    engine: str = "oxigraph"
    """The engine that checks them."""
    shapes: Sequence[Path] = ()
    """The files of the constraints, for an engine that reads them itself."""
    browsed: bool = False
    """True if people ask about anything: all is lifted, and explained as if it were not."""

    @property
    def lifting(self) -> tuple[frozenset[Term] | None, frozenset[Term] | None]:
        """Return the terms for which documents are lifted, and those that are kept of it."""
        return (None, None) if self.browsed else (self.terms, self.lifted)

    def makes_as(self, other: Demand, formats: Collection[Format]) -> bool:
        """Tell whether, of files of *formats*, stages before checking make the same by *other*."""
        if [*asked(self.terms, self.named)] != [*asked(other.terms, other.named)]:
            return False
        if self.terms is None or other.terms is None:
            return self.terms == other.terms
        more = self.terms ^ other.terms
        if self.lifted is not None and other.lifted is not None:
            more |= self.lifted ^ other.lifted
        return (
            more.isdisjoint(lifts(formats))
            and list(self.axioms) == list(other.axioms)
            and self.hints == other.hints
        )

    @classmethod
    def from_selection(
        cls,
        selection: RuleSelection,
        constraints: Sequence[Constraint],
        documents: Sequence[Document],
        settings: Settings,
        *,
        browsed: bool = False,
    ) -> Demand:
        """Return what *constraints* and repairs of *selection* ask of *documents*, and pictures.

        If *browsed*, people ask about anything: all is lifted and inferred.
        """
        axioms = selection.rulebook.axioms
        terms = demand(constraints, selection.repairs)
        if terms is not None and settings.drawn:
            from kinlint.facts.robot_structures import ASKED  # noqa: PLC0415  few outputs draw

            terms |= ASKED
        any_by_name = terms is None and not browsed
        named = named_by(constraints, selection.repairs) if any_by_name else None
        lifted = None if terms is None else behind(axioms, terms)
        spoken = spoken_of(constraints, selection.repairs)
        if lifted and spoken is not None and all(document.format.is_tree for document in documents):
            lifted -= UNNAMED - spoken
        return cls(
            terms=terms,
            named=named,
            lifted=lifted,
            axioms=axioms if browsed else axioms_for(documents, axioms, terms),
            hints=frozenset(term for each in selection.repairs for term in each.terms),
            constraints=constraints,
            engine=settings.engine,
            shapes=selection.rulebook.shapes,
            browsed=browsed,
        )

    @classmethod
    def for_everything(cls, rulebook: Rulebook) -> Demand:
        """Return the demand for all that can be lifted, inferred and computed."""
        return cls(axioms=rulebook.axioms)
