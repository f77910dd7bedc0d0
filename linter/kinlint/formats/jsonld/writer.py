"""Writes nodes in the terms of published contexts, by PyLD's framing."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import Any, TypeAlias

from kinlint.formats.jsonld.context_resolver import Resolver
from kinlint.formats.jsonld.pyld import JsonLdProcessor
from kinlint.formats.options import ContextLibrary

Node: TypeAlias = dict[str, Any]

FLAT: Mapping[str, Any] = {"@embed": "@never", "@type": {}}
"""A frame of all nodes that have a type, as neighbours rather than inside of each other."""


def framed(
    nodes: Sequence[Node], context: Sequence[str | Mapping[str, str]], library: ContextLibrary
) -> list[Node]:
    """Return *nodes*, given as expanded JSON-LD, under *context*, ordered by identifier.

    Raises JsonLdError where *library* has no such context.
    """
    options = {
        "base": "",
        "contextResolver": Resolver(library, strict=True),
        "documentLoader": None,
        "omitGraph": False,
    }
    frame = {"@context": list(context), **FLAT}
    found: list[Node] = _Framing().frame(list(nodes), frame, options)["@graph"]
    return found


class _Framing(JsonLdProcessor):  # type: ignore[misc]
    """Combines the contexts that types bring along once, and not for each node."""

    def __init__(self) -> None:
        super().__init__()
        self._combined: dict[Hashable, tuple[Any, Any, Any]] = {}

    def _process_context(self, active_ctx: Any, local_ctx: Any, options: Any, **flags: Any) -> Any:
        key = id(active_ctx), id(local_ctx), *sorted(map(str, flags.items()))
        known = self._combined.get(key)
        if known is None:
            result = super()._process_context(active_ctx, local_ctx, options, **flags)
            # Both live as long as what is known by their addresses.
            known = self._combined[key] = active_ctx, local_ctx, result
        return known[2]
