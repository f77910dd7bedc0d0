"""Reads the repairs of a rule file and takes their SPARQL Updates apart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from textwrap import dedent

from kinlint import resources
from kinlint.engine.compiler.declared_prefixes import namespaces
from kinlint.engine.compiler.oxigraph_probe import refused_update
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesGraph, read
from kinlint.engine.compiler.user_query import located
from kinlint.rule import KNOWN, Applicability, Repair
from kinlint.sparql.ast import Update, render
from kinlint.sparql.parser import parse_update
from kinlint.sparql.patterns import template
from kinlint.sparql.tokens import NotSparql, is_variable, prefixed, tokens
from kinlint.sparql.variables import assigned
from kinlint.terms import Term, Triple, blank, iri, is_blank, literal_value
from kinlint.vocabulary import DASH, KL, RDFS

APPLICABILITY = {
    f"<{KL}safe>": Applicability.SAFE,
    f"<{KL}unsafe>": Applicability.UNSAFE,
    f"<{KL}displayOnly>": Applicability.DISPLAY,
}


def read_repairs(graph: ShapesGraph, rule: Term) -> tuple[Repair, ...]:
    """Return the repairs that *graph* gives *rule*, the preferred first.

    Raises `RuleInvalid` for an update that is no SPARQL, or not one DELETE/INSERT operation.
    """
    found = [_repair(graph, node) for node in graph.values(rule, iri(f"{DASH}suggestionGenerator"))]
    return tuple(sorted(found, key=lambda each: (each.order, each.title, each.update)))


def _repair(graph: ShapesGraph, node: Term) -> Repair:
    def text(predicate: Term) -> str:
        return next(iter(sorted(map(literal_value, graph.values(node, predicate)))), "")

    title, written = text(iri(f"{RDFS}label")), text(sh("update"))
    claimed = next(iter(graph.values(node, iri(f"{KL}applicability"))), "")
    if not title or claimed not in APPLICABILITY or not written:
        raise graph.invalid(node, "a repair has rdfs:label, kl:applicability and sh:update")
    try:
        update = _parsed(written)
        removed, added = (_template(each.tokens) for each in (update.removed, update.added))
    except NotSparql as error:
        raise located(graph, node, written, error) from error
    variables = sorted({word[1:] for word in tokens(written, prefixes()) if is_variable(word)})
    names = " ".join(f"?{name}" for name in variables) or "*"
    return Repair(
        title=title,
        applicability=APPLICABILITY[claimed],
        update=dedent(written).strip(),
        query=f"SELECT DISTINCT {names} {{ {KNOWN} LATERAL {render(update.group)} }}",
        variables=tuple(variables),
        assigned=tuple(sorted(name[1:] for name in assigned(update.group))),
        removed=removed,
        added=added,
        terms=tuple(sorted(prefixed(written, prefixes()))),
        why=" ".join(text(iri(f"{RDFS}comment")).split()),
        formats=tuple(sorted(map(literal_value, graph.values(node, iri(f"{KL}format"))))),
        order=float(text(sh("order")) or 0),
    )


@cache
def prefixes() -> Mapping[str, str]:
    """Return the namespaces of the prefixes that all rules share."""
    graph = read([resources.data("shapes") / "prefixes.ttl"])
    return namespaces(graph, iri(f"{KL}prefixes"))


def _parsed(written: str) -> Update:
    update = parse_update(written, prefixes())
    if refused := refused_update(render(update), written, prefixes()):
        raise refused
    if any(word.startswith("_:") or word == "[" for word in update.removed.tokens):
        raise NotSparql("DELETE cannot name a blank node")
    return update


def _template(words: tuple[str, ...]) -> tuple[Triple, ...]:
    """Return the triples of a template, each once, in the order of the text.

    What is said of a blank node follows what leads to it; such nodes are numbered in that order.
    """
    triples = list(dict.fromkeys(template(words)))
    led = {value for _, _, value in triples if is_blank(value)}
    about = {node: [each for each in triples if each[0] == node] for node in led}

    def stated(found: Iterable[Triple]) -> Iterator[Triple]:
        for each in found:
            yield each
            yield from stated(about.pop(each[2], ()))

    ordered = dict.fromkeys((*stated(each for each in triples if each[0] not in led), *triples))
    labels = dict.fromkeys(term for triple in ordered for term in triple if is_blank(term))
    names = {label: blank(str(number)) for number, label in enumerate(labels)}
    return tuple((names.get(s, s), p, names.get(o, o)) for s, p, o in ordered)
