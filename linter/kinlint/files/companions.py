"""Files that belong to others: the URDF that an SRDF was written for lies beside it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from kinlint.files.pathglob import absolute

FOLDERS = (".", "..", "urdf", "../urdf", "robots", "../robots")
"""Where to look, from the directory of an SRDF, the most likely first."""
PATTERNS = ("*.urdf", "*.urdf.xacro")


def urdfs_beside(srdf: Path) -> Iterator[Path]:
    """The URDF files that may describe the robot of the file at *srdf*, the nearest first."""
    for folder in dict.fromkeys(absolute(srdf.parent / folder) for folder in FOLDERS):
        for pattern in PATTERNS:
            yield from sorted(one for one in folder.glob(pattern) if one.is_file())
