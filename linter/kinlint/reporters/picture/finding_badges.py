"""Findings by the part of the robot they are about, and the badges that mark the parts."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.rule import Severity
from kinlint.structure import Structure
from kinlint.text import Location

Marks: TypeAlias = Mapping[str, Sequence[Finding]]
"""The findings of each part, by its IRI, and of the robot itself by its own; the worst first."""

SIGNS: Mapping[Severity, tuple[str, str]] = {
    Severity.ERROR: ("✖", "x"),
    Severity.WARNING: ("▲", "!"),
    Severity.INFO: ("●", "i"),
}
"""Sign of each severity, and its form in ASCII."""
CODES = 3
"""Number of codes a badge names before it counts the rest."""


def marks(structure: Structure, findings: Iterable[Finding]) -> Marks:
    """Select the *findings* about *structure* or a part of it, by part.

    A finding is about the part that its entity belongs to, else about the one in whose description
    it lies.
    """
    inside = _Descriptions(structure)
    found: dict[str, dict[int, Finding]] = {}
    for finding in findings:
        for one in (finding, *finding.members):
            part = structure.owner(one.focus)
            if part in {None, structure.iri}:
                part = inside.at(one.location) or part
            if part is not None:
                found.setdefault(part, {})[id(finding)] = finding
    return {
        part: sorted(told.values(), key=lambda one: (-one.severity, one.sort_key))
        for part, told in found.items()
    }


def paired(
    structures: Sequence[Structure], findings: Sequence[Finding]
) -> Iterator[tuple[Structure, Marks]]:
    """*structures*, each with its marks; takes time linear in all parts and *findings*."""
    owners: dict[str, list[int]] = {}
    for index, structure in enumerate(structures):
        for key in (*structure.owners, *(f"file {name}" for name in structure.files)):
            owners.setdefault(key, []).append(index)
    near: list[dict[int, Finding]] = [{} for _ in structures]
    for finding in findings:
        for one in (finding, *finding.members):
            for key in (one.focus, f"file {one.location.source.name}"):
                for index in owners.get(key, ()):
                    near[index][id(finding)] = finding
    for structure, own in zip(structures, near, strict=True):
        yield structure, marks(structure, own.values())


class _Descriptions:
    """The parts of a robot by the places where they are described."""

    def __init__(self, structure: Structure) -> None:
        self._by_text: dict[str, dict[int, tuple[int, str]]] = {}
        for part in structure.parts:
            if (whole := part.whole) is not None:
                starts = self._by_text.setdefault(whole.source.name, {})
                starts.setdefault(whole.span.start, (whole.span.end, part.iri))
        self._starts = {name: sorted(starts) for name, starts in self._by_text.items()}

    def at(self, place: Location) -> str | None:
        """The part whose description begins last before *place* and reaches beyond it."""
        starts = self._starts.get(place.source.name, [])
        index = bisect_right(starts, place.span.start)
        if not index:
            return None
        end, part = self._by_text[place.source.name][starts[index - 1]]
        return part if place.span.end <= end else None


@dataclass(frozen=True, slots=True)
class Badge:
    """The mark of one part: the worst severity of its findings, and the codes of the worst."""

    severity: Severity
    """Worst severity of the findings."""
    codes: tuple[str, ...]
    """Codes of the worst findings."""
    more: int = 0
    """Number of other codes."""

    def text(self, *, unicode: bool = True) -> str:
        """Sign and codes: `✖ TOP003, INE005`."""
        more = f" +{self.more}" if self.more else ""
        return f"{sign(self.severity, unicode=unicode)} {', '.join(self.codes)}{more}"


def sign(severity: Severity, *, unicode: bool = True) -> str:
    """Return the sign of *severity*."""
    return SIGNS[severity][0 if unicode else 1]


def badge(found: Sequence[Finding]) -> Badge | None:
    """The mark of a part of which this is *found*, the worst first; None for nothing."""
    if not found:
        return None
    codes = list(Counter(one.rule.code for one in found))
    return Badge(found[0].severity, tuple(codes[:CODES]), max(0, len(codes) - CODES))


def marked(found: Marks) -> Marks:
    """Return the findings that pictures mark: errors and warnings, since infos would hide them."""
    chosen = (
        (part, [one for one in told if one.severity > Severity.INFO])
        for part, told in found.items()
    )
    return {part: told for part, told in chosen if told}


def described_findings(found: Marks) -> Iterator[Finding]:
    """All findings that are marked in a picture, each once, in their order."""
    every = {id(one): one for each in found.values() for one in each}
    yield from sorted(every.values(), key=lambda one: one.sort_key)
