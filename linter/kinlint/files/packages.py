"""Locations of ROS packages and Gazebo models: `$(find x)`, `package://x` and `model://x`.

A package is looked for in this order, and nowhere before it is asked for:

1. where the user says (`--package x=DIR`, `[tool.kinlint.packages]`); 2. in the directories above
the file, by the name in their `package.xml`, or their own name, and beside these; 3. below what is
linted and below the working directory; 4. in the workspace: below the configuration's directory, in
`src` of the colcon or catkin workspace around the file, in its repository, and in the install space
of that workspace; 5. in the environment: AMENT_PREFIX_PATH, ROS_PACKAGE_PATH, CMAKE_PREFIX_PATH,
and for models GZ_SIM_RESOURCE_PATH and its elders. Below a directory, names in `package.xml` count.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote

from kinlint.files import url_mirror
from kinlint.files.bounded_read import head
from kinlint.files.environment import Environment, kind
from kinlint.files.pathglob import absolute
from kinlint.files.tracked_io import question
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import XML_COMMENT

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
_URI = re.compile(r"(package|model)://([^/]+)/?(.*)", re.DOTALL)
AMENT = "AMENT_PREFIX_PATH"
SOURCE = "src"
SPACES = ("build", "install", "log", "devel", ".catkin_tools")
"""Directories beside `src` that colcon and catkin make in a workspace."""
CATKIN = ".catkin"
"""File of a catkin space that lists where its packages were built from, with semicolons."""


class PackageLocation(NamedTuple):
    """Directory of a package, and how it was found."""

    directory: Path
    """The directory."""
    origin: str
    """Words on where it was found, which follow "found"."""


@dataclass
class Packages:
    """Packages that a file can name."""

    given: Mapping[str, Path] = field(default_factory=dict)
    """Packages that the user configured."""
    workspace: Path | None = None
    """Directory of the configuration file."""
    environment: Mapping[str, str] = field(default_factory=Environment)
    """Environment variables with the search paths of ROS and Gazebo."""
    linted: tuple[Path, ...] = ()
    """Directories that are linted, and the working directory: their packages come first."""
    _known: dict[tuple[str, Path], PackageLocation | None] = field(default_factory=dict, repr=False)
    _indexed: dict[Path, Mapping[str, Path]] = field(default_factory=dict, repr=False)
    _names: dict[Path, str | None] = field(default_factory=dict, repr=False)

    def find(self, name: str, near: Path) -> Path | None:
        """Return the directory of the package *name* for a file in the directory *near*."""
        found = self.locate(name, near)
        return None if found is None else found.directory

    def locate(self, name: str, near: Path) -> PackageLocation | None:
        """Return where the package *name* is for a file in *near*; None if it is not found."""
        if not name or "/" in name or name in (".", ".."):
            return None
        if name in self.given:
            return PackageLocation(self.given[name], "as configured")
        key = name, near
        if key not in self._known:
            self._known[key] = next(self._places(name, near), None)
        return self._known[key]

    def _places(self, name: str, near: Path) -> Iterator[PackageLocation]:
        for each in self._above(name, near):
            yield PackageLocation(each, "above the file or beside it")
        for root, origin in self._roots(near):
            if found := self._index(root).get(name):
                yield PackageLocation(found, origin)
        if (top := colcon_workspace(near)) is not None:
            spaces = ("install", f"install/{name}", "devel")
            yield from self._shared(name, [top / each for each in spaces], "in the install space")
        yield from self._in_environment(name)

    def _roots(self, near: Path) -> Iterator[tuple[Path, str]]:
        """Yield the directories below which packages of source code are searched, nearest first."""
        yield from ((root, f"in {root}, which is linted") for root in self.linted)
        if self.workspace is not None:
            yield self.workspace, f"below the configuration, in {self.workspace}"
        if (top := colcon_workspace(near)) is not None:
            yield top / SOURCE, f"in the workspace {top}"
        elif (top := _source_space(near)) is not None:
            yield top, f"in the workspace {top.parent}"
        if (top := repository(near)) is not None:
            yield top, f"in the repository {top}"

    def known(self, near: Path) -> Mapping[str, Path]:
        """Return the packages of source code that a file in *near* can name, by name."""
        found: dict[str, Path] = {}
        roots = [root for root, _ in self._roots(near)]
        for root in reversed([*roots, *self._path("ROS_PACKAGE_PATH")]):
            found |= self._index(root)
        for above in (*reversed(near.parents), near):
            if (name := self._manifest_name(above)) is not None:
                found[name] = above
        return {**found, **self.given}

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

    def _in_environment(self, name: str) -> Iterator[PackageLocation]:
        for variable in (AMENT, "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH"):
            origin, roots = f"by {variable}", [*self._path(variable)]
            if variable == "ROS_PACKAGE_PATH":
                sources = roots
            else:
                yield from self._shared(name, roots, origin)
                sources = [each for root in roots for each in _built_from(root)]
            for root in sources:
                if found := self._index(root).get(name):
                    yield PackageLocation(found, origin)

    def _shared(self, name: str, roots: Iterable[Path], origin: str) -> Iterator[PackageLocation]:
        """Yield the directory that one of the prefixes *roots* keeps for the package *name*.

        A prefix of ament needs no manifest.
        """
        ament = origin == f"by {AMENT}"
        for root in roots:
            share = root / "share" / name
            if kind(share / MANIFEST) == "file" or (ament and kind(share) == "directory"):
                yield PackageLocation(share, origin)

    def _model(self, name: str) -> Path | None:
        """Return the directory *name* in one where Gazebo keeps models."""
        roots = (root for variable in MODEL_PATHS for root in self._path(variable))
        return next((root / name for root in roots if kind(root / name) == "directory"), None)

    def search_paths(self) -> Iterator[Path]:
        """Yield the directories that the environment names for packages and models."""
        for variable in (AMENT, "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", *MODEL_PATHS):
            yield from self._path(variable)

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


@question
def _linked(marker: Path) -> str:
    """Return the text of the file *marker*; empty if there is none."""
    return head(marker, HEAD) or ""


def _built_from(prefix: Path) -> list[Path]:
    """Return the directories from which the catkin space *prefix* was built."""
    return [absolute(each) for each in _linked(prefix / CATKIN).split(";") if each.strip()]


def colcon_workspace(near: Path) -> Path | None:
    """Return the directory above *near* with `src` beside what colcon or catkin make, if any."""
    for each in (near, *near.parents):
        if kind(each / SOURCE) == "directory" and any(kind(each / name) for name in SPACES):
            return each
    return None


def _source_space(near: Path) -> Path | None:
    """Return the directory `src` above the package that *near* lies in, built or not, if any."""
    home = next((each for each in (near, *near.parents) if package_name(each) is not None), None)
    return next((each for each in home.parents if each.name == SOURCE), None) if home else None


def _is_top(directory: Path) -> bool:
    """Tell whether *directory* is the top of a working copy."""
    return kind(directory / REPOSITORY) is not None


def repository(near: Path) -> Path | None:
    """Return the top of the repository that *near* lies in, if it lies in one."""
    return next((each for each in (near, *near.parents) if _is_top(each)), None)


def working_copies(directory: Path) -> Iterator[Path]:
    """Yield the tops of the working copies around *directory*.

    That is one, and where it is a submodule or a linked one, those that it lies in.
    """
    for each in (directory, *directory.parents):
        mark = kind(each / REPOSITORY)
        if mark is not None:
            yield each
        if mark == "directory":
            return


@question
def package_name(directory: Path) -> str | None:
    """Return the name of the package *directory*, its own if the manifest says none; else None."""
    manifest = head(directory / MANIFEST, HEAD)
    match = None if manifest is None else _NAME.search(XML_COMMENT.sub("", manifest))
    return match[1] if match else None if manifest is None else directory.name


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
            url_mirror.provide(directory, content=False)
            try:
                with os.scandir(directory) as entries:
                    listed = sorted(entries, key=lambda entry: entry.name)
                    folders = [each.name for each in listed if each.is_dir(follow_symlinks=False)]
            except OSError:
                continue
            names = {each.name for each in listed}
            if directory != root and not names.isdisjoint(IGNORED):
                continue
            yield directory
            if MANIFEST not in names:
                below += [
                    directory / name
                    for name in folders
                    if name not in SKIPPED and not name.startswith(".")
                ]
        level = below
