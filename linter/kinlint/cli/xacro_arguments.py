"""Arguments for xacro files on the command line, as `xacro` takes them: `NAME:=VALUE`."""

from __future__ import annotations

import os
import re
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator

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
    """
    files = [each for each in sources if each.format and each.format.expands_to]
    declared = declared_arguments((each.name, each.text, packages_of(each.name)) for each in files)
    known, complete = declared.names, declared.complete
    for text in pairs:
        name = (name_and_value(text) or ("", ""))[0]
        meant = did_you_mean(name, sorted(known))
        if files and name not in known and (complete or meant):
            yield f"no xacro file of this run has an argument '{name}'{meant}"
