"""Keeps compiled catalogues in a directory as JSON, and reads rules from it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from kinlint.rule import Applicability, Example, Repair, Rule, Severity, SeverityFor

STORED = ("catalogue-*.json", "catalogue-*.tmp")
"""Patterns for the names of compiled catalogues in a cache, and of those being written."""
KEPT = 8
"""The number of compiled catalogues that a cache keeps: one for each set of rules lately in use."""


def read_catalogue(stored: Path) -> dict[str, Any] | None:
    """Return the compiled catalogue that the file *stored* has; None if it has none."""
    try:
        compiled: dict[str, Any] = json.loads(stored.read_bytes())
    except (OSError, ValueError):
        return None
    return compiled


def write_catalogue(stored: Path, compiled: dict[str, Any]) -> None:
    """Keep *compiled*; a cache that cannot be written costs time, never the run."""
    import tempfile  # noqa: PLC0415  a run that finds its catalogue does without

    with suppress(OSError):
        stored.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(".tmp", "catalogue-", stored.parent)
        with os.fdopen(handle, "w", encoding="utf-8") as stream:
            stream.write(json.dumps(compiled, separators=(",", ":")))
        Path(temporary).replace(stored)
        for stale in newest(stored.parent)[KEPT:]:
            stale.unlink()


def newest(place: Path) -> list[Path]:
    """Return the compiled catalogues in *place*, the newest first."""
    found = place.glob(STORED[0])
    return sorted(found, key=lambda each: each.stat().st_mtime, reverse=True)


def rule_from_json(values: dict[str, Any], homes: Mapping[str, str]) -> Rule:
    """Return the rule of *values*; its file, of *homes*, is where it is now, not where it was."""
    plural = {name: tuple(each) for name, each in values.items() if isinstance(each, list | tuple)}
    changed = {
        "examples": tuple(
            Example(
                **{
                    **each,
                    "beside": tuple(each["beside"]),
                    "companions": tuple(map(tuple, each["companions"])),
                }
            )
            for each in values["examples"]
        ),
        "severity": Severity(values["severity"]),
        "severity_for": _severities(values["severity_for"]),
        "also_for": _severities(values["also_for"]),
        "also": tuple(map(Severity, values["also"])),
        "facts": tuple(map(tuple, values["facts"])),
        "repairs": tuple(map(_repair, values["repairs"])),
        "path": homes.get(values["name"], ""),
    }
    return Rule(**{**values, **plural, **changed})


def _severities(values: Iterable[Mapping[str, Any]]) -> tuple[SeverityFor, ...]:
    return tuple(
        SeverityFor(Severity(each["severity"]), tuple(each["targets"]), tuple(each["formats"]))
        for each in values
    )


def _repair(values: dict[str, Any]) -> Repair:
    plural = {name: tuple(each) for name, each in values.items() if isinstance(each, list)}
    triples = {name: tuple(map(tuple, values[name])) for name in ("removed", "added")}
    claimed = Applicability(values["applicability"])
    return Repair(**{**values, **plural, **triples, "applicability": claimed})
