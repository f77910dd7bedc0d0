"""The keys of a configuration: what each may hold. Every value is checked before it is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from kinlint.errors import ConfigError
from kinlint.suggestion import did_you_mean

OUTPUT_FORMATS = (
    "full",
    "concise",
    "json",
    "json-lines",
    "sarif",
    "github",
    "rdjson",
    "rdjsonl",
    "turtle",
)
ENGINES = ("oxigraph", "pyshacl")
THRESHOLDS = ("error", "warning", "info", "none")
SEVERITIES = THRESHOLDS[:-1]
TARGETS = (
    "drake",
    "gazebo",
    "isaac",
    "kdl",
    "moveit",
    "mujoco",
    "pinocchio",
    "pybullet",
    "usd",
)
"""Consumers of robot descriptions that a model may be meant for."""
ALIASES = {"note": "info"}
"""Other words for severities: SARIF and compilers say note."""


def check(values: Mapping[str, Any], origin: str) -> Mapping[str, Any]:
    """*values* as they were read, all keys known and all values of their kind.

    Raises `ConfigError` that names *origin*, the key and what was expected.
    """
    for key, value in values.items():
        if key not in KEYS:
            raise ConfigError(f"{origin}: unknown key '{key}'{_hint(key, value)}")
        if problem := KEYS[key](value):
            raise ConfigError(f"{origin}: {key}: {problem}")
    return values


def _hint(key: str, value: object) -> str:
    """What may have been meant by the unknown *key*."""
    if isinstance(value, dict) and (key == "tool" or KEYS.keys() & value.keys()):
        return "; keys of kinlint stand in no table here"
    return did_you_mean(key, KEYS) or f"; there are {', '.join(KEYS)}"


def _expected(what: str, value: object) -> str:
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


def strings(value: object) -> str:
    """What is wrong with a list of strings."""
    if isinstance(value, list):
        wrong = next((one for one in value if not isinstance(one, str)), None)
        return "" if wrong is None else _expected("only strings in the list", wrong)
    return _expected("a list of strings", value)


def one_or_more(value: object) -> str:
    """What is wrong with a string or a list of strings."""
    return "" if isinstance(value, str) else strings(value)


def switch(value: object) -> str:
    """What is wrong with a boolean."""
    return "" if isinstance(value, bool) else _expected("true or false", value)


def string(value: object) -> str:
    """What is wrong with a string."""
    return "" if isinstance(value, str) else _expected("a string", value)


def unknown(value: str, choices: tuple[str, ...]) -> str:
    """What is wrong with *value* if it is none of *choices*."""
    if value in choices:
        return ""
    listed = ", ".join(choices)
    return f"'{value}' is not one of {listed}{did_you_mean(value, choices)}"


def _one_of(choices: tuple[str, ...]) -> Callable[[object], str]:
    def problem(value: object) -> str:
        if not isinstance(value, str):
            return _expected("one of " + ", ".join(choices), value)
        alias = ALIASES.get(value)
        return "" if alias in choices else unknown(value, choices)

    return problem


def _table(of: Callable[[object], str]) -> Callable[[object], str]:
    def problem(value: object) -> str:
        if not isinstance(value, dict):
            return _expected("a table", value)
        return next((f"'{key}': {wrong}" for key, one in value.items() if (wrong := of(one))), "")

    return problem


def _contexts(value: object) -> str:
    """A directory, or a table from context IRIs to files."""
    if isinstance(value, dict):
        return _table(string)(value)
    wrong = one_or_more(value)
    return wrong and _expected("a directory or a table of context IRIs and files", value)


def _argument(value: object) -> str:
    """What is wrong with the value of a xacro argument."""
    return "" if isinstance(value, str | int | float) else _expected("a string or number", value)


def _arguments(value: object) -> str:
    """Arguments of xacro files, or tables of them by the files they are for."""

    def problem(one: object) -> str:
        return _table(_argument)(one) if isinstance(one, dict) else _argument(one)

    return _table(problem)(value)


KEYS: Mapping[str, Callable[[object], str]] = {
    "extend": string,
    "select": strings,
    "extend-select": strings,
    "ignore": strings,
    "severity": _table(_one_of(SEVERITIES)),
    "fixable": strings,
    "unfixable": strings,
    "unsafe-fixes": switch,
    "extend-safe-fixes": strings,
    "extend-unsafe-fixes": strings,
    "per-file-ignores": _table(strings),
    "extend-per-file-ignores": _table(strings),
    "require-reason": switch,
    "exclude": strings,
    "extend-exclude": strings,
    "target": strings,
    "srdf": _table(string),
    "fail-on": _one_of(THRESHOLDS),
    "output-format": _one_of(OUTPUT_FORMATS),
    "contexts": string,
    "extra-contexts": _contexts,
    "rules": one_or_more,
    "shapes": one_or_more,
    "partial": switch,
    "engine": _one_of(ENGINES),
    "packages": _table(string),
    "xacro-args": _arguments,
}
"""What is wrong with a value of each key; an empty string if nothing is."""
