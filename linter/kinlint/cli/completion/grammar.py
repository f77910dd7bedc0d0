"""The grammar of the command line, read from the parsers of the subcommands."""

from __future__ import annotations

from argparse import SUPPRESS, Action
from collections.abc import Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from typing import Literal, TypeAlias

from kinlint.cli.argument_parser import Parser, choices, comma_list
from kinlint.cli.commands import COMMANDS
from kinlint.configuration.keys import KEYS, TARGETS
from kinlint.contexts.context_library import RELEASES
from kinlint.light_dataclasses import dataclass

Kind: TypeAlias = Literal["files", "folders", "rules", "words", "anything"]

SHELLS = ("bash", "zsh", "fish")
KINDS: Mapping[str, Kind] = {
    "DIR": "folders",
    "F": "files",
    "FILE": "files",
    "GLOB": "files",
    "PATH": "files",
    "PATH|KEY=VALUE": "files",
    "R": "rules",
}
"""Kinds of values by the metavariables that help texts use."""
KNOWN: Mapping[str, Sequence[str]] = {
    "contexts": (*RELEASES, "newest"),
    "keys": tuple(KEYS),
    "shell": SHELLS,
    "target": TARGETS,
}
"""The values of what takes one of a few words, but other words, too."""


@dataclass(frozen=True)
class Value:
    """The value of an option or a command."""

    kind: Kind
    """Kind of the value."""
    words: tuple[str, ...] = ()
    """The words that it can be; none if any."""
    several: bool = False
    """True if several may be given, with commas."""


@dataclass(frozen=True)
class Option:
    """An option of the command line."""

    names: tuple[str, ...]
    """All its names."""
    text: str
    """Its effect, in words."""
    value: Value | None = None
    """Its value; None if it is either there or not."""


@dataclass(frozen=True)
class Command:
    """A subcommand."""

    name: str
    """Name of the subcommand."""
    text: str
    """Description, in one line."""
    options: tuple[Option, ...]
    """Options that it takes."""
    rest: Value | None = None
    """Values that it takes besides options; None if it takes none."""


@dataclass(frozen=True)
class Words:
    """Words to complete."""

    commands: tuple[Command, ...]
    """All subcommands; the first is meant where none is named."""
    rules: tuple[str, ...]
    """Codes and names of all rules."""


def words(rules: Iterable[str]) -> Words:
    """Return the grammar of the command line; *rules* are the selectors to complete."""
    return Words(tuple(_command(*each) for each in COMMANDS.items()), tuple(rules))


def _command(name: str, about: tuple[str, str]) -> Command:
    parser: Parser = import_module(about[0]).parser()
    actions = parser.actions
    rest = next((_value(one) for one in actions if not one.option_strings), None)
    return Command(name, about[1], tuple(_options(actions)), rest)


def _options(actions: Iterable[Action]) -> Iterator[Option]:
    for one in actions:
        if one.option_strings and one.help != SUPPRESS:
            flag = one.nargs == 0 or str(one.metavar).startswith("[")
            text = " ".join((one.help or "").split())
            yield Option(tuple(one.option_strings), text, None if flag else _value(one))


def _value(action: Action) -> Value:
    several = action.type is comma_list
    if said := choices(action.type) or KNOWN.get(action.dest):
        return Value("words", tuple(said), several)
    return Value(KINDS.get(str(action.metavar), "anything"), (), several)
