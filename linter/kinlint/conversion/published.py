"""Terms of the published contexts, in the order a reader expects them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from kinlint.contexts.context_dsl import UNCOERCED
from kinlint.contexts.context_library import NEWEST, bundled_source
from kinlint.contexts.declarations import terms
from kinlint.light_dataclasses import dataclass

FIRST = (
    "geometry/structural-entities",
    "geometry/spatial-relations",
    "geometry/coordinates",
    "kinematic-chain/structural-entities",
    "kinematics",
    "actuation",
)
"""Documents in the order in which a robot is described; the others follow as they are bundled."""

REFERENCE, MEASURE, NUMBER = range(3)
"""The order of the keys of a node: what it belongs to, in what it is measured, and its numbers."""


class Line(NamedTuple):
    """A term as one context defines it."""

    context: str
    """The name of the context."""
    name: str
    """The term."""
    iri: str
    """The IRI that it stands for."""
    words: tuple[str, ...] | None
    """Words of its notation; None for a class."""


@dataclass(frozen=True, slots=True)
class Published:
    """A class or property of the published contexts."""

    contexts: tuple[str, ...]
    """Contexts that define it, the least of them first."""
    coercion: str = ""
    """The datatype that contexts give to its values; "" where they give none."""
    is_property: bool = False
    """True for a property."""


@cache
def context_terms() -> tuple[Line, ...]:
    """All terms of the newest contexts that go together, in order."""
    return tuple(_lines())


def _lines() -> Iterator[Line]:
    known: dict[str, dict[str, Any]] = {}
    for name in (NEWEST, "kinlint"):
        source = bundled_source(name)
        paths = source["composable"] if "composable" in source else source["documents"]
        known.update(dict.fromkeys(paths, source))
    for path in sorted(known, key=lambda path: FIRST.index(path) if path in FIRST else len(FIRST)):
        base, document = known[path]["base"], known[path]["documents"][path]
        for name, iri, line in terms(base, path, document):
            words = None if line is None else tuple(line.partition("one of ")[0].split())
            yield Line(f"{base}{path}.json", name, iri, words)


@cache
def published_terms() -> Mapping[str, Published]:
    """Each class and property by its IRI."""
    contexts: dict[str, dict[str, None]] = {}
    found: dict[str, Published] = {}
    for context, _, iri, words in context_terms():
        contexts.setdefault(iri, {})[context] = None
        coercion = next((word for word in words or () if word.startswith("xsd:")), "")
        found.setdefault(iri, Published((), coercion, is_property=words is not None))
    return {
        iri: Published(tuple(contexts[iri]), one.coercion, one.is_property)
        for iri, one in found.items()
    }


@cache
def term_order() -> Mapping[str, tuple[int, int]]:
    """Return the rank of each term among the types, or among the keys, of a node."""
    found: dict[str, tuple[int, int]] = {}
    for number, (context, name, _, words) in enumerate(context_terms()):
        found.setdefault(name, (_group(context, words or ()), number))
    return found


def _group(context: str, words: Collection[str]) -> int:
    if context.endswith("/qudt.json"):
        return MEASURE
    coerced = any(word.startswith("xsd:") or word in UNCOERCED for word in words)
    return NUMBER if coerced else REFERENCE


def contexts_for(used: Collection[str]) -> tuple[str, ...]:
    """The contexts, in order, that define all terms *used*; few, and those of the classes first."""
    known = published_terms()
    needed: set[str] = set()
    for iri in sorted(used, key=lambda iri: known[iri].is_property):
        if needed.isdisjoint(known[iri].contexts):
            needed.add(known[iri].contexts[0])
    every = dict.fromkeys(line.context for line in context_terms())
    return tuple(context for context in every if context in needed)
