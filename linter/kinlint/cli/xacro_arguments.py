"""Arguments for xacro files on the command line, as `xacro` takes them: `NAME:=VALUE`."""

from __future__ import annotations

import os
import re
import sys
from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from kinlint.configuration.settings import Settings
from kinlint.errors import UsageError
from kinlint.files.packages import Packages
from kinlint.formats.declared_arguments import declared_arguments
from kinlint.suggestion import did_you_mean
from kinlint.text import SourceText

_ARGUMENT = re.compile(r"([A-Za-z_][\w.-]*):=.*", re.DOTALL)
_PAIR = re.compile(r"([^:=\s]+):?=(.*)", re.DOTALL)


def name_and_value(text: str) -> tuple[str, str] | None:
    """Return name and value of *text*, `NAME=VALUE` or `NAME:=VALUE`; None if it is neither."""
    match = _PAIR.fullmatch(text)
    return None if match is None else (match[1], match[2])


def take_arguments(options: Namespace) -> None:
    """Move the words `NAME:=VALUE` of *options* from the paths to the arguments for xacro."""
    words = [
        word for word in options.paths if _ARGUMENT.fullmatch(word) and not os.path.lexists(word)
    ]
    if words:
        options.paths = [each for each in options.paths if each not in words]
        options.xacro_arg = [*(options.xacro_arg or ()), *words]


class UnknownArguments(NamedTuple):
    """Arguments that no xacro file of a run takes, nor any that these include: a line for each."""

    slips: Mapping[str, str]
    """Lines for those that are slips of arguments that the files take, by what was written."""
    others: Sequence[str]
    """Lines for the others."""


NONE = UnknownArguments({}, ())


def unknown_arguments(
    pairs: Iterable[str], sources: Iterable[SourceText], packages_of: Callable[[str], Packages]
) -> UnknownArguments:
    """Return which of *pairs* no xacro file of *sources* takes.

    *packages_of* returns the packages that the file of a name can name.
    """
    files = [each for each in sources if each.format and each.format.expands_to]
    declared = declared_arguments((each.name, each.text, packages_of(each.name)) for each in files)
    known, complete = declared.names, declared.complete
    slips, others = {}, []
    for text in pairs if files else ():
        name = (name_and_value(text) or ("", ""))[0]
        meant = did_you_mean(name, sorted(known))
        line = f"no xacro file of this run has an argument '{name}'{meant}"
        if name in known:
            continue
        if complete and meant:
            slips[text] = line
        elif complete or meant:
            others.append(line)
    return UnknownArguments(slips, others)


def arguments_not_taken(
    options: Namespace, sources: Iterable[SourceText], settings: Settings
) -> UnknownArguments:
    """Return which arguments of *options* no xacro file of *sources* takes."""
    if not options.xacro_arg:
        return NONE
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415  loads the contexts

    return unknown_arguments(
        options.xacro_arg, sources, ReadOptions.from_settings(settings).packages_of
    )


def check_arguments(options: Namespace, sources: Iterable[SourceText], settings: Settings) -> None:
    """Write a warning for each argument of *options* that no xacro file of *sources* takes.

    Raises `UsageError` for a slip of one that they take.
    """
    unknown = arguments_not_taken(options, sources, settings)
    sys.stderr.writelines(f"kinlint: warning: {line}\n" for line in unknown.others)
    if unknown.slips:
        raise UsageError("; ".join(unknown.slips.values()))
