"""Matrix of the features of a robot by consumers: what each consumer makes of each feature."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from kinlint.file_format import Format
from kinlint.formats.records import spoken_of_as
from kinlint.targets.chosen_target import Target
from kinlint.targets.consumer import Cell, Feature
from kinlint.targets.consumer_files import consumer_table
from kinlint.targets.portability import Portability, listed
from kinlint.text import Location


class FeatureRow(NamedTuple):
    """A feature of a robot, and what consumers make of it."""

    feature: Feature
    """The feature."""
    places: Sequence[str]
    """Places where it was found, `file:line:column`, in order."""
    cells: Sequence[Cell | None]
    """Treatment by each target of the matrix; None where that is unknown."""
    alike: bool
    """True if no target that is known departs from what is written."""
    advice: str
    """Advice how to write it so that the targets agree; empty if nothing is known."""


class FeatureMatrix(NamedTuple):
    """The features of a robot by consumers."""

    targets: Sequence[Target]
    """The columns: the targets that read one of the formats."""
    rows: Sequence[FeatureRow]
    """The rows: what consumers read differently comes first, then by name."""
    formats: Sequence[str] = ()
    """Titles of the formats of the files, sorted."""
    others: Sequence[Target] = ()
    """The targets that read none of the formats."""

    @classmethod
    def of(
        cls,
        written: Iterable[tuple[str, Location]],
        targets: Sequence[Target],
        formats: Mapping[str, Format],
    ) -> FeatureMatrix:
        """Return the matrix of the features *written* at places, by *targets*.

        *formats* are the formats of files, by name. What a feature means in one format says
        nothing of another one.
        """
        table = consumer_table()
        known = {spoken_of_as(each) for each in formats.values()}
        readers = [each for each in targets if known & _formats(each)]
        found: dict[str, dict[tuple[str, int, int], None]] = {}
        for name, where in written:
            feature = table.features.get(name)
            if feature is not None and spoken_of_as(formats[where.source.name]) in feature.formats:
                place = where.source.name, where.start.line, where.start.column
                found.setdefault(name, {})[place] = None
        rows = [
            _row(table.features[name], sorted(places), readers) for name, places in found.items()
        ]
        rows.sort(key=lambda row: (row.alike, row.feature.name))
        others = [each for each in targets if each not in readers]
        return cls(readers, rows, sorted({each.title for each in formats.values()}), others)

    @property
    def unread(self) -> str:
        """The sentence about the targets that read none of the formats; empty without any."""
        if not self.others:
            return ""
        who = listed([each.text for each in self.others])
        verb = "does" if len(self.others) == 1 else "do"
        return f"{who} {verb} not read {listed(self.formats)}."

    @property
    def differing(self) -> int:
        """The number of features that some target departs from."""
        return sum(not row.alike for row in self.rows)

    def to_json(self) -> dict[str, Any]:
        """Return the matrix as JSON values."""
        return {
            "targets": [target.text for target in self.targets],
            "unread": [target.text for target in self.others],
            "features": [
                {
                    "feature": row.feature.name,
                    "label": row.feature.label,
                    "places": list(row.places),
                    "alike": row.alike,
                    "advice": row.advice or None,
                    "targets": {
                        target.text: None if cell is None else cell.to_json()
                        for target, cell in zip(self.targets, row.cells, strict=True)
                    },
                }
                for row in self.rows
            ],
        }


def _formats(target: Target) -> set[str]:
    """Return the names of the formats that *target* reads."""
    table = consumer_table()
    return {each for name in table.members(target.name) for each in table.consumers[name].formats}


def _row(
    feature: Feature, places: Sequence[tuple[str, int, int]], targets: Sequence[Target]
) -> FeatureRow:
    table = consumer_table()
    portability = Portability.of(feature.name, targets)
    alike = not portability.departures
    return FeatureRow(
        feature,
        [f"{name}:{line}:{column}" for name, line, column in places],
        [table.cell(each.name, each.version, feature.name) for each in targets],
        alike,
        "" if alike else portability.advice,
    )
