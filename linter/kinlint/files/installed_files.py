"""Files that were installed or built: they are no part of the project that uses them."""

from __future__ import annotations

import os
from pathlib import Path

from kinlint.files.packages import AMENT

SYSTEM = tuple(map(Path, ("/opt/ros", "/usr", "/etc", "/lib", "/bin", "/sbin", "/snap", "/nix")))
"""Directories of installed files, on any system."""
SPACES = frozenset({"install", "devel", "site-packages", "dist-packages"})
"""Names of directories that build tools of ROS and Python install into."""
PREFIXES = (AMENT, "CMAKE_PREFIX_PATH", "COLCON_PREFIX_PATH")
"""Environment variables with directories that packages are installed into."""


def is_installed(path: Path) -> bool:
    """Tell whether the file at *path*, which is absolute, was installed."""
    if not SPACES.isdisjoint(path.parts):
        return True
    listed = (each for name in PREFIXES for each in os.environ.get(name, "").split(os.pathsep))
    roots = (*SYSTEM, *(Path(each) for each in listed if each))
    return any(path.is_relative_to(each) for each in roots)
