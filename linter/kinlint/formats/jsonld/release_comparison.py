"""Asks other releases of the contexts what they make of a key or type that is lost."""

from __future__ import annotations

import re
from typing import Any

from kinlint.formats.json_text.json_values import Text
from kinlint.formats.jsonld.active_context import FAULTS, Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.traced_values import Origin
from kinlint.formats.options import ReadOptions

_MAPPED = re.compile(r"([A-Za-z][A-Za-z0-9+-.]*|_):[^\s]*$|@[a-z]+$")


class OtherRelease:
    """The contexts in force at the objects of a file, had it been read under *release*."""

    def __init__(self, release: str, options: ReadOptions) -> None:
        self.release = release
        self._processor = Processor(ContextCache.from_options(options, release), options.base)
        self._at: dict[Origin, tuple[Context, Context]] = {}

    def maps_key(self, key: Text, origin: Origin) -> bool:
        """Tell whether the release maps *key* on the node of *origin*."""
        return self._means(self._contexts(origin)[0], key, None)

    def maps_type(self, name: Text, origin: Origin) -> bool:
        """Tell whether *name* is a type in the release."""
        return self._means(self._contexts(origin)[1], name, None)

    def _means(self, context: Context, name: str, base: str | None) -> bool:
        found = self._processor._expand_iri(context, str(name), base, vocab=True)  # noqa: SLF001
        return isinstance(found, str) and _MAPPED.match(found) is not None

    def _contexts(self, origin: Origin) -> tuple[Context, Context]:
        """The active context for the keys of *origin*, and the one for its types."""
        if origin not in self._at:
            processor = self._processor
            if origin.parent is None:
                outer = processor._get_initial_context(processor.options)  # noqa: SLF001
            else:
                outer = self._contexts(origin.parent)[0]
            self._at[origin] = self._inner(outer, origin)
        return self._at[origin]

    def _inner(self, outer: Context, origin: Origin) -> tuple[Context, Context]:
        """Steps 3 and 7 to 11 of the expansion algorithm: what an object adds to its contexts."""
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
