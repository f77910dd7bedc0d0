"""Questions about the graph of a model: what is stated, lifted, inferred and computed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import pyoxigraph as ox

from kinlint.document import FROM
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.facts.fact_context import FactContext
from kinlint.formats.records import ELEMENTS
from kinlint.pipeline.analyzer import Examination
from kinlint.terms import Term, iri_value
from kinlint.vocabulary import EXTENSION, LIFTED_GRAPH

PROPERTIES = tuple(f"<{each}" for each in (*ELEMENTS, EXTENSION))
"""Beginnings of the properties whose values are elements, each called like its tag."""
OWNED = tuple(
    f"#{name}>" for name in ("of-joint", "of-body", "of-inertia", "of-actuator", "actuates")
)
"""Ends of the properties of what belongs to another node, such as the limits of a joint."""
ASSERTED, LIFTED = (ox.NamedNode(iri_value(each)) for each in (ASSERTED_GRAPH, LIFTED_GRAPH))


class GraphModel:
    """Graph of *examination*, which a repeated analyzer made: rules ask for little, people for all.

    It answers until that analyzer is asked again.
    """

    def __init__(self, examination: Examination) -> None:
        self.store: Store = examination.store
        """All that was stated, lifted and inferred, and the facts that rules ask for."""
        self._computed = examination.computed

    @property
    def context(self) -> FactContext:
        """Return the parts that facts of the model are computed by."""
        return self._computed.context

    def made(self, element: Term) -> Sequence[Term]:
        """Return the nodes that were made of *element*, in the order of their names."""
        found = self.store.leading_to(element, LIFTED)
        return sorted(node for node, predicate in found if predicate == FROM)

    def tag(self, element: Term) -> str | None:
        """Return the tag of *element*; None for the root of a document."""
        found = self.store.leading_to(element, ASSERTED)
        tags = (each[:-1].rpartition("#")[2] for _, each in found if each.startswith(PROPERTIES))
        return min(tags, default=None)

    def owned(self, node: Term) -> Sequence[Term]:
        """Return the nodes that belong to *node* and are described by themselves, sorted."""
        found = (
            each for graph in (ASSERTED, LIFTED) for each in self.store.leading_to(node, graph)
        )
        return sorted({subject for subject, predicate in found if predicate.endswith(OWNED)})

    def values(self, node: Term, predicate: Term) -> Iterator[Term]:
        """Yield the values of *predicate* for *node*, stated, lifted or inferred."""
        return self.store.values(node, predicate)

    def computed(self, node: Term, name: str) -> Sequence[Term]:
        """Return the facts called *name* of *node*, sorted."""
        return self._computed.values(node, name)
