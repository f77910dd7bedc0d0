"""The identity of findings: stable when text moves, and one for each finding of a run."""

from __future__ import annotations

from collections import Counter

from kinlint.addresses import is_address
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace


class Fingerprints:
    """Gives each finding of a run, in their order, an identity that no other has."""

    def __init__(self) -> None:
        self._seen: Counter[str] = Counter()

    def fingerprint(self, finding: Finding) -> str:
        """Return the fingerprint of *finding*, with `:n` for the n-th equal one.

        It does not depend on the place. Two files that say the same wrong thing of the same entity
        make equal findings.
        """
        if is_address(finding.iri):  # it changes when the file is moved
            finding = replace(finding, iri="")
        same = finding.fingerprint
        self._seen[same] += 1
        number = self._seen[same]
        return same if number == 1 else f"{same}:{number}"
