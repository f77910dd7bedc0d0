"""Completes what rule files leave out because it is the same in all of them.

- A constraint or repair with SPARQL has `sh:prefixes kl:prefixes`, those of `shapes/prefixes.ttl`.
- A repair is a `dash:SPARQLUpdateSuggestionGenerator`.
- A symptom, `kl:symptom "AP2.3"`, is one of its anti-pattern: `kl:antiPattern kl:AP2`.
- `kl:format "graph"` stands for the formats of RDF graphs that people write.
- A message may stand on several lines, which are one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.engine.compiler.shacl_terms import RULE_CLASS, TYPE, sh
from kinlint.formats.records import GRAPHS
from kinlint.terms import Term, Triple, iri, literal, literal_value
from kinlint.vocabulary import DASH, KL

PREFIXES = sh("prefixes"), iri(f"{KL}prefixes")
QUERIES = frozenset(map(sh, ("select", "ask", "construct", "update")))
GENERATOR = iri(f"{DASH}suggestionGenerator")
GENERATES = TYPE, iri(f"{DASH}SPARQLUpdateSuggestionGenerator")
SYMPTOM, ANTI_PATTERN = iri(f"{KL}symptom"), iri(f"{KL}antiPattern")
FORMAT, GRAPH = iri(f"{KL}format"), literal("graph")
MESSAGE = sh("message")
WRITTEN = tuple(form.name for form in GRAPHS if form.editor)
"""The formats of RDF graphs that people write, and that examples are in."""


def completed(triples: Sequence[Triple]) -> tuple[Triple, ...]:
    """Return *triples* with what follows from them; those of a file without a rule as they are."""
    if not any(value == RULE_CLASS and way == TYPE for _, way, value in triples):
        return tuple(triples)
    chosen = {node for node, way, _ in triples if way == PREFIXES[0]}
    found: dict[Triple, None] = {}
    for triple in triples:
        found |= dict.fromkeys(_spelled_out(triple))
        found |= dict.fromkeys(_implied(triple, chosen))
    return tuple(found)


def _spelled_out(triple: Triple) -> Iterator[Triple]:
    """Yield *triple* without abbreviations."""
    node, way, value = triple
    if way == FORMAT and value == GRAPH:
        yield from ((node, way, literal(name)) for name in WRITTEN)
    elif way == MESSAGE:
        yield node, way, _one_line(value)
    else:
        yield triple


def _implied(triple: Triple, chosen: set[Term]) -> Iterator[Triple]:
    """Yield what *triple* implies; the nodes *chosen* declare their prefixes."""
    node, way, value = triple
    if way in QUERIES and node not in chosen:
        yield node, *PREFIXES
    elif way == GENERATOR:
        yield value, *GENERATES
    elif way == SYMPTOM:
        family = literal_value(value).partition(".")[0]
        yield node, ANTI_PATTERN, iri(f"{KL}{family}")


def _one_line(message: Term) -> Term:
    text = literal_value(message)
    return literal(" ".join(text.split())) if "\n" in text else message
