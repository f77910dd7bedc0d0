"""A graph for one run, in which a store infers what axioms conclude from its other graphs.

Conclusions of all models are in it together, each with the graph that it rests on: they tell in
which a rule may find something, not what.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from itertools import groupby, product
from uuid import uuid4

from kinlint.endpoint.conditions import HOME
from kinlint.endpoint.connection import Endpoint, EndpointError
from kinlint.endpoint.interruptions import Interruptions
from kinlint.endpoint.stored_graphs import SCRATCH
from kinlint.engine.axioms import Axiom
from kinlint.engine.required_terms import made, term_of
from kinlint.errors import UsageError
from kinlint.light_dataclasses import dataclass
from kinlint.terms import RDF_TYPE, Term, iri, literal, literal_value
from kinlint.vocabulary import STORE

RUN = iri(f"{STORE}run")
"""Property of a scratch graph: a word by which its run knows it again."""
ANYTHING = "?s ?p ?o"
"""Matches whatever a graph states."""
TRIES = 3
"""Number of times that a graph is dropped into which a lost update may yet write."""


@dataclass(frozen=True)
class ScratchGraph:
    """A scratch graph, as the run that made it knows it."""

    endpoint: Endpoint
    """Its store."""
    name: Term
    """Its name."""
    word: Term
    """The literal by which the run knows it."""
    interruptions: Interruptions
    """The signals, which wait until the store has made an update: what it infers after the graph is
    dropped would stay."""

    @property
    def is_ours(self) -> bool:
        """True if no other run has taken the graph for its own meanwhile."""
        return _has(self.endpoint, self.name, f"{self.name} {RUN} {self.word} ; ?p ?o")

    def begin(self) -> None:
        """Make the graph anew."""
        said = f"GRAPH {self.name} {{ {self.name} {RDF_TYPE} {SCRATCH} ; {RUN} {self.word} }}"
        self.update(f"DROP SILENT GRAPH {self.name} ;\nINSERT DATA {{ {said} }}")

    def infer(self, axioms: Sequence[Axiom], begin: Callable[[str], None]) -> int:
        """Have the store infer what *axioms* conclude; return the number of statements.

        Stratum by stratum; those that feed each other, until nothing is new. *begin* is called with
        the words of each axiom before.
        """
        concluded = made(axioms)
        for (_, recursive), group in groupby(axioms, lambda each: (each.stratum, each.recursive)):
            updates = [(each.label, " ;\n".join(self._ways(each, concluded))) for each in group]
            count, grew = 0, True
            while grew:
                for label, update in updates:
                    begin(label)
                    self.update(update)
                before, count = count, self._count() if recursive else 0
                grew = count > before
        return self._count()

    def update(self, text: str) -> None:
        """Have the store make an update, whatever signals come meanwhile."""
        with self.interruptions.held():
            self.endpoint.update(text)

    def _ways(self, axiom: Axiom, concluded: Collection[Term]) -> Iterator[str]:
        """Yield the updates by which *axiom* is applied, whatever of its body is inferred itself.

        Its premises are of one model, which the graph of one of them stands for.
        """
        subject = axiom.head[0]
        made = f"{' '.join(axiom.head)} . {subject} {HOME} ?g"
        sources = ((False, True) if term_of(each) in concluded else (False,) for each in axiom.body)
        for chosen in product(*sources):
            where = " ".join(
                f"GRAPH {self.name} {{ {' '.join(each)} . {each[0]} {HOME} ?g }}"
                if inferred
                else f"GRAPH ?g {{ {' '.join(each)} }}"
                for each, inferred in zip(axiom.body, chosen, strict=True)
            )
            apart = f"FILTER(?g != {self.name})"
            yield f"INSERT {{ GRAPH {self.name} {{ {made} }} }} WHERE {{ {where} {apart} }}"

    def _count(self) -> int:
        query = f"SELECT (COUNT(*) AS ?n) WHERE {{ GRAPH {self.name} {{ ?s ?p ?o }} }}"
        return sum(int(literal_value(row["n"])) for row in self.endpoint.select(query))


@contextmanager
def scratch_graph(
    endpoint: Endpoint, name: Term, warn: Callable[[str], None]
) -> Iterator[ScratchGraph]:
    """Give an empty graph *name* of *endpoint*, and remove it at the end, however that comes.

    One that a killed run left is removed before, and *warn* told. Raises `UsageError` if there is
    another graph of this name.
    """
    if _has(endpoint, name, f"{name} {RDF_TYPE} {SCRATCH} ; ?p ?o"):
        warn(f"--scratch-graph: {name} of a run that did not end is removed")
    elif _has(endpoint, name, ANYTHING):
        raise UsageError(f"--scratch-graph: the store has a graph {name}; name one that is new")
    interruptions = Interruptions()
    made = ScratchGraph(endpoint, name, literal(uuid4().hex), interruptions)
    with interruptions.raised():
        try:
            try:
                made.begin()
            except EndpointError as error:
                raise EndpointError(f"--scratch-graph: {error}") from None
            yield made
        finally:
            interruptions.ignore()
            if made.is_ours:
                _remove(endpoint, name)


def _has(endpoint: Endpoint, name: Term, pattern: str) -> bool:
    query = f"SELECT ?p WHERE {{ GRAPH {name} {{ {pattern} }} }} LIMIT 1"
    return any(endpoint.select(query))


def _remove(endpoint: Endpoint, name: Term) -> None:
    """Drop the graph until it is gone."""
    cause: object = "others write to it"
    for _ in range(TRIES):
        try:
            endpoint.update(f"DROP SILENT GRAPH {name}")
            if not _has(endpoint, name, ANYTHING):
                return
        except EndpointError as error:
            cause = error
            break
    raise EndpointError(f"--scratch-graph: {name} could not be removed: {cause}")
