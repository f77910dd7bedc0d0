"""The globs without `{a,b}` that a glob stands for."""

from __future__ import annotations

import re
from collections.abc import Iterator

_ALTERNATIVES = re.compile(r"\{([^{}]*)\}")


def alternatives(pattern: str) -> Iterator[str]:
    """Yield the patterns without `{a,b}` that mean *pattern* together."""
    match = _ALTERNATIVES.search(pattern)
    if match is None:
        yield pattern
        return
    for choice in match[1].split(","):
        yield from alternatives(pattern[: match.start()] + choice + pattern[match.end() :])
