"""OWL axioms as rules over triples: what must hold (body), what then holds (head)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from kinlint.light_dataclasses import dataclass
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri, is_literal, literal_value
from kinlint.vocabulary import INFERRED_GRAPH

Pattern = Triple
"""A triple in which a term may be a variable, such as `?x`."""


@dataclass(frozen=True, slots=True)
class Axiom:
    """An OWL axiom as a rule: if all patterns of its body hold, its head holds."""

    label: str
    """The axiom in words."""
    body: tuple[Pattern, ...]
    """The premises."""
    head: Pattern
    """The conclusion."""
    stratum: int = 0
    """Axioms are evaluated by ascending strata."""
    recursive: bool = False
    """It feeds itself, or others of its stratum that feed it."""

    @property
    def update(self) -> str:
        """The SPARQL update that infers everything the axiom gives, once."""
        return insertion(self, INFERRED_GRAPH)

    def to_json(self) -> dict[str, Any]:
        """Return the axiom in values that JSON can say."""
        return {
            "label": self.label,
            "body": [list(pattern) for pattern in self.body],
            "head": list(self.head),
            "stratum": self.stratum,
            "recursive": self.recursive,
        }

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> Axiom:
        """Return the axiom that `to_json` said."""
        return cls(
            label=value["label"],
            body=tuple((s, p, o) for s, p, o in value["body"]),
            head=(value["head"][0], value["head"][1], value["head"][2]),
            stratum=value["stratum"],
            recursive=value["recursive"],
        )


def insertion(axiom: Axiom, into: Term, delta: tuple[int, Term] | None = None) -> str:
    """Return the SPARQL update that adds to the graph *into* what *axiom* gives and nobody states.

    With *delta*, a position in the body and a graph, that pattern is matched in that graph only.
    """
    where = [
        f"GRAPH {delta[1] if delta and delta[0] == index else f'?g{index}'} {{ {_text(pattern)} }}"
        for index, pattern in enumerate(axiom.body)
    ]
    head = _text(axiom.head)
    return (
        f"INSERT {{ GRAPH {into} {{ {head} }} }} WHERE {{ {' '.join(where)} "
        f"FILTER NOT EXISTS {{ GRAPH ?h {{ {head} }} }} }}"
    )


def _text(pattern: Pattern) -> str:
    return " ".join(pattern)


def is_variable(term: Term) -> bool:
    """Tell whether *term* is a variable of a pattern."""
    return term.startswith("?")


def unify(pattern: Pattern, other: Pattern) -> bool:
    """Tell whether a triple can match both patterns; repeated variables are not compared."""
    return all(
        a == b or is_variable(a) or is_variable(b) for a, b in zip(pattern, other, strict=True)
    )


def match(pattern: Pattern, triple: Triple) -> dict[Term, Term] | None:
    """Return the variables of *pattern* for which it is *triple*, or None."""
    bindings: dict[Term, Term] = {}
    for part, term in zip(pattern, triple, strict=True):
        if is_variable(part):
            if bindings.setdefault(part, term) != term:
                return None
        elif part != term:
            return None
    return bindings


def instantiate(pattern: Pattern, bindings: Mapping[Term, Term]) -> Pattern:
    """Return *pattern* with the variables that *bindings* knows replaced."""
    subject, predicate, value = pattern
    return (
        bindings.get(subject, subject),
        bindings.get(predicate, predicate),
        bindings.get(value, value),
    )


def name(term: Term) -> str:
    """Return the label of *term* for people: the last part of an IRI, the text of a literal."""
    if is_literal(term):
        return literal_value(term)
    if is_iri(term):
        text = term[1:-1].rstrip("#/")
        return text[max(text.rfind("#"), text.rfind("/")) + 1 :]
    return term


def names_its_terms(axioms: Iterable[Axiom]) -> bool:
    """Tell whether all *axioms* name their properties and classes, so that changes select them."""
    patterns = (pattern for axiom in axioms for pattern in (*axiom.body, axiom.head))
    return not any(is_variable(p) or (p == RDF_TYPE and is_variable(o)) for _, p, o in patterns)
