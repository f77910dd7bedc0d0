"""Makes pySHACL quick and right, and keeps what its report forgets, inside a `with` block."""

from __future__ import annotations

import logging
import sys
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from typing import Any, NoReturn

from pyshacl.constraints.constraint_component import ConstraintComponent
from rdflib import BNode
from rdflib.plugins import sparql
from rdflib.plugins.sparql import aggregates, evaluate, operators
from rdflib.plugins.sparql.algebra import translateQuery
from rdflib.plugins.sparql.parser import parseQuery
from rdflib.plugins.sparql.parserutils import Expr
from rdflib.plugins.sparql.processor import SPARQLProcessor
from rdflib.plugins.sparql.sparql import Query
from rdflib.term import Node

from kinlint.engine.reference import rdflib_expressions
from kinlint.errors import RuleInvalid
from kinlint.light_dataclasses import dataclass, field

DEPTH = 20_000
"""Python's recursion limit meanwhile: rdflib walks a path of n steps with n nested calls."""

RESULTS = (ConstraintComponent, "make_v_result")
QUERIES = (SPARQLProcessor, "query")
GROUPS = (evaluate, "evalAggregateJoin")
EXPRESSIONS = (Expr, "eval")
SERVICES = (evaluate, "evalServiceQuery")
LOADING = (sparql, "SPARQL_LOAD_GRAPHS")
NUMBERS = ((operators, "numeric"), (aggregates, "numeric"))


@dataclass(frozen=True)
class Record:
    """A result of pySHACL, with what its report leaves out."""

    shape: Node
    """Shape that is violated (`sh:sourceShape`)."""
    component: Node
    """Constraint component (`sh:sourceConstraintComponent`)."""
    focus: Node
    """Focus node."""
    path: Node | None
    """Result path; None if there is none."""
    value: Node | None
    """Value node; None if there is none."""
    source: Node | None
    """SPARQL-based constraint (`sh:sourceConstraint`); None for other components."""
    bindings: Mapping[str, Node] = field(default_factory=dict)
    """Other variables of the solution, by name."""


@contextmanager
def recorded() -> Iterator[dict[Node, Record]]:
    """Yield the results of pySHACL inside the block, by the nodes of its report.

    pySHACL parses a query anew for each focus node, which takes 70 % of its time, and it reports no
    variables but those of SHACL, while messages name others. Queries are parsed once.
    """
    records: dict[Node, Record] = {}

    def make_v_result(
        self: Any, _: Any, focus: Node, value_node: Node | None = None, **given: Any
    ) -> tuple[str, Node, list[Any]]:
        shape = self.shape
        path = given.get("result_path") or (shape.path() if shape.is_property_shape else None)
        result = BNode()
        records[result] = Record(
            shape=shape.node,
            component=given.get("constraint_component") or self.shacl_constraint_component,
            focus=focus,
            path=path,
            value=value_node,
            source=given.get("source_constraint"),
            bindings=_bindings(given.get("bound_vars")),
        )
        return "", result, []

    limit, level = sys.getrecursionlimit(), logging.root.manager.disable
    patched: tuple[tuple[Any, str], ...] = (
        *(RESULTS, QUERIES, GROUPS, EXPRESSIONS, *NUMBERS),
        *(SERVICES, LOADING),
    )
    _, _, groups, evaluated, numeric, *_ = kept = [getattr(*place) for place in patched]
    try:
        setattr(*SERVICES, _no_service)
        setattr(*LOADING, False)
        sys.setrecursionlimit(max(limit, DEPTH))
        setattr(*RESULTS, make_v_result)
        setattr(*QUERIES, _query)
        setattr(*GROUPS, lambda context, part: _groups(groups, context, part))
        setattr(
            *EXPRESSIONS,
            lambda part, context=None: rdflib_expressions.evaluated(evaluated, part, context or {}),
        )
        for place in NUMBERS:
            setattr(*place, lambda term: rdflib_expressions.numeric(numeric, term))
        with warnings.catch_warnings():
            # rdflib warns of every literal that is not in the lexical space of its datatype.
            warnings.simplefilter("ignore")
            logging.disable()
            yield records
    finally:
        for place, original in zip(patched, kept, strict=True):
            setattr(*place, original)
        logging.disable(level)
        sys.setrecursionlimit(limit)


def _bindings(bound: Any) -> dict[str, Node]:
    """Return the variables of a solution, in whichever of its shapes pySHACL passes them on."""
    if isinstance(bound, tuple):
        first: dict[str, Any] = dict(zip(("this", "path", "value"), bound, strict=False))
        bound = first | (bound[3] if len(bound) > len(first) else {})
    return {str(name): value for name, value in (bound or {}).items() if value is not None}


def _groups(original: Any, context: Any, part: Any) -> Any:
    """Return `evalAggregateJoin`, but GROUP BY makes no group of nothing (SPARQL 1.1, 18.5.1).

    rdflib makes an empty one, which joins with everything: violations that nobody else finds.
    """
    if part.p.expr is not None:
        first = next(iter(evaluate.evalPart(context, part.p)), None)
        if first is None:
            return iter(())
    return original(context, part)


def _no_service(_context: Any, _part: Any) -> NoReturn:
    """Refuse SERVICE, in case a query with it gets as far as the engine."""
    raise RuleInvalid("SERVICE is not allowed: a rule sees the model and nothing else")


@lru_cache(maxsize=4096)
def _parsed(text: str, base: str | None, prefixes: tuple[tuple[str, Any], ...]) -> Query:
    return translateQuery(parseQuery(text), base, dict(prefixes))


def _query(
    self: SPARQLProcessor, query: Any, bindings: Any = None, prefixes: Any = None, **given: Any
) -> Any:
    """Return `SPARQLProcessor.query`, parsing each text once."""
    base = given.get("base")
    if isinstance(query, str):
        query = _parsed(query, base, tuple(sorted((prefixes or {}).items())))
    return evaluate.evalQuery(self.graph, query, bindings, base)
