"""Locations of ROS packages and Gazebo models: `$(find x)`, `package://x` and `model://x`.

A package is looked for in this order, and nowhere before it is asked for:

1. where the user says (`--package x=DIR`, `[tool.kinlint.packages]`); 2. in the directories above
the file, by the name in their `package.xml`, or their own name; 3. in the workspace: below the
configuration's directory or else in the repository, by the names in `package.xml`; 4. in
ROS_PACKAGE_PATH, GZ_SIM_RESOURCE_PATH and its elders for models, and AMENT_PREFIX_PATH.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from urllib.parse import unquote

from kinlint.files.bounded_read import head
from kinlint.files.environment import Environment, kind
from kinlint.files.pathglob import absolute
from kinlint.files.tracked_io import question
from kinlint.light_dataclasses import dataclass, field

MANIFEST = "package.xml"
REPOSITORY = ".git"
IGNORED = ("COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE")
"""Files that tell build tools of ROS to pass over a directory."""
SKIPPED = frozenset({"node_modules", "__pycache__", "site-packages", "build", "install", "log"})
DEPTH = 6
DIRECTORIES = 10_000
"""Limits of a search: depth below a directory, and number of directories in all."""
HEAD = 1 << 14
MODEL_PATHS = ("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH", "GAZEBO_MODEL_PATH")
_NAME = re.compile(r"<name>\s*([^<>\s]+)\s*</name>")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_URI = re.compile(r"(package|model)://([^/]+)/?(.*)", re.DOTALL)


@dataclass
class Packages:
    """Packages that a file can name."""

    given: Mapping[str, Path] = field(default_factory=dict)
    """Packages that the user configured."""
    workspace: Path | None = None
    """Directory in which others are searched for; by default, the repository of the file."""
    environment: Mapping[str, str] = field(default_factory=Environment)
    """Environment variables with the search paths of ROS and Gazebo."""
    _known: dict[tuple[str, Path], Path | None] = field(default_factory=dict, repr=False)
    _indexed: dict[Path, Mapping[str, Path]] = field(default_factory=dict, repr=False)
    _names: dict[Path, str | None] = field(default_factory=dict, repr=False)

    def find(self, name: str, near: Path) -> Path | None:
        """Return the directory of the package *name* for a file in the directory *near*."""
        if not name or "/" in name or name in (".", ".."):
            return None
        if name in self.given:
            return self.given[name]
        key = name, near
        if key not in self._known:
            found = (*self._above(name, near), *self._below(name, near), *self._installed(name))
            self._known[key] = found[0] if found else None
        return self._known[key]

    def resolve(self, uri: str, near: Path) -> Path | None:
        """Return the file of *uri*, `package://x/…` or `model://x/…`, be it there or not.

        None if there is no such package or model, or *uri* is another one.
        """
        match = _URI.fullmatch(uri)
        if match is None:
            return None
        scheme, name, below = match[1], match[2], unquote(match[3])
        home = self.find(name, near) or (self._model(name) if scheme == "model" else None)
        return None if home is None else absolute(home / below)

    def _above(self, name: str, near: Path) -> Iterator[Path]:
        """Yield a directory above that is the package, or else its neighbour of that name."""
        above = (near, *near.parents)
        yield from (each for each in above if self._manifest_name(each) == name)
        yield from (each for each in above if each.name == name)
        for each in above[: DEPTH - 1]:
            sibling = each / name
            if self._manifest_name(sibling) == name or (
                self._manifest_name(sibling) is None
                and kind(sibling) == "directory"
                and sibling != near
            ):
                yield sibling

    def _below(self, name: str, near: Path) -> Iterator[Path]:
        root = self.workspace or repository(near)
        if root is not None and (found := self._index(root).get(name)):
            yield found

    def _installed(self, name: str) -> Iterator[Path]:
        for root in self._path("ROS_PACKAGE_PATH"):
            if root.name == name and kind(root / MANIFEST) == "file":
                yield root
            elif found := self._index(root).get(name):
                yield found
        for root in self._path("AMENT_PREFIX_PATH"):
            share = root / "share" / name
            if kind(share) == "directory":
                yield share

    def _model(self, name: str) -> Path | None:
        """Return the directory *name* in one where Gazebo keeps models."""
        roots = (root for variable in MODEL_PATHS for root in self._path(variable))
        return next((root / name for root in roots if kind(root / name) == "directory"), None)

    def _path(self, variable: str) -> Iterator[Path]:
        for part in self.environment.get(variable, "").split(os.pathsep):
            if part:
                yield absolute(part)

    def _index(self, root: Path) -> Mapping[str, Path]:
        """Return the packages below *root*, indexed once."""
        if root not in self._indexed:
            self._indexed[root] = packages_below(root)
        return self._indexed[root]

    def _manifest_name(self, directory: Path) -> str | None:
        """Return the name of the package that *directory* is, if it is one."""
        if directory not in self._names:
            self._names[directory] = package_name(directory)
        return self._names[directory]


def _is_top(directory: Path) -> bool:
    """Tell whether *directory* is the top of a working copy."""
    return kind(directory / REPOSITORY) is not None


def repository(near: Path) -> Path | None:
    """Return the top of the repository that *near* lies in, if it lies in one."""
    return next((each for each in (near, *near.parents) if _is_top(each)), None)


@question
def package_name(directory: Path) -> str | None:
    """Return the name of the package that *directory* is, if it is one."""
    match = _NAME.search(_COMMENT.sub("", head(directory / MANIFEST, HEAD) or ""))
    return match[1] if match else None


@question
def packages_below(root: Path) -> dict[str, Path]:
    """Return the packages below *root*, by name; the first of a name counts."""
    found: dict[str, Path] = {}
    for directory in _directories(root):
        name = package_name(directory)
        if name is not None:
            found.setdefault(name, directory)
    return found


def _directories(root: Path) -> Iterator[Path]:
    """Yield *root* and directories below it, nearest first.

    None below a package, links not followed.
    """
    level, seen = [root], 0
    for _ in range(DEPTH + 1):
        below: list[Path] = []
        for directory in level:
            seen += 1
            if seen > DIRECTORIES:
                return
            try:
                with os.scandir(directory) as entries:
                    listed = sorted(entries, key=lambda entry: entry.name)
                    folders = [each.name for each in listed if each.is_dir(follow_symlinks=False)]
            except OSError:
                continue
            names = {each.name for each in listed}
            if not names.isdisjoint(IGNORED):
                continue
            yield directory
            if MANIFEST not in names:
                below += [
                    directory / name
                    for name in folders
                    if name not in SKIPPED and not name.startswith(".")
                ]
        level = below
