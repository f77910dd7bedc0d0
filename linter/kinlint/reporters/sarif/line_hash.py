"""GitHub's fingerprint of a line: `primaryLocationLineHash`.

codeql-action hashes the 100 UTF-16 units that follow a line's start, without blanks and tabs
and with every line end as LF, as a polynomial in 37 modulo 2^64; the text is followed by 65535
and zeros. `:n` tells the n-th line with that hash. Ours must be equal to what it computes from
the file, or it warns.
"""

from __future__ import annotations

import re
from collections import Counter

from kinlint.text import SourceText

BLOCK = 100
_BASE = 37
_MODULUS = 1 << 64
_ASTRAL = re.compile("[\U00010000-\U0010ffff]")
_BLANKS = str.maketrans("", "", " \t")


class LineHashes:
    """The hashes of the lines of one source."""

    def __init__(self, source: SourceText) -> None:
        text = ("\ufeff" if source.bom else "") + source.text
        lines = text.replace("\r\n", "\n").replace("\r", "\n").translate(_BLANKS)
        self._units = _ASTRAL.sub(_pair, lines) + "\uffff" + "\0" * BLOCK
        self._starts = [0]
        while at := self._units.find("\n", self._starts[-1]) + 1:
            self._starts.append(at)
        self._occurrences: list[int] = []

    def line_hash(self, line: int) -> str:
        """The fingerprint of *line*, counted from one."""
        if not self._occurrences:
            seen: Counter[str] = Counter()
            for start in self._starts:
                block = self._units[start : start + BLOCK]
                seen[block] += 1
                self._occurrences.append(seen[block])
        start = self._starts[line - 1]
        value = 0
        for unit in self._units[start : start + BLOCK]:
            value = (value * _BASE + ord(unit)) % _MODULUS
        return f"{value:x}:{self._occurrences[line - 1]}"


def _pair(match: re.Match[str]) -> str:
    """The two UTF-16 units of a character beyond the Basic Multilingual Plane."""
    code = ord(match[0]) - 0x10000
    return chr(0xD800 + (code >> 10)) + chr(0xDC00 + (code & 0x3FF))
