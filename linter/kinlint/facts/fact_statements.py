"""How facts are stated: predicates, numbers and names of fact nodes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import FACT


def fact(name: str) -> Term:
    """The property of facts called *name*."""
    return iri(FACT + name)


DERIVED_FROM = fact("derived-from")
MEMBER = fact("member")


def fact_node(kind: str, number: int) -> Term:
    """The name of the fact node of *kind* with *number*, the same in every run."""
    return iri(f"urn:kinlint:fact:{kind}:{number}")


def double(value: float) -> Term:
    """The literal of a finite number."""
    return f'"{float(value)!r}"^^<{XSD}double>'


def integer(value: int) -> Term:
    """The literal of a count."""
    return literal(str(value), f"{XSD}integer")


def numbers(subject: Term, values: Iterable[tuple[str, float]]) -> Iterator[Triple]:
    """What *values* say of *subject*; numbers that left the range of a double say nothing."""
    for name, value in values:
        if math.isfinite(value):
            yield subject, fact(name), double(value)


def derived(subject: Term, sources: Iterable[Term]) -> Iterator[Triple]:
    """That *subject* rests on *sources*, each named once."""
    for source in dict.fromkeys(sources):
        yield subject, DERIVED_FROM, source
