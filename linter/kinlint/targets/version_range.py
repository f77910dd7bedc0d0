"""Versions of consumers, and the ranges of them in which one behaves alike."""

from __future__ import annotations

import re
from typing import NamedTuple, TypeAlias

Version: TypeAlias = tuple[int, ...]
"""The numbers of a version, without zeros at the end: (3, 3) of 3.3 and of 3.3.0."""

VERSION = re.compile(r"\d{1,9}(\.\d{1,9}){0,5}", re.ASCII)
"""Spelling of a version: up to six numbers, separated by points."""


def read_version(text: str) -> Version:
    """Return the version that *text* spells. Raises `ValueError` if it spells none."""
    if not VERSION.fullmatch(text):
        raise ValueError(text)
    numbers = [int(part) for part in text.split(".")]
    while len(numbers) > 1 and numbers[-1] == 0:
        numbers.pop()
    return tuple(numbers)


class VersionRange(NamedTuple):
    """The versions from one on, to before another."""

    since: str = ""
    """The first version of the range; empty if it has none."""
    until: str = ""
    """The first version after the range; empty if it has none."""

    def has(self, version: Version | None) -> bool:
        """Tell whether *version* is in the range; None is later than all that are known."""
        if version is None:
            return not self.until
        late = not self.since or read_version(self.since) <= version
        return late and (not self.until or version < read_version(self.until))

    @property
    def words(self) -> str:
        """Return the range as it follows the name of a consumer: ` before 3.5`; empty for all."""
        if self.since and self.until:
            return f" from {self.since} to before {self.until}"
        if self.since:
            return f" from {self.since} on"
        return f" before {self.until}" if self.until else ""


ALL = VersionRange()
"""The range of all versions."""
