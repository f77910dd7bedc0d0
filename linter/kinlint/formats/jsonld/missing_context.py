"""JSON-LD without a context: what else was meant as one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kinlint.formats.json_text.json_values import Key, Object, ParsedJson
from kinlint.suggestion import distance

CONTEXT = "@context"
FARTHEST = 2
"""Number of edits that make `@context` of a key that was meant as such."""


def lacks_context(parsed: ParsedJson) -> bool:
    """Tell whether no object of *parsed* has a context."""
    pending: list[Any] = [parsed.value]
    while pending:
        value = pending.pop()
        if isinstance(value, Mapping):
            if CONTEXT in value:
                return False
            pending += value.values()
        elif isinstance(value, list):
            pending += value
    return True


def misnamed_context(root: Any) -> Key | None:
    """Return the key of *root* that must have been meant as `@context`, such as `context`."""
    return next(_misnamed(root), None) if isinstance(root, Object) else None


def _misnamed(root: Object) -> Iterator[Key]:
    for key, value in root.items():
        near = isinstance(key, Key) and distance(key.casefold(), CONTEXT) <= FARTHEST
        if near and isinstance(key, Key) and isinstance(value, (str, list, Mapping)):
            yield key
