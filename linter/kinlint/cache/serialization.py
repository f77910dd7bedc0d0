"""Reports as JSON, and back: to the very same, but for rules, which the catalogue has.

A value is written as itself, or as a list that begins with its kind. Reading makes none but the
frozen data of `CLASSES`, so what a stranger wrote can be wrong, but does nothing.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum
from importlib import import_module
from typing import Any, TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.errors import SourceError
from kinlint.light_dataclasses import fields, is_dataclass
from kinlint.report import Report
from kinlint.rule import Applicability, Repair, Rule, Severity
from kinlint.text import SourceText, Span

Json: TypeAlias = Any

CLASSES = {
    **dict.fromkeys(("Finding", "Fix", "Premise", "Related", "TextEdit"), "kinlint.finding"),
    "Location": "kinlint.text",
    "SeverityFor": "kinlint.rule",
    **dict.fromkeys(
        ("Coupling", "Frame", "Joint", "Link", "Origin", "Structure"), "kinlint.structure"
    ),
}
"""The classes that reports are made of, and their modules."""
ENUMS = {"Severity": Severity, "Applicability": Applicability}
OWN = ("root", "version", "seconds")
"""Fields of a report that belong to the run, not to the models."""


class NotSerializable(Exception):
    """Something in a report has no notation."""


def serialize_report(report: Report, given: Sequence[SourceText]) -> str:
    """Serialize *report* of *given* as JSON. Raises Unwritable."""
    writer = _Writer(given)
    values = {
        one.name: writer.value(getattr(report, one.name))
        for one in fields(report)
        if one.name not in OWN
    }
    return json.dumps({"texts": writer.texts, "report": values}, separators=(",", ":"))


def parse_report(text: str, given: Sequence[SourceText], book: Rulebook) -> Report:
    """The report of *given* that *text* has. Raises whatever, if it is of another notation."""
    stored = json.loads(text)
    reader = _Reader(given, book)
    reader.texts = [reader.text(each) for each in stored["texts"]]
    return Report(**{name: reader.value(value) for name, value in stored["report"].items()})


class _Writer:
    """Writes values; what texts they lie in goes to `texts`, each once."""

    def __init__(self, given: Sequence[SourceText]) -> None:
        self.texts: list[Json] = []
        self._given = given
        self._numbers: dict[int, int] = {}
        self._kept: list[object] = []

    def value(self, value: object) -> Json:
        if isinstance(value, Enum):
            return ["enum", type(value).__name__, value.name]
        if value is None or isinstance(value, bool | int | float | str):
            return value
        if isinstance(value, Span):
            return ["span", *value]
        if isinstance(value, tuple):
            return ["tuple", *self._tuple(value)]
        if isinstance(value, Mapping):
            return ["map", [[self.value(k), self.value(v)] for k, v in value.items()]]
        return self._object(value)

    def _tuple(self, value: tuple[object, ...]) -> Iterable[Json]:
        for index, each in enumerate(value):
            # A repair stands beside a finding of the rule whose repair it is.
            if isinstance(each, Repair):
                rule: Rule = value[index - 1].rule  # type: ignore[attr-defined]
                yield ["repair", rule.code, rule.repairs.index(each)]
            else:
                yield self.value(each)

    def _object(self, value: object) -> Json:
        if isinstance(value, SourceText):
            return ["text", self._number(value)]
        if isinstance(value, Rule):
            return ["rule", value.code]
        if isinstance(value, SourceError):
            return ["error", value.name, value.cause, value.line, value.column]
        name = type(value).__name__
        if CLASSES.get(name) != type(value).__module__ or not is_dataclass(value):
            raise NotSerializable(name)
        return ["object", name, *(self.value(getattr(value, one.name)) for one in fields(value))]

    def _number(self, source: SourceText) -> int:
        if id(source) not in self._numbers:
            self._kept.append(source)
            self._numbers[id(source)] = len(self.texts)
            self.texts.append(self._text(source))
        return self._numbers[id(source)]

    def _text(self, source: SourceText) -> Json:
        for index, each in enumerate(self._given):
            if each is source or each == source:
                return index
        told = (one.name for one in fields(source) if one.name != "format")
        values = {name: getattr(source, name) for name in told}
        return {
            **values,
            "misread": [[*span, what] for span, what in source.misread],
            "original": source.original.decode("latin-1"),
        }


class _Reader:
    """Reads values that lie in `texts`."""

    def __init__(self, given: Sequence[SourceText], book: Rulebook) -> None:
        self.texts: list[SourceText] = []
        self._given = given
        self._classes: dict[str, Callable[..., Any]] = {}
        self._kinds: Mapping[str, Callable[..., Any]] = {
            "enum": lambda kind, name: ENUMS[kind][name],
            "error": SourceError,
            "map": lambda pairs: {self.value(key): self.value(value) for key, value in pairs},
            "object": self._object,
            "repair": lambda code, index: book.by_code[code].repairs[index],
            "rule": lambda code: book.by_code[code],
            "span": Span,
            "text": lambda index: self.texts[index],
            "tuple": lambda *values: tuple(map(self.value, values)),
        }

    def value(self, value: Json) -> Any:
        if isinstance(value, list):
            return self._kinds[value[0]](*value[1:])
        return value

    def text(self, value: Json) -> SourceText:
        if isinstance(value, int):
            return self._given[value]
        return SourceText(
            **{
                **value,
                "misread": tuple((Span(start, end), what) for start, end, what in value["misread"]),
                "original": value["original"].encode("latin-1"),
            }
        )

    def _object(self, name: str, *values: Json) -> Any:
        if name not in self._classes:
            self._classes[name] = getattr(import_module(CLASSES[name]), name)
        return self._classes[name](*map(self.value, values))
