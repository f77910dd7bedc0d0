"""Arguments for xacro files on the command line, as `xacro` takes them: `NAME:=VALUE`."""

from __future__ import annotations

import os
import re
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.suggestion import did_you_mean
from kinlint.text import SourceText

_ARGUMENT = re.compile(r"([A-Za-z_][\w.-]*):=.*", re.DOTALL)
_PAIR = re.compile(r"([^:=\s]+):?=(.*)", re.DOTALL)
_NAMES = re.compile(
    r"""<xacro:arg\b[^>]*?\sname\s*=\s*["']([^"'$]+)["']|\$\(arg\s+([\w.-]+)\s*\)"""
    r"""|xacro\.arg\(\s*["']([^"']+)["']"""
)
_INCLUDED = re.compile(r"""<xacro:include\b[^>]*?\sfilename\s*=\s*["']([^"']+)["']""")
_FIND = re.compile(r"\$\(find\s+([\w.-]+)\s*\)")
MOST = 200
"""Most files that are included and looked into."""


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
    known, complete = _known(files, packages_of)
    for text in pairs:
        name = (name_and_value(text) or ("", ""))[0]
        meant = did_you_mean(name, sorted(known))
        if files and name not in known and (complete or meant):
            yield f"no xacro file of this run has an argument '{name}'{meant}"


def _known(
    files: Iterable[SourceText], packages_of: Callable[[str], Packages]
) -> tuple[set[str], bool]:
    """Return the names of the arguments of *files*, and whether all that they include was seen."""
    known, seen, complete = set[str](), set[Path](), True
    waiting = [(absolute(each.name), each.text, packages_of(each.name)) for each in files]
    while waiting:
        path, text, packages = waiting.pop()
        known |= {name for match in _NAMES.findall(text) for name in match if name}
        for written in _INCLUDED.findall(text):
            inner = written
            for name in _FIND.findall(written):
                found = packages.find(name, path.parent)
                inner = inner if found is None else _FIND.sub(found.as_posix(), inner, count=1)
            target = absolute(path.parent / inner)
            if "$" in inner or len(seen) > MOST:
                complete = False
            elif target not in seen:
                seen.add(target)
                try:
                    included = contents(target, path).decode("utf-8", "replace")
                except (Unreadable, SourceError):
                    complete = False
                else:
                    waiting.append((target, included, packages))
    return known, complete
