"""Tells documents of COLLADA that describe robots from those that are meshes, by their bytes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from kinlint.files.bounded_read import beginning
from kinlint.formats.collada.format import COLLADA

_KINEMATICS = re.compile(rb"<(?:[\w.-]+:)?(?:kinematics_model|articulated_system|rigid_body)[\s/>]")


def needs_extra(_path: Path) -> bool:
    """Tell whether the file at *path* is read by an extra that is missing; there is none."""
    return False


def robots(paths: Iterable[Path]) -> Iterator[Path]:
    """Yield those of *paths* with joints or rigid bodies, and all archives.

    Of those that cannot be read, their reader tells.
    """
    for path in paths:
        is_archive = path.suffix.lower() in COLLADA.archive_suffixes
        data = None if is_archive else beginning(path)
        if data is None or _KINEMATICS.search(data) is not None:
            yield path
