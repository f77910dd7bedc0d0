"""Consumers of robot descriptions, features of these, and what each consumer makes of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kinlint.light_dataclasses import dataclass, replace
from kinlint.rule import Severity
from kinlint.targets.version_range import ALL, Version, VersionRange, read_version


@dataclass(frozen=True, slots=True)
class Behaviour:
    """A way in which a consumer may treat a feature."""

    name: str
    """Name, such as `refused`."""
    label: str
    """Name for people, such as `ignored silently`."""
    outcome: str
    """Clause about a file that is treated so, such as "the file is rejected"."""
    severity: Severity | None
    """Severity of what is treated so; None if nothing is lost."""
    mark: str
    """Character for tables."""


@dataclass(frozen=True, slots=True)
class Alternative:
    """Another way to write what a feature says."""

    label: str
    """Imperative, such as "Write the rotation as 'rpy'."."""
    feature: str
    """Name of the feature that is written then; empty if all consumers read it alike."""


@dataclass(frozen=True, slots=True)
class Feature:
    """A feature that descriptions may have."""

    name: str
    """Name, such as `mimic`."""
    label: str
    """Name for people, such as "mimic"."""
    comment: str
    """The meaning by the specification of the format."""
    alternatives: tuple[Alternative, ...] = ()
    """Other ways to write it, the preferred first."""
    narrows: str = ""
    """Name of the feature of which it is a special case; empty if it is of none."""
    formats: frozenset[str] = frozenset()
    """Names of the formats of which the cells speak."""
    query: str = ""
    """SPARQL that finds each `?place` of it; empty if rules find it, by their `kl:feature`."""
    told_by: frozenset[str] = frozenset()
    """Names of the rules that report it as a defect of its own, where they speak of its place."""


@dataclass(frozen=True, slots=True)
class Cell:
    """Treatment of a feature by some versions of a consumer."""

    feature: str
    """Name of the feature."""
    behaviour: Behaviour
    """The way in which it is treated."""
    versions: VersionRange = ALL
    """The versions that do so."""
    into: str = ""
    """Result of the change or the assumption, in a word or two."""
    outcome: str = ""
    """Clause that says what becomes of it; empty for that of the behaviour."""
    measured: tuple[str, ...] = ()
    """Versions with which it was measured, by a file that has the feature."""
    sources: tuple[str, ...] = ()
    """Addresses of source code, documentation or issues that say so."""
    comment: str = ""
    """Remark on the evidence."""
    own_severity: Severity | None = None
    """Severity, where it is not that of the behaviour."""

    @property
    def severity(self) -> Severity | None:
        """Return the severity of the feature for the consumer; None if nothing is lost."""
        return self.own_severity or self.behaviour.severity

    @property
    def clause(self) -> str:
        """Return the clause that says what becomes of the feature."""
        return self.outcome or self.behaviour.outcome

    def to_json(self) -> dict[str, Any]:
        """Return the treatment as JSON values."""
        return {
            "behaviour": self.behaviour.name,
            "outcome": self.clause,
            "since": self.versions.since or None,
            "until": self.versions.until or None,
            "measured": list(self.measured),
            "sources": list(self.sources),
        }


@dataclass(frozen=True, slots=True)
class Parser:
    """A consumer by which some versions of another one read files."""

    consumer: str
    """Name of the consumer that reads."""
    version: str
    """Its version; empty for the newest."""
    versions: VersionRange
    """The versions that read by it."""


@dataclass(frozen=True, slots=True)
class Consumer:
    """A program that reads robot descriptions."""

    name: str
    """Name, such as `mujoco`."""
    label: str
    """Name for people, such as "MuJoCo"."""
    comment: str
    """Description: its kind, and by which parts it reads robots."""
    formats: tuple[str, ...] = ()
    """Names of the formats that it reads."""
    releases: tuple[str, ...] = ()
    """Versions that the table knows, the earliest first."""
    cells: tuple[Cell, ...] = ()
    """Treatment of features, sorted by feature and version."""
    parsers: tuple[Parser, ...] = ()
    """The consumers by which it reads files."""
    members: tuple[str, ...] = ()
    """Names of the consumers that the name stands for, where it stands for several."""
    links: tuple[str, ...] = ()
    """Addresses of its documentation."""


@dataclass(frozen=True)
class ConsumerTable:
    """All consumers, and what each makes of features."""

    consumers: Mapping[str, Consumer]
    """Consumers by name, sorted."""
    features: Mapping[str, Feature]
    """Features by name, sorted."""

    def members(self, name: str) -> tuple[str, ...]:
        """Return the names of the consumers that *name* stands for; itself, where it is one."""
        found = self.consumers.get(name)
        return (name,) if found is None or not found.members else found.members

    def names_with(self, name: str) -> Iterator[str]:
        """Yield *name*, the consumers that it stands for, and the names that stand for it."""
        yield from dict.fromkeys((name, *self.members(name)))
        yield from (each.name for each in self.consumers.values() if name in each.members)

    def cell(self, name: str, version: Version | None, feature: str) -> Cell | None:
        """Return what *version* of consumer *name* makes of *feature*; None if that is unknown.

        What a consumer does itself precedes what it leaves to its parser. No version is the newest.
        """
        consumer = self.consumers.get(name)
        if consumer is None:
            return None
        for cell in consumer.cells:
            if cell.feature == feature and cell.versions.has(version):
                return cell
        for parser in consumer.parsers:
            if parser.versions.has(version):
                theirs = read_version(parser.version) if parser.version else None
                found = self.cell(parser.consumer, theirs, feature)
                return None if found is None else replace(found, versions=parser.versions)
        return None
