"""Checks that the files a model names exist, reading each directory once."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import TypeAlias

from kinlint.files.environment import listing
from kinlint.files.packages import DEPTH, DIRECTORIES, SKIPPED, Packages, package_name
from kinlint.files.pathglob import absolute
from kinlint.light_dataclasses import dataclass, field
from kinlint.suggestion import nearest

PACKAGED = re.compile(r"((?:package|model)://([^/]+)/)/*")
ELSEWHERE = re.compile(r"[\w+.-]+:|[/\\~]|.*(?:\$[({]|\\)", re.DOTALL)
"""Start of a reference that is neither in a package nor relative to the file: it is not checked."""
KINDS = (
    frozenset({".stl", ".dae", ".obj", ".ply", ".glb", ".gltf", ".vtk", ".off", ".wrl", ".usd"}),
    frozenset({".png", ".jpg", ".jpeg", ".tga", ".tif", ".tiff", ".bmp", ".gif", ".dds", ".hdr"}),
)
"""Suffixes of meshes, and of textures."""


@dataclass(frozen=True, slots=True)
class Missing:
    """A file that is not there, though the place for it is; `resembles` is what may be meant."""

    resembles: str | None = None
    """Name of a similar file in that place; None if there is none."""


@dataclass(frozen=True, slots=True)
class UnknownPackage:
    """No package, or model, of this name is known."""

    name: str
    """Name of the package or model."""


@dataclass(frozen=True, slots=True)
class AbsentDirectory:
    """The files of this kind are not here at all: their directory is not, or it has none."""

    name: str
    """The directory, as it is referred to."""


Fault: TypeAlias = Missing | UnknownPackage | AbsentDirectory


@dataclass
class References:
    """Looks up what files name; remembers what it saw, so it is to be used for one run."""

    packages: Packages
    """Packages and models that are known."""
    _names: dict[Path, Mapping[str, bool]] = field(default_factory=dict)
    _below: dict[Path, Mapping[str, list[str]]] = field(default_factory=dict)
    _faults: dict[tuple[str, Path], Fault | None] = field(default_factory=dict)

    def fault(self, written: str, near: Path) -> Fault | None:
        """Return the fault of the reference *written* in a file in *near*; None if it is sound.

        Absolute paths and addresses, which mean something elsewhere, are not checked.
        """
        key = written, near
        if key not in self._faults:
            self._faults[key] = self._look(written, near)
        return self._faults[key]

    def path(self, written: str, near: Path) -> Path | None:
        """Return the path of the file that *written* means in *near*; None if it is not checked."""
        if PACKAGED.match(written) is None:
            return None if ELSEWHERE.match(written) else absolute(near / written)
        return None if "$" in written else self.packages.resolve(written, near)

    def _look(self, written: str, near: Path) -> Fault | None:
        packaged = PACKAGED.match(written)
        if packaged is None:
            if not written.strip() or ELSEWHERE.match(written):
                return None
            return self._missing("", near, absolute(near / written))
        if "$" in written:
            return None
        prefix, name = packaged[1], packaged[2]
        root = self.packages.resolve(prefix, near)
        target = self.packages.resolve(prefix + written[packaged.end() :], near)
        if root is None or target is None:
            return UnknownPackage(name)
        fault = self._missing(prefix, root, target)
        if isinstance(fault, Missing) and (own := self._in_own_package(target, root, near)):
            return Missing(own)
        return fault

    def _in_own_package(self, target: Path, root: Path, near: Path) -> str | None:
        """Return the URI of the file in the package of *near* at the path of *target* in *root*.

        None if there is none. A description that was copied keeps the paths below its package.
        """
        for above in (near, *near.parents):
            name = package_name(above)
            if name is not None:
                inner = Path(os.path.relpath(target, root))
                there = above / inner
                known = inner.parts[0] != ".." and inner.name in self._listing(there.parent)
                return f"package://{name}/{inner.as_posix()}" if known and above != root else None
        return None

    def _missing(self, prefix: str, root: Path, target: Path) -> Fault | None:
        """Return the fault of *target*, a file expected in or near *root*."""
        start = Path(os.path.commonpath([root, target]))
        at, spelt = start, True
        for part in target.relative_to(start).parts:
            name = self._entry(at, part)
            if name is None:
                absent = at / part
                break
            at, spelt = at / name, spelt and name == part
        else:
            return None if spelt else Missing(_written(prefix, root, at))
        found = self._below_of(root).get(target.name.casefold(), [])
        if len(found) == 1:
            return Missing(prefix + found[0])
        if absent == target:
            files = (name for name, folder in self._listing(at).items() if not folder)
            if alike := _of_kind(files, target.suffix):
                similar = nearest(target.name, alike)
                return Missing(similar and _written(prefix, root, at / similar))
        return AbsentDirectory(_written(prefix, root, at if absent == target else absent))

    def _entry(self, directory: Path, name: str) -> str | None:
        """Return the spelling of the entry *name* in *directory*, ignoring case.

        None if there is none.
        """
        names = self._listing(directory)
        if name in names:
            return name
        alike = [each for each in names if each.casefold() == name.casefold()]
        return alike[0] if len(alike) == 1 else None

    def _listing(self, directory: Path) -> Mapping[str, bool]:
        """Return the entries of *directory*, and whether each is a directory."""
        if directory not in self._names:
            self._names[directory] = listing(directory)
        return self._names[directory]

    def _below_of(self, root: Path) -> Mapping[str, list[str]]:
        """Return the paths of the files in and below *root*, by their names in lower case."""
        if root not in self._below:
            found: dict[str, list[str]] = {}
            for path in self._files(root):
                found.setdefault(path.name.casefold(), []).append(str(path))
            self._below[root] = found
        return self._below[root]

    def _files(self, root: Path) -> Iterator[PurePosixPath]:
        level, seen = [PurePosixPath()], 0
        for _ in range(DEPTH):
            below: list[PurePosixPath] = []
            for directory in level:
                seen += 1
                if seen > DIRECTORIES:
                    return
                for name, folder in self._listing(root / directory).items():
                    if not folder:
                        yield directory / name
                    elif name not in SKIPPED and not name.startswith("."):
                        below.append(directory / name)
            level = below


def _of_kind(names: Iterable[str], suffix: str) -> list[str]:
    """Return those of *names* whose kind of file is that of *suffix*."""
    own = suffix.lower()
    kind = next((kind for kind in KINDS if own in kind), {own})
    return [name for name in names if PurePosixPath(name).suffix.lower() in kind]


def _written(prefix: str, root: Path, path: Path) -> str:
    """Return *path* as a model writes it that names *root* by *prefix*."""
    below = Path(os.path.relpath(path, root)).as_posix()
    return (prefix.rstrip("/") if below == "." else prefix + below) or "."
