"""The whole meaning of documents: all that can be lifted, inferred and computed, for questions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import FROM, Document
from kinlint.engine.store import Store
from kinlint.formats.records import ELEMENTS
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.terms import Term, Triple
from kinlint.vocabulary import EXTENSION

PROPERTIES = tuple(f"<{each}" for each in (*ELEMENTS, EXTENSION))
"""Beginnings of the properties whose values are elements, each called like its tag."""
OWNED = tuple(
    f"#{name}>" for name in ("of-joint", "of-body", "of-inertia", "of-actuator", "actuates")
)
"""Ends of the properties of what belongs to another node, such as the limits of a joint."""


class GraphModel:
    """Graph of *documents* together, computed when it is first asked for.

    A run that lints lifts and computes only what its rules ask for; people ask for anything.
    """

    def __init__(self, documents: Sequence[Document], rulebook: Rulebook) -> None:
        self.documents, self.rulebook = documents, rulebook

    @cached_property
    def lifted(self) -> Sequence[Triple]:
        """Triples that were lifted from the elements of XML formats."""
        return tuple(self._lifted.store.lifted())

    @cached_property
    def store(self) -> Store:
        """Store with all that was lifted, inferred and computed."""
        demand = Demand.for_everything(self.rulebook)
        return run_stages("facts", self._lifted, Inputs(self.documents), demand, first="closure")

    @cached_property
    def _lifted(self) -> Run:
        run = Run(self.rulebook.vocabulary)
        run_stages("lifting", run, Inputs(self.documents))
        return run

    @cached_property
    def made(self) -> Mapping[Term, Sequence[Term]]:
        """The nodes that were made of each element, in the order of their names."""
        found: dict[Term, list[Term]] = {}
        for node, predicate, element in sorted(self.lifted):
            if predicate == FROM:
                found.setdefault(element, []).append(node)
        return found

    @cached_property
    def tags(self) -> Mapping[Term, str]:
        """The tag of each element."""
        return {
            value: predicate[:-1].rpartition("#")[2]
            for document in self.documents
            if document.format.is_tree
            for _, predicate, value in document.statements
            if predicate.startswith(PROPERTIES)
        }

    @cached_property
    def owned(self) -> Mapping[Term, Sequence[Term]]:
        """Nodes that belong to each node and are described as nodes of their own."""
        found: dict[Term, list[Term]] = {}
        said = (each for document in self.documents for each in document.statements)
        for subject, predicate, value in (*said, *self.lifted):
            if predicate.endswith(OWNED):
                found.setdefault(value, []).append(subject)
        return found

    def values(self, node: Term, predicate: Term) -> Iterator[Term]:
        """Yield the values of *predicate* for *node*, stated, lifted, inferred or computed."""
        return self.store.values(node, predicate)
