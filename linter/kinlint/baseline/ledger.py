"""Tells new findings from known ones."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence

from kinlint.baseline.entry_identity import Entry, Names, entry_of
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass


def _nothing(_path: str) -> bool:
    return False


def _any(_one: Entry) -> bool:
    return True


@dataclass(frozen=True)
class Ledger:
    """Known findings, to compare others with."""

    entries: Sequence[Entry]
    """The known findings."""
    names: Names
    """Names of paths in them."""
    gone: Callable[[str], bool] = _nothing
    """Test of a path for a file that no longer exists, and so may have been renamed."""
    composed: Sequence[str] = ()
    """Files that composed a model when these were found."""

    def new(self, findings: Iterable[Finding]) -> list[Finding]:
        """Return the *findings* that were not known, in their order."""
        return self.compared(findings)[0]

    def compared(self, findings: Iterable[Finding]) -> tuple[list[Finding], list[Entry]]:
        """Return the *findings* that were not known, and the entries without a finding.

        Each entry matches one finding: in its file, or else in another one if its own is gone, or
        else in any other one if the entity has an IRI of its own.
        """
        found = [(finding, entry_of(finding, self.names)) for finding in findings]
        left = dict(enumerate(self.entries))
        steps: tuple[tuple[_Key, _Admits, _Admits], ...] = (
            (lambda one: (one.path, one.fingerprint), _any, _any),
            (lambda one: one.fingerprint, _any, lambda entry: self.gone(entry.path)),
            (lambda one: one.fingerprint, lambda one: one.elsewhere, _any),
        )
        for key, seeks, serves in steps:
            if not found:
                break
            waiting: dict[object, list[int]] = defaultdict(list)
            for number in reversed(left):
                if serves(left[number]):
                    waiting[key(left[number])].append(number)
            rest = []
            for finding, one in found:
                if seeks(one) and (numbers := waiting.get(key(one))):
                    del left[numbers.pop()]
                else:
                    rest.append((finding, one))
            found = rest
        return [finding for finding, _ in found], list(left.values())


_Key = Callable[[Entry], object]
_Admits = Callable[[Entry], bool]
