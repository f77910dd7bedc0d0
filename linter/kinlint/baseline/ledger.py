"""Tells new findings from known ones."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from kinlint.baseline.entry_identity import Known, Names, known
from kinlint.model import Finding


def _nothing(_path: str) -> bool:
    return False


def _any(_one: Known) -> bool:
    return True


@dataclass(frozen=True)
class Ledger:
    """What was known, with paths as `names` has them.

    `gone` tells of a path whether the file is there no more, so that it may have been renamed.
    """

    entries: Sequence[Known]
    names: Names
    gone: Callable[[str], bool] = _nothing

    def new(self, findings: Iterable[Finding]) -> list[Finding]:
        """Those of *findings* that were not known, in their order."""
        return self.compared(findings)[0]

    def compared(self, findings: Iterable[Finding]) -> tuple[list[Finding], list[Known]]:
        """Those of *findings* that were not known, and what of that is found no more.

        Each entry knows one finding again: in its file, or else in another one if its own is gone,
        or else in any other one if the entity has an IRI of its own.
        """
        found = [(finding, known(finding, self.names)) for finding in findings]
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


_Key = Callable[[Known], object]
_Admits = Callable[[Known], bool]
