"""Dependencies of a query: the terms by which it finds triples."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import lru_cache

from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.light_dataclasses import dataclass
from kinlint.sparql.ast import Group, Select
from kinlint.sparql.parser import parse
from kinlint.sparql.patterns import Pattern
from kinlint.sparql.tokens import is_variable, tokens
from kinlint.sparql.variables import iris, triple_patterns
from kinlint.terms import RDF_TYPE, Term, is_iri

BELOW = (SUBCLASS, "*")
CLASSES, PROPERTIES = "c", "p"
"""Letters of `Constraint.sweeps`."""


@dataclass(frozen=True)
class Dependencies:
    """The properties and classes that a query names, and whether it matches all of either."""

    terms: frozenset[Term]
    """Properties and classes that the query names."""
    any_class: bool
    """True if it matches instances of any class."""
    any_property: bool
    """True if it matches any property."""

    @classmethod
    def from_constraint(cls, constraint: Constraint) -> Dependencies:
        """Return what the query of *constraint* may look at; every IRI in its text counts."""
        return cls(
            frozenset(PLAIN.findall(constraint.select)),
            CLASSES in constraint.sweeps,
            PROPERTIES in constraint.sweeps,
        )

    def looks_at(self, properties: Collection[Term], classes: Collection[Term]) -> bool:
        """Tell whether triples of *properties*, and of being of *classes*, may matter.

        *classes* have those with them that they are below.
        """
        return bool(
            (self.any_property and (properties or classes))
            or (self.any_class and classes)
            or not self.terms.isdisjoint(properties)
            or not self.terms.isdisjoint(classes)
        )


@lru_cache(maxsize=1024)
def dependencies(select: str) -> Dependencies:
    """Return all that the query *select* may look at, be it there or not."""
    return dependencies_of(parse(tokens(select, {})))


def dependencies_of(query: Select | Group) -> Dependencies:
    """Return all that *query* may look at, be it there or not."""
    found = triple_patterns(query)
    return Dependencies(
        frozenset(iris(query)),
        any(_unnamed(found)),
        any(is_variable(path[0]) or "!" in path for _, path, _ in found),
    )


def sweeps(select: str) -> str:
    """Return what `Constraint.sweeps` says of the query *select*."""
    found = dependencies(select)
    return CLASSES * found.any_class + PROPERTIES * found.any_property


def _unnamed(found: Collection[Pattern]) -> Iterable[bool]:
    """Yield for each class of a pattern whether it is not named, nor one that it is below."""
    named = {s for s, path, o in found if path == BELOW and is_iri(o)}
    return (
        not is_iri(value) and value not in named for _, path, value in found if RDF_TYPE in path
    )
