"""Locations of files without the paths of this machine.

Every file gets a relative URI under a named base directory that has no URI of its own: output then
does not depend on the machine, and a viewer asks or knows where the base is.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any
from urllib.parse import quote

SOURCE_ROOT = "SRCROOT"


class Artifacts:
    """The files of one report.

    Relative names start at *root*. URIs start at *top*, the top of its repository: there GitHub
    and editors look for them, wherever in it kinlint ran.
    """

    def __init__(self, root: str, top: str | None = None) -> None:
        self._root = os.path.realpath(root)
        self._top = os.path.realpath(top or root)
        self._known: dict[str, dict[str, str]] = {}

    def location(self, name: str) -> dict[str, str]:
        """The `artifactLocation` of the file called *name*."""
        if name not in self._known:
            self._known[name] = self._locate(name)
        return dict(self._known[name])

    def bases(self) -> dict[str, Any]:
        """The `originalUriBaseIds` for all locations given so far."""
        used = {SOURCE_ROOT, *(location["uriBaseId"] for location in self._known.values())}
        return {base: {"description": {"text": _described(base)}} for base in sorted(used)}

    @property
    def outside(self) -> bool:
        """Tell whether some location given so far is not below the top."""
        return any(place["uriBaseId"] != SOURCE_ROOT for place in self._known.values())

    def _locate(self, name: str) -> dict[str, str]:
        path = os.path.realpath(os.path.join(self._root, name))  # noqa: PTH118
        try:
            parts = Path(os.path.relpath(path, self._top)).parts
        except ValueError:  # another drive
            parts = Path(path).parts[1:]
        up = parts.count(os.pardir)
        base = f"PARENT{up}" if up else SOURCE_ROOT
        return {
            "uri": quote("/".join(parts[up:]).encode("utf-8", "surrogateescape")),
            "uriBaseId": base,
        }


def _described(base: str) -> str:
    if base == SOURCE_ROOT:
        return "The top of the repository, or where kinlint ran."
    return f"The directory {base.removeprefix('PARENT')} above {SOURCE_ROOT}."
