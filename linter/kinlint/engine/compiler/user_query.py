"""SPARQL that rule authors write: read, held to SHACL 5.2 and 6.2, made ready for LATERAL."""

from __future__ import annotations

from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler.declared_prefixes import declared
from kinlint.engine.compiler.deferral import Deferred
from kinlint.engine.compiler.oxigraph_probe import refused_query, try_call
from kinlint.engine.compiler.prebinding import OPTIONAL, forbidden
from kinlint.engine.compiler.query_rewrite import rewritten_for_oxigraph
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.errors import RuleInvalid
from kinlint.light_dataclasses import dataclass
from kinlint.sparql.ast import Clause, Group, Select, Triples, Union, render, walk
from kinlint.sparql.parser import parse
from kinlint.sparql.patterns import patterns, premises
from kinlint.sparql.tokens import NotSparql, is_variable, tokens
from kinlint.sparql.variables import projection, with_names
from kinlint.terms import is_literal, literal_value

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph
    from kinlint.terms import Term, Triple

PATH = "?PATH"


@dataclass(frozen=True)
class Query:
    """An author's query that may be written inside another: no prologue, no prefixed names."""

    select: Select
    """AST of the query."""
    variables: tuple[str, ...]
    """Variables of its solutions."""
    premises: tuple[Triple, ...]
    """Triple patterns that each solution matches, for derivations."""
    may_stay: bool
    """A path may lead from a pre-bound term to itself in no steps."""

    @property
    def text(self) -> str:
        """The query in SPARQL."""
        return render(self.select)


def read_query(
    graph: ShapesGraph, node: Term, name: str, path: str | None, prebound: tuple[str, ...]
) -> Query:
    """Return the query that *node* states by `sh:select` or `sh:ask` (*name*).

    `$PATH` becomes *path*, which is None in node shapes.

    *prebound* are the variables that get their values from outside. Raises `RuleInvalid` for what
    is no SPARQL or not allowed in SHACL, `Deferred` for what is not covered.
    """
    value = graph.one(node, sh(name))
    if value is None or not is_literal(value):
        raise graph.invalid(node, f"sh:{name} is missing, or not a string")
    text = literal_value(value)
    try:
        prefixes = declared(graph, node)
        found = tokens(text, prefixes)
        select = parse(tuple(path or word if word == PATH else word for word in found))
        if refused := refused_query(render(select), text, prefixes):
            raise refused
    except NotSparql as error:
        raise located(graph, node, text, error) from error
    fault = forbidden(select, prebound)
    if str(select.head[0]).lower() != name:
        fault = f"sh:{name} is a query of another kind"
    elif PATH in found and path is None:
        fault = "$PATH has no meaning in a node shape"
    if fault is not None:
        raise graph.invalid(node, fault)
    _defer(select, found)
    names = projection(select)
    if "*" in select.head and "(" not in select.head:
        select = with_names(select, names)
    return Query(
        rewritten_for_oxigraph(select, frozenset(prebound)),
        tuple(names),
        _premises(select.group, count(2000)),
        _may_stay(select, prebound),
    )


def located(graph: ShapesGraph, node: Term, text: str, error: NotSparql) -> RuleInvalid:
    """Return what is wrong with the query *text* of *node*, with the line of the file if it can.

    A query is found there unless its literal has escapes before the first backslash.
    """
    file = graph.home(node)
    start = file.text.find(text.split("\\", 1)[0])
    if start < 0:
        return graph.invalid(node, str(error))
    line = file.text.count("\n", 0, start) + text.count("\n", 0, error.offset(text)) + 1
    return RuleInvalid(f"{file.name}:{line}: {error}")


def _defer(select: Select, found: tuple[str, ...]) -> None:
    """Raise `Deferred` for what the compiler does not cover."""
    for variable in OPTIONAL:
        if variable in found:
            raise Deferred(f"${variable[1:]} needs the shapes graph")
    if any(isinstance(part, Clause) and part.head[0].upper() == "GRAPH" for part in walk(select)):
        raise Deferred("GRAPH sees the named graphs of the store, which are kinlint's own")
    for at, word in enumerate(found):
        if word.upper() in ("REGEX", "REPLACE"):
            try_call(word, found[at + 2 :])


def _may_stay(select: Select, prebound: tuple[str, ...]) -> bool:
    """Tell whether a path of no steps may start or end at a pre-bound term.

    Such a path holds for any term, but Oxigraph follows it only from terms of the graph. Raises
    `Deferred` where that matters for a term which the query itself names.
    """
    found = False
    for part in walk(select):
        if isinstance(part, Triples) and {"*", "?"} & set(part.tokens):
            block = patterns(part.tokens, count(2000))
            for each in block:
                if not {"*", "?"} & set(each.path):
                    continue
                ends = {each.subject, each.object}
                found = found or not ends.isdisjoint(prebound)
                others = [other.variables for other in block if other is not each]
                known = set(prebound).union(*others)
                constants = [end for end in ends if not is_variable(end)]
                if constants and not ends & known:
                    raise Deferred(f"a path of no steps at {constants[0]}, if that is in no graph")
    return found


def _premises(group: Group, names: count[int]) -> tuple[Triple, ...]:
    """Return the patterns that every solution of *group* matches, with new variables by *names*."""
    found: list[Triple] = []
    for each in group.elements:
        match each:
            case Triples(tokens):
                found += premises(patterns(tokens, names))
            case Union((branch,)):
                found += _premises(branch, names)
            case _:
                continue
    return tuple(found)
