"""Permissions of SPARQL in rules and shapes: no network, no file, no other dataset.

Neither Oxigraph nor rdflib can be built without their HTTP clients, so a query that would use one
is refused before an engine sees it, whichever engine is going to run it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from kinlint.engine.compiler.declared_prefixes import declared, namespaces
from kinlint.engine.compiler.shacl_terms import TYPE, sh
from kinlint.engine.compiler.user_query import located
from kinlint.engine.math_functions import NAMESPACE as MATH
from kinlint.sparql.ast import Bind, Filter, Group, Query, Select, walk
from kinlint.sparql.parser import parse, parse_construct, parse_update
from kinlint.sparql.tokens import NotSparql, Token, split, tokens
from kinlint.terms import XSD, iri, is_literal, literal_value
from kinlint.vocabulary import KINLINT, KL, SH

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph
    from kinlint.terms import Term

TEXTS = ("select", "ask", "construct", "update")
"""Properties of SHACL whose values are SPARQL."""
REMOTE = frozenset({"SERVICE", "LOAD", "FROM", "USING", "WITH"})
"""Keywords that name or fetch another dataset: SPARQL 1.1 Query 13.2, Update 3.1, Federation 2."""
FUNCTIONS = {"update": (f"<{XSD}", f"<{MATH}")}
"""Namespaces of the functions that a text may call by IRI, besides those that its file defines."""
CASTS = (f"<{XSD}",)
"""The namespace of casts, which any text may call: SPARQL 1.1, 17.5."""
SCRIPTS = f"<{SH}js"
_ESCAPE = re.compile(r"\\u([0-9A-Fa-f]{4})|\\U([0-9A-Fa-f]{8})")


def check_permissions(graph: ShapesGraph) -> None:
    """Raise `RuleInvalid` for the first query or script in *graph* that sees more than models."""
    for node in graph.subjects():
        if script := next((p for p in graph.predicates(node) if p.startswith(SCRIPTS)), None):
            raise graph.invalid(node, f"scripts are not run: {script}")
        for name in TEXTS:
            for value in graph.values(node, sh(name)):
                if is_literal(value) and (fault := _fault(graph, node, name, literal_value(value))):
                    raise graph.invalid(node, f"sh:{name}: {fault}")


def forbidden_in(text: str, prefixes: Mapping[str, str], kinds: Sequence[str]) -> str | None:
    """Return why a query *text* of a user's own is not asked; None if it may be.

    It has to be one of *kinds*, such as SELECT, and sees no more than rules do. Raises `NotSparql`.
    """
    if fault := _forbidden_keyword(text):
        return fault
    words = tokens(text, prefixes)
    kind = words[0].upper() if words else ""
    if kind not in kinds:
        return f"expected {', '.join(kinds[:-1])} or {kinds[-1]}, got '{kind}'"
    query = parse_construct(text, prefixes) if kind == "CONSTRUCT" else parse(words)
    for function in _called(query):
        if not function.startswith(CASTS):
            return f"the function {function} is not known"
    return None


def _fault(graph: ShapesGraph, node: Term, name: str, written: str) -> str | None:
    try:
        text = _ESCAPE.sub(lambda match: chr(int(match[1] or match[2], 16)), written)
    except (OverflowError, ValueError):
        return "it has an escape of no character of Unicode"
    try:
        fault = _forbidden_keyword(text)
    except NotSparql as error:
        raise located(graph, node, written, error) from error
    try:
        return fault or _forbidden_call(
            graph, _query(graph, node, name, text), FUNCTIONS.get(name, CASTS)
        )
    except NotSparql:
        return None  # The compiler reports where the grammar is broken.


def _forbidden_keyword(text: str) -> str | None:
    """Return what the query *text* may not use, wherever it stands in it. Raises `NotSparql`."""
    for token, following in pairwise((*split(text), None)):
        word = token.text.upper() if token is not None and token.kind == "word" else ""
        if word in REMOTE:
            return f"{word} is not allowed: a rule sees the model and nothing else"
        if word == "GRAPH" and following is not None and not _is_ours(following):
            return "GRAPH of an IRI is not allowed: a rule sees the model and nothing else"
    return None


def _is_ours(graph: Token) -> bool:
    """Tell whether *graph* is a variable, or names a graph that kinlint itself makes."""
    return graph.kind == "variable" or graph.text.startswith(f"<{KINLINT}")


def _query(graph: ShapesGraph, node: Term, name: str, text: str) -> Query:
    prefixes = {**namespaces(graph, iri(f"{KL}prefixes")), **declared(graph, node)}
    if name == "construct":
        return parse_construct(text, prefixes)
    return parse_update(text, prefixes) if name == "update" else parse(tokens(text, prefixes))


def _forbidden_call(graph: ShapesGraph, query: Query, known: tuple[str, ...]) -> str | None:
    for function in _called(query):
        kinds = graph.values(function, TYPE)
        if not function.startswith(known) and sh("SPARQLFunction") not in kinds:
            return f"the function {function} is not known"
    return None


def _called(query: Query) -> Iterator[str]:
    """Yield the functions that *query* calls by their IRIs."""
    for part in walk(query if isinstance(query, Select) else query.group):
        match part:
            case Filter(expression) | Bind(expression, _):
                yield from _calls(expression)
            case Select(head, _, tail):
                yield from _calls(head)
                yield from _calls(tail)
            case _:
                continue


def _calls(expression: Sequence[str | Group]) -> Iterator[str]:
    for token, following in pairwise(expression):
        if isinstance(token, str) and token[:1] + token[-1:] == "<>" and following == "(":
            yield token
