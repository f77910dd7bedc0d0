"""Reads the queries of a rule file that say what a finding of the rule makes uncertain."""

from __future__ import annotations

from kinlint.catalogue.repair_file import prefixes
from kinlint.engine.compiler.oxigraph_probe import refused_query
from kinlint.engine.compiler.query_rewrite import rewritten_for_oxigraph
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesGraph
from kinlint.engine.compiler.user_query import located
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import NotSparql, tokens
from kinlint.sparql.variables import projection
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import KL

EXPLAINS = iri(f"{KL}explains")
REQUIRED = {"?this", "?suspect"}


def read_explanations(graph: ShapesGraph, rule: Term) -> tuple[str, ...]:
    """Return the queries by which *rule* says what its findings make uncertain.

    Each projects `$this`, the focus node of a finding, and `?suspect`: a node, a term, or a
    namespace as a string. Where it binds `?through`, only findings that look at this property or
    class follow. Other variables have to equal those of the finding. Raises `RuleInvalid` for what
    is no SELECT or leaves one out.
    """
    return tuple(sorted(_query(graph, node) for node in graph.values(rule, EXPLAINS)))


def _query(graph: ShapesGraph, node: Term) -> str:
    written = next(iter(sorted(map(literal_value, graph.values(node, sh("select"))))), "")
    if not written:
        raise graph.invalid(node, "kl:explains has a sh:select")
    try:
        select = parse(tokens(written, prefixes()))
        if refused := refused_query(render(select), written, prefixes()):
            raise refused
    except NotSparql as error:
        raise located(graph, node, written, error) from error
    names = {f"?{name.lstrip('?$')}" for name in projection(select)}
    if not names >= REQUIRED:
        raise graph.invalid(node, "kl:explains projects $this and ?suspect")
    return render(rewritten_for_oxigraph(select, frozenset()))
