"""Files that launch files name, which tells the configurations that belong to a robot.

Launch files are searched for names of files, not parsed: one that includes another names all that
this one names.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from kinlint.files.bounded_read import head
from kinlint.files.environment import listing

FOLDERS = ("launch",)
ENDINGS = (".py", ".xml", ".launch", ".yaml", ".yml")
HEAD = 1 << 16
MOST = 200
"""Most launch files that are looked into."""
_FILE = re.compile(
    r"(?<![\w.-])[\w.-]++(?:(?<=urdf)|(?<=srdf)|(?<=xacro)|(?<=yaml)|(?<=yml)|(?<=rviz)|(?<=launch)"
    r"|(?<=\.py)|(?<=\.xml))"
)
_PACKAGE = re.compile(
    r"""\$\(find(?:-pkg-share)?\s+([\w.-]+)\s*\)"""
    r"""|(?:FindPackageShare|get_package_share_directory|get_package_share_path|MoveItConfigsBuilder)"""
    r"""\(\s*(?:package\s*=\s*|package_name\s*=\s*)?["']([\w.-]+)["']"""
    r"""|\bpackage_name\s*=\s*["']([\w.-]+)["']"""
)


class Launch(NamedTuple):
    """Names that a launch file and those that it includes mention."""

    files: frozenset[str]
    """Names of files, without directories."""
    packages: frozenset[str]
    """Names of packages that files are found in."""


class LaunchMentions:
    """Launch files of packages, each read once."""

    def __init__(self) -> None:
        self._own: dict[Path, Launch] = {}
        self._homes: dict[Path, list[Path]] = {}

    def naming(self, name: str, homes: Iterable[Path]) -> list[Launch]:
        """Return what launch files in packages at *homes* mention that name the file *name*.

        Each with what those mention that it includes.
        """
        own = {path: self._own[path] for home in homes for path in self._in(home)}
        by_name: dict[str, list[Launch]] = {}
        for path, launch in own.items():
            by_name.setdefault(path.name, []).append(launch)
        return [all_ for each in own.values() if name in (all_ := _closure(each, by_name)).files]

    def _in(self, home: Path) -> list[Path]:
        if home not in self._homes:
            self._homes[home] = []
            for folder in FOLDERS:
                for name, inner in listing(home / folder).items():
                    path = home / folder / name
                    if not inner and name.endswith(ENDINGS) and len(self._own) < MOST:
                        self._own[path] = _launch(head(path, HEAD) or "")
                        self._homes[home].append(path)
        return self._homes[home]


def _launch(text: str) -> Launch:
    packages = (name for match in _PACKAGE.findall(text) for name in match if name)
    return Launch(frozenset(_FILE.findall(text)), frozenset(packages))


def _closure(launch: Launch, by_name: Mapping[str, Sequence[Launch]]) -> Launch:
    """Return *launch* with what those mention that it includes."""
    files, packages, waiting = set[str](), set[str](), [launch]
    while waiting:
        each = waiting.pop()
        new = each.files - files
        files |= new
        packages |= each.packages
        waiting += (one for name in sorted(new) for one in by_name.get(name, ()))
    return Launch(frozenset(files), frozenset(packages))
