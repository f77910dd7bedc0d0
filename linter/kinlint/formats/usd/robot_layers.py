"""Tells stages that describe robots from those that are meshes, by their bytes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path

from kinlint.files.bounded_read import beginning
from kinlint.files.pathglob import absolute
from kinlint.formats.usd.format import CRATE, PACKAGE

_BODIES = re.compile(
    rb'\bapiSchemas\s*=\s*\[?[^\]\n]{0,2000}"Physics(?:RigidBody|ArticulationRoot)API"'
    rb'|\bdef\s+Physics\w*Joint\s+"'
)
_ASSET = re.compile(rb"@([^@\s][^@\n]*?\.usd[acz]?)@", re.IGNORECASE)
_PACKED = b"hysics"
"""Part of the names of schemas of physics that crates have, compressed as they are."""


def needs_extra(path: Path) -> bool:
    """Tell whether the layer at *path* is binary, and usd-core, which reads it, is missing."""
    data = beginning(path)
    return data is not None and _has_crate(data) and find_spec("pxr") is None


def robots(layers: Iterable[Path]) -> Iterator[Path]:
    """Yield those of *layers* that lead to bodies or have some, and to which no other leads.

    Of those that cannot be read, their reader tells.
    """
    named = {absolute(each): each for each in layers}
    bodies: dict[Path, bool] = {}
    led: dict[Path, list[Path]] = {}
    for path in named:
        data = beginning(path)
        bodies[path] = data is None or _describes_bodies(data)
        led[path] = [each for each in _assets(path, data or b"") if each in named]
    reached = {path: _reached(path, led) for path in named}
    parts = {e for path in named for e in reached[path] if path not in reached[e]}
    for path, given in named.items():
        if path not in parts and any(bodies[each] for each in reached[path]):
            yield given


def _describes_bodies(data: bytes) -> bool:
    """Tell whether *data* may describe bodies; nobody reads a crate without usd-core."""
    if _has_crate(data):
        return _PACKED in data and find_spec("pxr") is not None
    return _BODIES.search(data) is not None


def _has_crate(data: bytes) -> bool:
    return data.startswith(CRATE) or (data.startswith(PACKAGE) and CRATE in data)


def _assets(path: Path, data: bytes) -> Iterator[Path]:
    """Yield the paths of the layers that *data* of the layer at *path*, if it is text, names."""
    for each in () if data.startswith((CRATE, PACKAGE)) else dict.fromkeys(_ASSET.findall(data)):
        yield absolute(path.parent / each.decode("utf-8", "replace"))


def _reached(path: Path, led: Mapping[Path, list[Path]]) -> set[Path]:
    """Return *path* and all layers that it leads to."""
    found = {path}
    pending = [path]
    while pending:
        new = [each for each in led[pending.pop()] if each not in found]
        found.update(new)
        pending += new
    return found
