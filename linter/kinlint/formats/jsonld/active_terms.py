"""Terms of the context that is active at a place of a file, which may be unfinished."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from kinlint.formats.jsonld.active_context import FAULTS
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.reader import undisturbed
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText


class ActiveTerm(NamedTuple):
    """A term that a context defines."""

    name: str
    """The term."""
    iri: str
    """The IRI that it stands for."""
    is_prefix: bool
    """True if it can begin a compact IRI."""
    coercion: str
    """The type that its values are coerced to: `@id`, `@vocab`, a datatype or nothing."""
    is_scoped: bool
    """True if it holds here only by a type of the object, or by the property that leads to it."""


class Level(NamedTuple):
    """An object around a place."""

    key: str | None
    """The key of which the object is a value; None for the outermost."""
    node: Mapping[str, Any]
    """Its `@context` and types, under the keys that it has."""


@dataclass(frozen=True)
class ActiveTerms:
    """The terms that are active at a place."""

    terms: Sequence[ActiveTerm] = ()
    """The terms, in the order of the contexts."""
    base: str = ""
    """The IRI that values are relative to; empty if it is that of the file."""

    @cached_property
    def by_name(self) -> Mapping[str, ActiveTerm]:
        """The terms by name."""
        return {each.name: each for each in self.terms}

    @cached_property
    def _by_iri(self) -> Mapping[str, str]:
        return {each.iri: each.name for each in reversed(self.terms)}

    def expand(self, name: str) -> str:
        """Return the IRI that *name*, a key or a type, stands for; *name* if it is none."""
        if (term := self.by_name.get(name)) is not None:
            return term.iri
        prefix, colon, rest = name.partition(":")
        term = self.by_name.get(prefix) if colon and not rest.startswith("//") else None
        return name if term is None else f"{term.iri}{rest}"

    def spell(self, iri: str, *, vocabulary: bool) -> str | None:
        """Return how a value is written that is to be *iri*.

        By a term if values are taken for terms (*vocabulary*), below the base, or with a prefix;
        whole if nothing fits.
        """
        if vocabulary and iri in self._by_iri:
            return self._by_iri[iri]
        if self.base and iri.startswith(self.base) and ":" not in iri[len(self.base) :]:
            return iri[len(self.base) :]
        fitting = [t for t in self.terms if t.is_prefix and iri.startswith(t.iri) and iri != t.iri]
        if fitting:
            best = max(fitting, key=lambda each: len(each.iri))
            return f"{best.name}:{iri[len(best.iri) :]}"
        return iri


def active_terms(
    source: SourceText, options: ReadOptions, levels: Sequence[Level], key: str | None = None
) -> ActiveTerms:
    """Return the terms that are active in the innermost of *levels*, or in its member *key*.

    A context that is unknown or invalid defines what can be made of it.
    """
    local = LocalContexts(source, options)
    memory = ContextCache.from_options(options, options.contexts.release)
    processor = Processor(memory, options.base, local)
    with undisturbed():
        try:
            return _active(processor, levels, key)
        except FAULTS:
            return ActiveTerms()


def _active(processor: Processor, levels: Sequence[Level], key: str | None) -> ActiveTerms:
    active = plain = processor.initial
    for level in levels:
        if level.key is not None:
            active = processor.entering(active, level.key)
        own = {k: v for k, v in level.node.items() if k == "@context"}
        plain = processor.nested_context(active, own) if own else active
        active = processor.nested_context(active, level.node)
    if key is not None:
        active = processor.entering(active, key)
    base = active.get("@base")
    return ActiveTerms(
        tuple(_terms(active["mappings"], plain["mappings"])),
        base if isinstance(base, str) and base != processor.options["base"] else "",
    )


def _terms(mappings: Mapping[str, Any], general: Mapping[str, Any]) -> Iterator[ActiveTerm]:
    """Yield the terms of *mappings*; those that *general* has not are scoped."""
    for name, meaning in mappings.items():
        if meaning is None or meaning.get("@id") is None or meaning.get("reverse"):
            continue
        before = general.get(name)
        yield ActiveTerm(
            str(name),
            str(meaning["@id"]),
            is_prefix=bool(meaning.get("_prefix")),
            coercion=str(meaning.get("@type") or ""),
            is_scoped=before is None or before.get("@id") != meaning["@id"],
        )
