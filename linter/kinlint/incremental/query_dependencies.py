"""What a query looks at: the terms by which it finds triples."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass
from functools import lru_cache

from kinlint.engine.compiler.names import SUBCLASS
from kinlint.engine.required_terms import ANY, HEAD, TERM
from kinlint.sparql.tokens import tokens
from kinlint.terms import RDF_TYPE, Term

_TYPE = rf"(?:(?<![\w?$:<#\"'])a(?![\w:])|{re.escape(RDF_TYPE)})"
_CLASSES = rf"{re.escape(SUBCLASS)} ?\* <[^<>]*>"
_ANY_CLASS = re.compile(
    rf"{_TYPE} ?(?!<[^<>]*>(?! ,)|/ ?{_CLASSES}|\?(k_\w+) \}} LATERAL \{{ \?\1 {_CLASSES})"
)
"""A class that is not named, neither itself nor as one that it is below."""


@dataclass(frozen=True)
class Dependencies:
    """The properties and classes that a query names, and whether it matches all of either."""

    terms: frozenset[Term]
    any_class: bool
    any_property: bool

    def looks_at(self, properties: Collection[Term], classes: Collection[Term]) -> bool:
        """Whether triples of *properties*, and of being of *classes*, may matter.

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
    """What the query *select* looks at, at most; of what it does not find, that it is not there."""
    spelled = HEAD.sub(" ", " ".join(tokens(select, {})) if "PREFIX" in select else select)
    return Dependencies(
        frozenset(TERM.findall(spelled)),
        _ANY_CLASS.search(spelled) is not None,
        ANY.search(spelled) is not None,
    )
