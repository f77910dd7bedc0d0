"""argparse with errors that are ours: one line, a suggestion, and no usage text in front."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NoReturn

from kinlint.configuration.value_kinds import SECONDS, unknown_message
from kinlint.errors import UsageError
from kinlint.suggestion import did_you_mean

FORMAT, OUTPUT_FORMAT = "--format", "--output-format"
_FORMAT_WORD = re.compile(rf"{FORMAT}(?==|\Z)")
UNSEEN = 80
"""Width of help that nobody reads: only help that is shown asks the terminal for its own."""
SILENCE = 120.0
"""Seconds that a store may be silent by default."""


class HelpShown(Exception):
    """The user asked for help and got it."""


class Parser(argparse.ArgumentParser):
    """A parser without abbreviations that raises `UsageError` with a suggestion."""

    def __init__(self, **options: Any) -> None:
        wide = partial(Formatter, width=UNSEEN)
        super().__init__(allow_abbrev=False, formatter_class=wide, add_help=False, **options)
        self._rest: str | None = None
        self._bare: set[str] = set()
        self.helping = self.add_argument_group("Help")
        self.helping.add_argument("-h", "--help", action="help", help="show this help")

    def read(self, arguments: Sequence[str]) -> argparse.Namespace:
        """The options in *arguments*, which may stand between the positional words.

        What follows `--` is no option. `--format` is short for `--output-format`, unless it means
        the format of something else here.
        """
        end = arguments.index("--") if "--" in arguments else len(arguments)
        words = [f"{word}=" if word in self._bare else word for word in arguments[:end]]
        known = self._option_string_actions
        if OUTPUT_FORMAT in known and FORMAT not in known:
            words = [_FORMAT_WORD.sub(OUTPUT_FORMAT, word) for word in words]
        options, strange = self.parse_known_intermixed_args(words)
        words = [word for word in strange if not word.startswith("-")] + list(arguments[end + 1 :])
        wrong = next((word for word in strange if word.startswith("-")), None)
        if wrong is not None:
            name = wrong.partition("=")[0]
            suggestion = did_you_mean(name, self._option_string_actions) if name[1:2] == "-" else ""
            self.error(f"unknown option '{name}'{suggestion or f'; {self.prog} --help lists them'}")
        if words and self._rest is None:
            self.error(f"unexpected argument '{words[0]}'")
        if self._rest is not None:
            setattr(options, self._rest, [*getattr(options, self._rest), *words])
        return options

    def add_positionals(self, name: str, metavar: str, text: str) -> None:
        """Take any number of words that are no options, as *name*."""
        self.add_argument(name, nargs="*", metavar=metavar, help=text)
        self._rest = name

    @property
    def actions(self) -> Sequence[argparse.Action]:
        """Return all arguments, in the order of the help."""
        return self._actions

    def require_equals(self, option: str) -> None:
        """Have *option* take its value behind `=` alone; without one it is empty."""
        self._bare.add(option)

    def error(self, message: str) -> NoReturn:
        """Raise `UsageError`."""
        message = message.removeprefix("argument ")
        raise UsageError(message.replace("ignored explicit argument", "takes no value, but has"))

    def format_help(self) -> str:
        """Return the help, as wide as the terminal."""
        self.formatter_class = Formatter
        return super().format_help()

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        """Raise `HelpShown`: nothing but help leaves the parser this way."""
        del status, message
        raise HelpShown


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Help with options at the left and their texts in one column."""

    def __init__(self, prog: str, width: int | None = None) -> None:
        super().__init__(prog, max_help_position=30, width=width)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        """Wrap a *text* of one line; lines that were broken by hand stay."""
        if "\n" not in text:
            return argparse.HelpFormatter._fill_text(self, text, width, indent)  # noqa: SLF001
        return super()._fill_text(text, width, indent)


def one_of(
    choices: tuple[str, ...], aliases: Mapping[str, str] | None = None
) -> Callable[[str], str]:
    """A type for arguments that must be one of *choices*, or of *aliases* for some of them."""

    def read(text: str) -> str:
        text = (aliases or {}).get(text, text)
        if problem := unknown_message(text, choices):
            raise argparse.ArgumentTypeError(problem)
        return text

    _choices[read] = choices
    return read


_choices: dict[object, tuple[str, ...]] = {}


def add_color(add: Callable[..., object]) -> None:
    """Add the option that says whether text is coloured."""
    add(
        "--color",
        type=one_of(("auto", "always", "never")),
        default="auto",
        metavar="WHEN",
        help="colour text: auto (on a terminal), always or never",
    )


def choices(kind: object) -> tuple[str, ...]:
    """Return the values that arguments of *kind* may have; empty if *kind* is no such type."""
    return _choices.get(kind, ())


def non_empty(text: str) -> str:
    """A type for arguments that may not be empty."""
    if not text:
        raise argparse.ArgumentTypeError("expected a value, got ''")
    return text


def comma_list(text: str) -> list[str]:
    """A type for arguments with several values, at least one, separated by commas."""
    parts = [part for each in text.split(",") if (part := each.strip())]
    if not parts:
        raise argparse.ArgumentTypeError(f"expected a value, got '{text}'")
    return parts


def seconds(text: str) -> float:
    """A type for arguments that are a number of seconds from 0 up."""
    try:
        found = float(text)
    except ValueError:
        found = -1.0
    if SECONDS.problem(found):
        raise argparse.ArgumentTypeError(f"expected a number of seconds, got '{text}'")
    return found


def count(text: str) -> int:
    """A type for arguments that are a number from 0 up."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"expected a number, got '{text}'")
    return int(text)


def dask_address(text: str) -> str:
    """Return *text*, the address of the scheduler of a Dask cluster."""
    if re.fullmatch(r"dask://(?:[\w.-]+|\[[0-9a-fA-F:]+\]):\d{1,5}", text) is None:
        raise argparse.ArgumentTypeError(f"'{text}' is no address such as dask://10.0.0.7:8786")
    return text


def add_store(made: Parser, title: str) -> Callable[..., object]:
    """Add the options for the address of a triple store; return what adds more under *title*."""
    add = made.add_argument_group(title).add_argument
    add(
        "--endpoint",
        type=non_empty,
        metavar="URL|NAME",
        help="SPARQL 1.1 endpoint of the store, or its name in your own configuration",
    )
    add(
        "--update-endpoint",
        type=non_empty,
        metavar="URL",
        help="where updates go (default: .../update for .../query, else the endpoint)",
    )
    add(
        "--endpoint-timeout",
        type=seconds,
        metavar="SECONDS",
        default=SILENCE,
        help=f"how long to wait for the store (default: {SILENCE:.0f})",
    )
    return add
