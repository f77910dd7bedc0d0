"""Conversion of offsets from bytes to characters."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from heapq import merge

LETTER = re.compile(r"[^\x00-\x7f]")


class Offsets:
    """Turns the offsets of bytes in UTF-8 into offsets of characters.

    *inserted* are the characters of *text*, in order, that are to count for nothing; all of them
    are ASCII.
    """

    def __init__(self, text: str, inserted: Sequence[int] = ()) -> None:
        self._bytes: list[int] = []
        self._extra: list[int] = [0]
        if text.isascii() and not inserted:
            return
        wide = (
            (match.start(), len(match[0].encode("utf-8", "surrogatepass")) - 1)
            for match in LETTER.finditer(text)
        )
        bytes_, extra = 0, 0
        for at, more in merge(wide, ((at, 0) for at in inserted)):
            self._bytes.append(at + bytes_)
            bytes_ += more
            extra += more or 1
            self._extra.append(extra)

    def __call__(self, byte: int) -> int:
        """The offset of the character that begins at *byte*."""
        if not self._bytes:
            return byte
        return byte - self._extra[bisect_right(self._bytes, byte - 1)]
