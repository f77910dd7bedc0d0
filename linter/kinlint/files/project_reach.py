"""The files that a file of a robot may include: those of its project and of packages.

What an untrusted repository names elsewhere, by an absolute path, `..` or a symbolic link, is not
read.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import chain
from pathlib import Path

from kinlint.files.bounded_read import Unreadable
from kinlint.files.packages import SOURCE, Packages, colcon_workspace, package_name, working_copies
from kinlint.files.pathname import real, shown
from kinlint.light_dataclasses import dataclass

UNMARKED = 3
"""Number of directories above a file that count as its project where nothing marks one."""


@dataclass(frozen=True)
class ProjectReach:
    """The files that one file may include."""

    near: Path
    """The path of the file that includes others."""
    packages: Packages
    """The packages that it can name."""

    def require(self, path: Path) -> None:
        """Raise `Unreadable` unless *path*, links followed, is in the project or in a package."""
        target = real(path)
        roots = chain(_project(self.near, self.packages), _searched(self.packages))
        if any(map(target.is_relative_to, roots)) or _in_package(target, self.near, self.packages):
            return
        raise Unreadable(f"'{shown(path)}' is outside of the project")


def _project(near: Path, packages: Packages) -> Iterator[Path]:
    """Yield the directories of the project that *near* lies in, links followed."""
    own = near.parent
    yield real(own)
    marked = [*working_copies(own), *_packages_above(own), *packages.linted]
    if packages.workspace is not None:
        marked.append(packages.workspace)
    if (top := colcon_workspace(own)) is not None:
        marked.append(top / SOURCE)
    home = (Path.home(), *Path.home().parents)
    with suppress(OSError):  # The working directory may be gone.
        marked += [each for each in (Path.cwd(),) if each not in home]
    around = [each for each in marked if own.is_relative_to(each)]
    yield from map(real, around)
    if not around:
        yield from (each for each in map(real, own.parents[:UNMARKED]) if each not in home)


def _packages_above(directory: Path) -> Iterator[Path]:
    return (each for each in (directory, *directory.parents) if package_name(each) is not None)


def _searched(packages: Packages) -> Iterator[Path]:
    """Yield the directories with packages that the user configured or has in the environment."""
    yield from map(real, packages.given.values())
    yield from map(real, packages.search_paths())


def _in_package(target: Path, near: Path, packages: Packages) -> bool:
    """Tell whether *target* lies in a package that *near* can name."""
    for each in target.parents:
        if (name := package_name(each)) is not None:
            found = packages.find(name, near.parent)
            return found is not None and real(found) == each
    return False
