"""Differences between descriptions of robots as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

from kinlint.robot_difference import Change, Part, RobotDifference
from kinlint.text import Location


def render_json(differences: Sequence[RobotDifference]) -> Iterator[str]:
    """Yield one JSON array with an object for each pair of descriptions."""
    yield json.dumps([_robot(each) for each in differences], indent=2, ensure_ascii=False)
    yield "\n"


def _robot(each: RobotDifference) -> dict[str, Any]:
    matched, old, new = each.joints
    return {
        "old": each.old or None,
        "new": each.new or None,
        "differs": each.differs,
        "matchedBy": each.matched or None,
        "joints": {"common": matched, "old": old, "new": new},
        "changes": [_change(change) for change in each.changes],
        "removed": [_part(part) for part in each.removed],
        "added": [_part(part) for part in each.added],
        "unstated": [
            {
                "quantity": one.quantity,
                "statedIn": "old" if one.old_states else "new",
                "parts": list(one.parts),
                "expressible": one.expressible,
            }
            for one in each.unstated
        ],
    }


def _change(each: Change) -> dict[str, Any]:
    return {
        "kind": each.kind,
        "part": each.part or None,
        "newPart": each.new_part or None,
        "quantity": each.quantity,
        "unit": each.unit or None,
        "old": each.old,
        "new": each.new,
        "text": each.phrase,
        "oldPlace": _place(each.old_place),
        "newPlace": _place(each.new_place),
    }


def _part(each: Part) -> dict[str, Any]:
    return {
        "kind": each.kind,
        "name": each.name,
        "type": each.detail or None,
        "place": _place(each.place),
    }


def _place(location: Location | None) -> dict[str, Any] | None:
    if location is None:
        return None
    start = location.start
    return {"path": location.source.name, "line": start.line, "column": start.column}
