"""Substitutions `$(…)`: arguments, packages, the environment, directories."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, MutableMapping
from pathlib import Path
from typing import Any

from kinlint.files.environment import variable
from kinlint.formats.xacro.expansion_limits import Refused
from kinlint.light_dataclasses import dataclass, field

ROS_VARIABLES = frozenset({"ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION"})
"""Environment variables that every file may ask for; none of them is private."""


class UnknownSubstitution(Exception):
    """Error: the name in a substitution is not known here; it may be elsewhere."""

    def __init__(self, kind: str, name: str) -> None:
        super().__init__(f"{kind} '{name}' is not known")
        self.kind = kind
        self.name = name


@dataclass
class Substitution:
    """Substitutions of one expansion."""

    arguments: MutableMapping[str, str]
    """Arguments that are given, and those with defaults so far."""
    find: Callable[[str], str]
    """Function that returns the directory of a package."""
    directory: Callable[[], Path]
    """Function that returns the directory of the current file."""
    evaluate: Callable[[str, Mapping[str, Any]], Any]
    """Function that returns the value of an expression."""
    variables: Collection[str] = ()
    """Environment variables that files may ask for, besides those of ROS."""
    withheld: Callable[[str], None] = field(default=lambda _: None)
    """Function that is told of a variable which is not given to a file."""

    def value(self, inside: str) -> str:
        """Return the text for `$(inside)`.

        Raises Unknown, or ValueError for what is no substitution.
        """
        command, _, rest = inside.strip().partition(" ")
        rest = rest.strip()
        words = rest.split()
        if command == "eval":
            return self._eval(rest)
        expected = {"cwd": 0, "dirname": 0, "arg": 1, "find": 1, "env": 1}.get(command)
        if expected is None and (command != "optenv" or not words):
            raise ValueError(f"'$({inside})' is not a substitution that xacro knows")
        if expected is not None and len(words) != expected:
            raise ValueError(
                f"'$({inside})' takes {expected or 'no'} argument{'s' * (not expected)}"
            )
        if command == "optenv":
            return self._variable(words[0], " ".join(words[1:]))
        simple: Mapping[str, Callable[..., str]] = {
            "cwd": lambda: str(Path.cwd()),
            "dirname": lambda: str(self.directory()),
            "arg": self.argument,
            "find": self.find,
            "env": self._env,
        }
        return simple[command](*words)

    def argument(self, name: str) -> str:
        """Return the value of the argument *name*."""
        try:
            return self.arguments[name]
        except KeyError:
            raise UnknownSubstitution("argument", name) from None

    def _env(self, name: str) -> str:
        found = variable(name) if self._may_see(name) else None
        if found is None:
            raise UnknownSubstitution("environment variable", name)
        return found

    def _variable(self, name: str, default: str = "") -> str:
        if not self._may_see(name):
            self.withheld(name)
            return default
        found = variable(name)
        return default if found is None else found

    def _may_see(self, name: str) -> bool:
        return name in ROS_VARIABLES or name in self.variables

    def _eval(self, expression: str) -> str:
        if "__" in expression:
            raise Refused("'__' in $(eval …)")
        names: dict[str, Any] = {name: _typed(value) for name, value in self.arguments.items()}
        names |= {"true": True, "false": False, "find": self.find, "env": self._env}
        names["optenv"] = self._variable
        names["arg"] = lambda name: _typed(self.argument(name))
        names["dirname"] = lambda: str(self.directory())
        return str(self.evaluate(expression, names))


def _typed(value: str) -> bool | float | str:
    """Return an argument as `$(eval …)` sees it: a number or a truth value if it looks like one."""
    try:
        return float(value) if "." in value else int(value)
    except ValueError:
        return {"true": True, "false": False}.get(value.lower(), value)
