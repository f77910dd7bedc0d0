"""Arguments for xacro files on the command line, as `xacro` takes them: `NAME:=VALUE`."""

from __future__ import annotations

import os
import re
import sys
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator

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


def unknown_arguments(
    pairs: Iterable[str], sources: Iterable[SourceText], packages_of: Callable[[str], Packages]
) -> Iterator[str]:
    """Yield a line for each of *pairs* that no xacro file of *sources* takes.

    Nor any that these include; *packages_of* returns the packages that the file of a name can name.
    Raises `UsageError`, at the end, if a pair is a slip of an argument that they take.
    """
    files = [each for each in sources if each.format and each.format.expands_to]
    declared = declared_arguments((each.name, each.text, packages_of(each.name)) for each in files)
    known, complete = declared.names, declared.complete
    slips = []
    for text in pairs if files else ():
        name = (name_and_value(text) or ("", ""))[0]
        meant = did_you_mean(name, sorted(known))
        line = f"no xacro file of this run has an argument '{name}'{meant}"
        if name in known:
            continue
        if complete and meant:
            slips.append(line)
        elif complete or meant:
            yield line
    if slips:
        raise UsageError("; ".join(slips))


def check_arguments(
    options: Namespace, sources: Iterable[SourceText], settings: Settings, *, quiet: bool = False
) -> None:
    """Write a warning for each argument of *options* that no xacro file of *sources* takes.

    Raises `UsageError`, *quiet* or not, for a slip of one that they take.
    """
    if options.xacro_arg:
        from kinlint.formats.options import ReadOptions  # noqa: PLC0415  loads the contexts

        packages_of = ReadOptions.from_settings(settings).packages_of
        for line in unknown_arguments(options.xacro_arg, sources, packages_of):
            if not quiet:
                sys.stderr.write(f"kinlint: warning: {line}\n")
