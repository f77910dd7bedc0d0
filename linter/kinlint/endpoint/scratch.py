"""A graph for one run, in which a store infers what axioms conclude from its other graphs.

Conclusions of all models are in it together: they tell where a rule may find something, not what.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import groupby
from types import FrameType

from kinlint.endpoint.connection import Endpoint, EndpointError
from kinlint.endpoint.stored_graphs import SCRATCH
from kinlint.engine.axioms import Axiom, is_variable
from kinlint.errors import UsageError
from kinlint.terms import RDF_TYPE, Term, literal_value

ENDS = ("SIGTERM", "SIGHUP")
"""Signals that end a process, as far as the system has them."""


@contextmanager
def inferred(endpoint: Endpoint, name: Term, axioms: Sequence[Axiom]) -> Iterator[None]:
    """Have *endpoint* infer into the graph *name* what *axioms* conclude; remove it at the end.

    It is removed after an interruption, too. Raises `UsageError` if there is another graph of this
    name.
    """
    if any(endpoint.select(f"SELECT ?p WHERE {{ GRAPH {name} {{ ?s ?p ?o }} }} LIMIT 1")):
        ours = f"SELECT ?x WHERE {{ GRAPH {name} {{ {name} {RDF_TYPE} {SCRATCH} ; ?p ?x }} }}"
        if not any(endpoint.select(ours)):
            raise UsageError(f"--scratch-graph: the store has a graph {name}; name one that is new")
    with _interruptible():
        try:
            marked = f"INSERT DATA {{ GRAPH {name} {{ {name} {RDF_TYPE} {SCRATCH} }} }}"
            endpoint.update(f"DROP SILENT GRAPH {name} ;\n{marked}")
            _close(endpoint, name, axioms)
            yield
        finally:
            _remove(endpoint, name)


def _close(endpoint: Endpoint, name: Term, axioms: Sequence[Axiom]) -> None:
    """Run *axioms* stratum by stratum; those that feed each other, until nothing is new."""
    for (_, recursive), group in groupby(axioms, lambda each: (each.stratum, each.recursive)):
        text = " ;\n".join(_insertion(each, name) for each in group)
        count = -1
        while True:
            endpoint.update(text)
            before, count = count, _count(endpoint, name) if recursive else count
            if count == before:
                break


def _insertion(axiom: Axiom, name: Term) -> str:
    """Return the update that adds to the graph *name* what *axiom* gives, also where it is stated.

    Premises that many graphs state alike are joined once.
    """
    head = " ".join(axiom.head)
    premises = (
        f"{{ SELECT DISTINCT {' '.join(filter(is_variable, each))} "
        f"WHERE {{ GRAPH ?g {{ {' '.join(each)} }} }} }}"
        for each in axiom.body
    )
    return f"INSERT {{ GRAPH {name} {{ {head} }} }} WHERE {{ {' '.join(premises)} }}"


def _count(endpoint: Endpoint, name: Term) -> int:
    query = f"SELECT (COUNT(*) AS ?n) WHERE {{ GRAPH {name} {{ ?s ?p ?o }} }}"
    return sum(int(literal_value(row["n"])) for row in endpoint.select(query))


def _remove(endpoint: Endpoint, name: Term) -> None:
    """Drop the graph, whatever else is said meanwhile."""
    with _deaf():
        try:
            endpoint.update(f"DROP SILENT GRAPH {name}")
        except EndpointError as error:
            raise EndpointError(f"--scratch-graph: {name} could not be removed: {error}") from None


@contextmanager
def _interruptible() -> Iterator[None]:
    """End by an exception where a signal would end the process."""

    def end(number: int, _frame: FrameType | None) -> None:
        raise SystemExit(128 + number)

    with _handled(end, ENDS):
        yield


@contextmanager
def _deaf() -> Iterator[None]:
    with _handled(signal.SIG_IGN, ("SIGINT", *ENDS)):
        yield


@contextmanager
def _handled(handler: object, names: Sequence[str]) -> Iterator[None]:
    """Have *handler* take the signals with these *names* for a while."""
    before = {}
    for each in names:
        with suppress(AttributeError, ValueError):  # unknown to the system; not the main thread
            number = getattr(signal, each)
            before[number] = signal.signal(number, handler)  # type: ignore[arg-type]
    try:
        yield
    finally:
        for number, earlier in before.items():
            signal.signal(number, earlier)
