"""Comparison of what consumers make of one feature, and advice what to write instead."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from kinlint.rule import Severity
from kinlint.targets.chosen_target import Target
from kinlint.targets.consumer import Cell, Consumer, ConsumerTable
from kinlint.targets.consumer_files import consumer_table

ASSUMED = "assumed"
"""Behaviour with what a format leaves open: nobody departs from it, but consumers may differ."""
NUMBER = 2


class Reading(NamedTuple):
    """Treatment of a feature by one consumer."""

    consumer: Consumer
    """The consumer."""
    cell: Cell
    """Treatment of the feature."""

    @property
    def who(self) -> str:
        """Return the consumer for people, with the versions: "MuJoCo before 3.5"."""
        return self.consumer.label + self.cell.versions.words


class Portability(NamedTuple):
    """Comparison of what some consumers make of one feature."""

    feature: str
    """Name of the feature."""
    readings: Sequence[Reading]
    """The readings that are known, in the order of the targets."""
    targets: Sequence[Target]
    """The targets."""

    @classmethod
    def of(cls, feature: str, targets: Sequence[Target] = ()) -> Portability:
        """Return what *targets* make of *feature*; without any, the newest of all consumers."""
        table = consumer_table()
        meant = targets or [Target(name) for name, each in table.consumers.items() if each.cells]
        found = (
            Reading(table.consumers[each.name], cell)
            for each in meant
            if (cell := table.cell(each.name, each.version, feature)) is not None
        )
        return cls(feature, tuple(found), tuple(meant))

    @property
    def formats(self) -> Collection[str]:
        """The formats of which the feature is."""
        found = consumer_table().features.get(self.feature)
        return found.formats if found is not None else ()

    @property
    def departures(self) -> Sequence[Reading]:
        """The readings that are not what the file says, or that contradict each other."""
        assumed = [each for each in self.readings if each.cell.behaviour.name == ASSUMED]
        differ = len({each.cell.into for each in assumed}) > 1
        return [
            each
            for each in self.readings
            if each.cell.severity is not None and (differ or each not in assumed)
        ]

    @property
    def severity(self) -> Severity | None:
        """The severity of the worst departure; None if there is none."""
        severities = (each.cell.severity for each in self.departures)
        return max((each for each in severities if each is not None), default=None)

    @property
    def sentences(self) -> str:
        """Return what each consumer makes of it, and what to write instead; empty if all agree.

        Of several targets, those that read what the file says are named too.
        """
        if not (told := self.departures):
            return ""
        if len(self.targets) <= NUMBER or len(self.readings) == len(told):
            told = self.readings
        named: dict[str, dict[str, None]] = {}
        for each in told:
            named.setdefault(each.cell.clause, {})[each.who] = None
        clauses = [f"In {listed([*who])}, {clause}" for clause, who in named.items()]
        said = "; ".join([clauses[0], *(f"i{each[1:]}" for each in clauses[1:])]) + "."
        return f"{said} {self.advice}".rstrip()

    @property
    def advice(self) -> str:
        """Return what to write so that the targets agree; empty if nothing is known."""
        table = consumer_table()
        feature = table.features.get(self.feature)
        for way in feature.alternatives if feature is not None else ():
            if not way.feature or _agreed(table, way.feature, self.targets):
                return way.label
        return ""


def departing_targets(features: Collection[str]) -> Iterator[str]:
    """Yield targets, as options spell them, that depart from one of *features*."""
    for name, consumer in consumer_table().consumers.items():
        for cell in consumer.cells:
            if cell.feature in features and cell.severity is not None:
                bounded = any(cell.versions)
                yield f"{name}@{cell.versions.since or '0'}" if bounded else name


def _agreed(table: ConsumerTable, feature: str, targets: Sequence[Target]) -> bool:
    """Tell whether no known reading of *feature* by *targets* departs from what is written."""
    cells = (table.cell(each.name, each.version, feature) for each in targets)
    return all(cell is None or cell.severity is None for cell in cells)


def listed(names: Sequence[str]) -> str:
    """Return *names* as people list them: "A, B and C"."""
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
