"""Comparison of lost words with terms: of their contexts, and of other releases."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from kinlint.contexts.context_library import known_terms
from kinlint.formats.json_text.json_values import Text
from kinlint.formats.jsonld.active_context import FAULTS, Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.expansion_record import DroppedKey
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.resemblance import Terms, nearest_class, nearest_property
from kinlint.formats.jsonld.traced_values import Iri, Origin
from kinlint.formats.jsonld.type_scopes import TypeScopes
from kinlint.formats.options import ReadOptions

MAPPED = re.compile(r"([A-Za-z][A-Za-z0-9+-.]*|_):[^\s]*$|@[a-z]+$")
"""IRIs and keywords, as which expansion leaves a key that means something."""


class OtherRelease:
    """The contexts in force at the objects of a file, had it been read under *release*."""

    def __init__(self, release: str, options: ReadOptions, local: LocalContexts) -> None:
        self.release = release
        memory = ContextCache.from_options(options, release)
        self._processor = Processor(memory, options.base, local)
        self._at: dict[Origin, tuple[Context, Context]] = {}

    def key_iri(self, key: Text, origin: Origin) -> str | None:
        """Return what the release makes of *key* on the node of *origin*; None if nothing."""
        return self._meaning(self._contexts(origin)[0], key)

    def type_iri(self, name: Text, origin: Origin) -> str | None:
        """Return the type that the release makes of *name*; None if none."""
        return self._meaning(self._contexts(origin)[1], name)

    def _meaning(self, context: Context, name: str) -> str | None:
        found = self._processor._expand_iri(context, str(name), None, vocab=True)  # noqa: SLF001
        return found if isinstance(found, str) and MAPPED.match(found) else None

    def _contexts(self, origin: Origin) -> tuple[Context, Context]:
        """Return the active context for the keys of *origin*, and the one for its types."""
        if origin not in self._at:
            processor = self._processor
            if origin.parent is None:
                outer = processor._get_initial_context(processor.options)  # noqa: SLF001
            else:
                outer = self._contexts(origin.parent)[0]
            self._at[origin] = self._inner(outer, origin)
        return self._at[origin]

    def _inner(self, outer: Context, origin: Origin) -> tuple[Context, Context]:
        """Return the contexts after those of an object.

        Steps 3 and 7 to 11 of the expansion algorithm.
        """
        processor: Any = self._processor
        try:
            outer = processor.entering(outer, origin.prop)
            processor.trail.append(origin)
            keys, _, types = processor._prepare_nested_context(  # noqa: SLF001
                outer, origin.element, processor.options
            )
            processor.trail.pop()
        except FAULTS:
            return outer, outer
        return keys, types


LOOKED_UP = 1_000
"""Number of lost words that are compared with the terms of their contexts."""


class ReleaseComparison:
    """Comparison of lost words with the terms of their contexts, and of other releases."""

    def __init__(self, options: ReadOptions, local: LocalContexts) -> None:
        self._options = options
        self._local = local
        self._releases: list[OtherRelease] | None = None
        self._near: dict[tuple[int, str], str | None] = {}
        self.scopes = TypeScopes()
        """The types of keys, by the contexts of the file."""

    @property
    def looked_up(self) -> int:
        """Return the number of words compared so far."""
        return len(self._near)

    def others(self, *, named: bool) -> list[OtherRelease]:
        """Return the other releases, if a context is *named* that they might have."""
        if self._releases is None:
            current = self._options.contexts.release
            names = self._options.releases if named else ()
            self._releases = [
                OtherRelease(each, self._options, self._local) for each in names if each != current
            ]
        return self._releases

    def contexts_below(self, iri: str) -> str:
        """Return the names of known contexts in the folder that the unknown *iri* is called as."""
        return ", ".join(self._options.contexts.below(iri))

    def nearest_property(self, drop: DroppedKey) -> str | None:
        """Return the property that a lost key resembles, unless its object has that already.

        A key that some metamodel has is no slip: its context is missing.
        """
        terms = drop.resolution.terms
        if drop.key in known_terms()[1]:
            return None
        near = self._looked_up(drop.key, terms, lambda: nearest_property(drop.key, terms, ()))
        return None if near in drop.origin.element else near

    def nearest_class(self, written: Iri) -> str | None:
        """Return the class that a lost type resembles, if no metamodel has that type."""
        terms = written.resolution.terms
        if written.token in known_terms()[0]:
            return None
        return self._looked_up(written.token, terms, lambda: nearest_class(written.token, terms))

    def _looked_up(self, word: str, terms: Terms, look: Callable[[], str | None]) -> str | None:
        """Return what *look* finds for *word*, as long as few words have been looked up."""
        key = id(terms), str(word)
        if key not in self._near and len(self._near) < LOOKED_UP:
            self._near[key] = look()
        return self._near.get(key)
