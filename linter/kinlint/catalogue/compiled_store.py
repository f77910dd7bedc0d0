"""Keeps compiled catalogues in a directory, as lines of JSON of which a run decodes what it needs.

The first line has of each rule what all runs look at, and where in the following ones the rest is.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias
from zlib import crc32

from kinlint.catalogue.deferred import ConstraintHead, ConstraintTable, Deferred
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint
from kinlint.files.cache_file import UNDONE, write_cache_file
from kinlint.light_dataclasses import MISSING, dataclass, fields
from kinlint.rule import Applicability, Example, Repair, Rule, Severity, SeverityFor

STORED = ("catalogue-*.jsonl", f"catalogue-*{UNDONE}")
"""Patterns for the names of compiled catalogues in a cache, and of those being written."""
KEPT = 8
"""The number of compiled catalogues that a cache keeps: one for each set of rules lately in use."""
OPTIONAL = frozenset(each.name for each in fields(Rule) if each.default is not MISSING)
"""Fields of rules that are kept only where they say something."""
Place: TypeAlias = list[int]
"""Offsets of the beginning and the end of a line, in bytes from the second line on."""
LATER = ("examples", "repairs")
"""Fields of rules that few runs look at."""


@dataclass(frozen=True)
class CompiledCatalogue:
    """A compiled catalogue as it is kept."""

    head: Mapping[str, Any]
    """The first line."""
    lines: bytes | memoryview
    """The other lines."""

    @classmethod
    def from_units(cls, compiled: Mapping[str, Any], code: str) -> CompiledCatalogue:
        """Return what is to be kept of units, axioms and lifting queries *compiled* by *code*."""
        lines: list[str] = []
        size = 0

        def place(value: Any) -> Place:
            nonlocal size
            line = value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))
            lines.append(line)
            size += len(line) + 1
            return [size - len(line) - 1, size - 1]

        def rule(values: Mapping[str, Any]) -> dict[str, Any]:
            said = {name: each for name, each in values.items() if each or name not in OPTIONAL}
            return said | {name: place(said[name]) for name in LATER if name in said}

        def constraint(values: Mapping[str, Any]) -> list[Any]:
            own = values["owner"], values.get("formats", ()), "deferred" in values
            return [*own, place(values)]

        units, (axioms, lifting) = compiled["units"], (compiled["axioms"], compiled["lifting"])
        head = {
            "code": code,
            "rules": [rule(one) for each in units for one in each["rules"]],
            "shapes": [rule(one) for one in compiled["shapes"]["rules"]],
            "constraints": [constraint(one) for each in units for one in each["constraints"]],
            "axioms": place(axioms["axioms"]),
            "lifting": {form: place(text) for form, text in lifting["queries"].items()},
            "keys": [axioms["key"], lifting["key"]],
            "units": place(
                [[u["key"], u["links"], len(u["rules"]), len(u["constraints"])] for u in units]
            ),
        }
        rest = "".join(f"{line}\n" for line in lines).encode("ascii")
        return cls({**head, "check": crc32(rest)}, rest)

    @classmethod
    def from_file(cls, stored: Path) -> CompiledCatalogue | None:
        """Return the compiled catalogue that the file *stored* has; None if it has none."""
        try:
            kept = stored.read_bytes()
            end = kept.index(b"\n")
            head, lines = json.loads(kept[:end]), memoryview(kept)[end + 1 :]
            return cls(head, lines) if head["check"] == crc32(lines) else None
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def keep(self, stored: Path) -> None:
        """Keep the catalogue in the file *stored*; what cannot be written costs time, no run."""
        head = json.dumps(self.head, separators=(",", ":")).encode()
        with suppress(OSError):
            write_cache_file(stored, b"\n".join((head, self.lines)))
            for stale in newest(stored.parent)[KEPT:]:
                stale.unlink()

    def rules(self, homes: Mapping[str, str]) -> list[Rule]:
        """Return the rules; the file of each, of *homes*, is where it is now, not where it was."""
        return [self._rule(each, homes) for each in (*self.head["rules"], *self.head["shapes"])]

    @property
    def constraints(self) -> ConstraintTable:
        """The constraints of all rules and shapes."""
        entries = self.head["constraints"]
        heads = [ConstraintHead(owner, tuple(forms), by) for owner, forms, by, _ in entries]
        return ConstraintTable(
            heads, lambda number: Constraint.from_json(self._value(entries[number][3]))
        )

    @property
    def axioms(self) -> tuple[Axiom, ...]:
        """The axioms of the vocabulary."""
        return tuple(map(Axiom.from_json, self._value(self.head["axioms"])))

    @property
    def queries(self) -> Mapping[str, str]:
        """The lifting queries of each format, as JSON."""
        return {form: self._line(place) for form, place in self.head["lifting"].items()}

    def units(self, code: str) -> list[dict[str, Any]]:
        """Return what `from_units` was given, unit by unit; nothing if *code* is other code."""
        if self.head.get("code") != code:
            return []
        rules = iter([self._full(each) for each in self.head["rules"]])
        constraints = iter([self._value(place) for *_, place in self.head["constraints"]])
        found = [
            {
                "key": key,
                "links": links,
                "rules": [next(rules) for _ in range(rule_count)],
                "constraints": [next(constraints) for _ in range(constraint_count)],
            }
            for key, links, rule_count, constraint_count in self._value(self.head["units"])
        ]
        axioms, lifting = self.head["keys"]
        found.append({"key": axioms, "axioms": self._value(self.head["axioms"])})
        return [*found, {"key": lifting, "queries": dict(self.queries)}]

    def _line(self, place: Place) -> str:
        return str(self.lines[place[0] : place[1]], "ascii")

    def _value(self, place: Place) -> Any:
        return json.loads(self._line(place))

    def _full(self, values: Mapping[str, Any]) -> dict[str, Any]:
        kept = {**values, **{name: self._value(values[name]) for name in LATER if name in values}}
        return {each.name: kept.get(each.name, each.default) for each in fields(Rule)}

    def _rule(self, values: Mapping[str, Any], homes: Mapping[str, str]) -> Rule:
        said = {
            name: READERS[name](value) if name in READERS else value
            for name, value in values.items()
            if name not in LATER
        }
        for name, decode in (("examples", _example), ("repairs", _repair)):
            if name in values:
                said[name] = Deferred(partial(self._decoded, decode, values[name]))
        return Rule(**{**said, "path": homes.get(values["name"], "")})

    def _decoded(self, decode: Any, place: Place) -> Iterable[Any]:
        return map(decode, self._value(place))


def newest(place: Path) -> list[Path]:
    """Return the compiled catalogues in *place*, the newest first."""
    found = place.glob(STORED[0])
    return sorted(found, key=lambda each: each.stat().st_mtime, reverse=True)


def _example(values: Mapping[str, Any]) -> Example:
    companions = tuple(map(tuple, values["companions"]))
    return Example(**{**values, "beside": tuple(values["beside"]), "companions": companions})


def _severities(values: Iterable[Mapping[str, Any]]) -> tuple[SeverityFor, ...]:
    return tuple(
        SeverityFor(Severity(each["severity"]), tuple(each["targets"]), tuple(each["formats"]))
        for each in values
    )


def _repair(values: Mapping[str, Any]) -> Repair:
    plural = {name: tuple(each) for name, each in values.items() if isinstance(each, list)}
    triples = {name: tuple(map(tuple, values[name])) for name in ("removed", "added")}
    claimed = Applicability(values["applicability"])
    return Repair(**{**values, **plural, **triples, "applicability": claimed})


_PLURAL = ("antipatterns", "symptoms", "formats", "links", "messages", "targets")
READERS: Mapping[str, Callable[[Any], Any]] = {
    **dict.fromkeys((*_PLURAL, "group_by", "explains", "features"), tuple),
    "severity": Severity,
    "severity_for": _severities,
    "also_for": _severities,
    "also": lambda each: tuple(map(Severity, each)),
    "facts": lambda each: tuple(map(tuple, each)),
}
"""Functions that make of JSON the values that some fields of a rule have."""
