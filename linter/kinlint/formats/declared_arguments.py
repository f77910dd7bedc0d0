"""Arguments that xacro files take, found without expanding them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.text import XML_COMMENT

_DECLARED = re.compile(
    r"""<xacro:arg\b[^<>]*?\sname\s*=\s*["']([^"'$<]+)["']|\$\(arg\s+([\w.-]+)\s*\)"""
    r"""|xacro\.arg\(\s*["']([^"'<]+)["']"""
)
_INCLUDED = re.compile(r"""<xacro:include\b[^<>]*?\sfilename\s*=\s*["']([^"'<]+)["']""")
_FIND = re.compile(r"\$\(find\s+([\w.-]+)\s*\)")
_MACRO = re.compile(r"<xacro:arg\b[^<>]*?\sname\s*=\s*[\"'][^\"'<]*\$")
MOST = 200
"""Most files that are included and looked into."""


class DeclaredArguments(NamedTuple):
    """Arguments of xacro files and of all that they include."""

    names: frozenset[str]
    """Names that are declared or used."""
    complete: bool
    """True if all included files were read, and no name is computed."""


def declared_arguments(files: Iterable[tuple[str, str, Packages]]) -> DeclaredArguments:
    """Return the arguments of *files*: their names, texts and the packages that they can name."""
    known, seen, complete = set[str](), set[Path](), True
    waiting = [(absolute(name), text, packages) for name, text, packages in files]
    while waiting:
        path, text, packages = waiting.pop()
        text = XML_COMMENT.sub("", text)
        known |= {name for match in _DECLARED.findall(text) for name in match if name}
        complete = complete and _MACRO.search(text) is None
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
    return DeclaredArguments(frozenset(known), complete)
