"""Cache of contexts between files: documents found, and contexts processed."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any, TypeAlias

from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.context_resolver import Resolver
from kinlint.formats.options import ContextLibrary, ReadOptions

Context: TypeAlias = Any

MOST_KNOWN = 10_000
"""Contexts after which a cache is begun anew: each file may bring some of its own."""


class ContextCache:
    """Active contexts that depend on a library and on no file.

    They come from the initial context by documents of the library, by scoped contexts in those,
    and by the likes of `{"ex": "https://…#"}`, which are told apart by what they say. None holds
    a place in a text.
    """

    def __init__(self, library: ContextLibrary, *, strict: bool = False) -> None:
        self.resolver = Resolver(library, strict=strict)
        # With the context and the entry it was made of, which must live as long as their ids.
        self._known: dict[Hashable, tuple[Context, Any]] = {}
        self._ids: set[int] = set()

    @classmethod
    def from_options(cls, options: ReadOptions, release: str) -> ContextCache:
        """Return the memory of the library of *options*, one for each release and base."""
        library, about = options.contexts, (release, options.base)
        found: ContextCache | None = library.memory.get(about)
        if found is None or found.is_full:
            serves = library if release == library.release else library.at_release(release)
            found = library.memory[about] = cls(serves)
        return found

    @property
    def is_full(self) -> bool:
        """True if there are as many contexts as may be kept."""
        return len(self._known) > MOST_KNOWN

    def begin(self, initial: Context) -> None:
        """Cache *initial*, the context in which every file begins."""
        self._ids.add(id(initial))
        self._known[id(initial)] = (initial, None)

    def key(self, active: Context, entry: Any) -> tuple[Hashable, ...] | None:
        """Return the cache key of *entry* on top of *active*; None if it depends on a file."""
        if id(active) not in self._ids:
            return None
        if isinstance(entry, str):
            return id(active), str(entry)
        if not isinstance(entry, (Object, Array)):
            return id(active), id(entry)
        entries = tuple(entry.items()) if isinstance(entry, Object) else None
        if entries is None or any(not isinstance(value, str) for _, value in entries):
            return None
        return id(active), tuple((str(term), str(value)) for term, value in entries)

    def get(self, key: Hashable) -> Context | None:
        """Return the context remembered by *key*."""
        found = self._known.get(key)
        return found[0] if found else None

    def keep(self, key: Hashable, result: Context, entry: Any) -> None:
        """Remember *result*."""
        self._ids.add(id(result))
        self._known[key] = (result, entry if not isinstance(entry, Object) else None)


def unplaced(entry: Any) -> Any:
    """Return a context of mere strings without their places; any other as it is."""
    if isinstance(entry, Object):
        return {str(term): str(value) for term, value in entry.items()}
    return entry
