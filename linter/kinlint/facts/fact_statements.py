"""Statements of facts: predicates, numbers and names of fact nodes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import FACT


def fact(name: str) -> Term:
    """Return the property of facts called *name*."""
    return iri(FACT + name)


DERIVED_FROM = fact("derived-from")
MEMBER = fact("member")


def fact_node(kind: str, number: int) -> Term:
    """Return the name of the fact node of *kind* with *number*, the same in every run.

    Names are sorted as the numbers are: which is first does not depend on what else is judged.
    """
    return iri(f"urn:kinlint:fact:{kind}:{number:06}")


def double(value: float) -> Term:
    """Return the literal of a finite number."""
    return f'"{float(value)!r}"^^<{XSD}double>'


def integer(value: int) -> Term:
    """Return the literal of a count."""
    return literal(str(value), f"{XSD}integer")


def numbers(subject: Term, values: Iterable[tuple[str, float]]) -> Iterator[Triple]:
    """Yield a fact for each of *values* of *subject* within the range of a double."""
    for name, value in values:
        if math.isfinite(value):
            yield subject, fact(name), double(value)


def derived(subject: Term, sources: Iterable[Term]) -> Iterator[Triple]:
    """Yield that *subject* is derived from *sources*, each named once."""
    for source in dict.fromkeys(sources):
        yield subject, DERIVED_FROM, source
