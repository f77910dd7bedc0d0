"""Matrix of the features of a robot by consumers: what each consumer makes of each feature."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from kinlint.targets.chosen_target import Target
from kinlint.targets.consumer import Cell, Feature
from kinlint.targets.consumer_files import consumer_table
from kinlint.targets.portability import Portability
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
    """The columns."""
    rows: Sequence[FeatureRow]
    """The rows: what consumers read differently comes first, then by name."""

    @classmethod
    def of(
        cls, written: Iterable[tuple[str, Location]], targets: Sequence[Target]
    ) -> FeatureMatrix:
        """Return the matrix of the features *written* at places, by *targets*."""
        table = consumer_table()
        found: dict[str, dict[tuple[str, int, int], None]] = {}
        for name, where in written:
            if name in table.features:
                place = where.source.name, where.start.line, where.start.column
                found.setdefault(name, {})[place] = None
        rows = [
            _row(table.features[name], sorted(places), targets) for name, places in found.items()
        ]
        return cls(targets, sorted(rows, key=lambda row: (row.alike, row.feature.name)))

    @property
    def differing(self) -> int:
        """The number of features that some target departs from."""
        return sum(not row.alike for row in self.rows)

    def to_json(self) -> dict[str, Any]:
        """Return the matrix as JSON values."""
        return {
            "targets": [target.text for target in self.targets],
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
