"""The kinds of values that keys of a configuration hold: told, checked, and as JSON Schema."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from kinlint.light_dataclasses import dataclass
from kinlint.suggestion import did_you_mean

ALIASES = {"note": "info"}
"""Other words for severities: SARIF and compilers say note."""


@dataclass(frozen=True)
class Kind:
    """A kind of value of the configuration."""

    name: str
    """Its name in messages."""
    problem: Callable[[object], str]
    """Returns what is wrong with a value, or an empty string."""
    schema: Mapping[str, Any]
    """Its JSON Schema."""


def expected_message(what: str, value: object) -> str:
    """Return the message that *what* was expected in place of *value*."""
    kinds: dict[type, str] = {
        bool: "a boolean",
        str: "a string",
        int: "a number",
        list: "a list",
        dict: "a table",
    }
    kind = kinds.get(type(value), f"a {type(value).__name__}")
    text = f" {value!r}" if isinstance(value, str | int | float) else ""
    return f"expected {what}, got {kind}{text}"


def unknown_message(value: str, choices: tuple[str, ...]) -> str:
    """Return the message that *value* is none of *choices*; "" if it is."""
    if value in choices:
        return ""
    listed = ", ".join(choices)
    return f"'{value}' is not one of {listed}{did_you_mean(value, choices)}"


def one_of(choices: tuple[str, ...]) -> Kind:
    """Return the kind of one of *choices*, or an alias of one."""

    def problem(value: object) -> str:
        if not isinstance(value, str):
            return expected_message("one of " + ", ".join(choices), value)
        alias = ALIASES.get(value)
        return "" if alias in choices else unknown_message(value, choices)

    aliases = [alias for alias, meant in ALIASES.items() if meant in choices]
    return Kind(f"one of {', '.join(choices)}", problem, {"enum": [*choices, *aliases]})


def table(of: Kind, entries: str) -> Kind:
    """A table, each value of which is *of* a kind; *entries* says from what to what it leads."""

    def problem(value: object) -> str:
        if not isinstance(value, dict):
            return expected_message("a table", value)
        wrongs = ((key, of.problem(one)) for key, one in value.items())
        return next((f"'{key}': {wrong}" for key, wrong in wrongs if wrong), "")

    schema = {"type": "object", "additionalProperties": of.schema}
    return Kind(f"a table {entries}", problem, schema)


def either(name: str, tables: Kind, others: Kind) -> Kind:
    """Something of the kind *tables*, which is one of tables, or of the kind *others*."""

    def problem(value: object) -> str:
        if isinstance(value, dict):
            return tables.problem(value)
        return expected_message(name, value) if others.problem(value) else ""

    return Kind(name, problem, {"anyOf": [others.schema, tables.schema]})


def _strings(value: object) -> str:
    if isinstance(value, list):
        wrong = [one for one in value if not isinstance(one, str)]
        return expected_message("only strings in the list", wrong[0]) if wrong else ""
    return expected_message("a list of strings", value)


def _one_or_more(value: object) -> str:
    return "" if isinstance(value, str) else _strings(value)


def _switch(value: object) -> str:
    return "" if isinstance(value, bool) else expected_message("true or false", value)


def _string(value: object) -> str:
    return "" if isinstance(value, str) else expected_message("a string", value)


def _scalar(value: object) -> str:
    return (
        ""
        if isinstance(value, str | int | float)
        else expected_message("a string or number", value)
    )


def _seconds(value: object) -> str:
    number = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < LONGEST
    return "" if number else expected_message("a number of seconds from 0 up", value)


LONGEST = 1e9
"""Seconds beyond which a limit is none that a clock can hold."""
_TEXT = {"type": "string"}
_LIST = {"type": "array", "items": _TEXT}
STRING = Kind("a string", _string, _TEXT)
STRINGS = Kind("a list of strings", _strings, _LIST)
ONE_OR_MORE = Kind("a string or a list of strings", _one_or_more, {"anyOf": [_TEXT, _LIST]})
SWITCH = Kind("true or false", _switch, {"type": "boolean"})
SECONDS = Kind("a number of seconds", _seconds, {"type": "number", "minimum": 0})
SCALAR = Kind("a string, a number or a boolean", _scalar, {"type": ["string", "number", "boolean"]})
