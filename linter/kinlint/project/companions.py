"""Reads the URDF files that SRDF files were written for, where they are not given themselves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from kinlint.configuration.settings import Settings
from kinlint.errors import ConfigError, SourceError
from kinlint.files.companions import urdfs_beside
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import missing, real, shown
from kinlint.formats.registry import decode
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.srdf.pairing import Description, describe, partners
from kinlint.text import SourceText


def companions(
    sources: Sequence[SourceText], settings: Settings, overlay: Mapping[Path, SourceText]
) -> list[SourceText]:
    """The texts that *sources* are about and that are not among them.

    *overlay* has texts that files are taken to hold, by their real paths. Raises `ConfigError`
    where a configuration names a URDF that cannot be read.
    """
    told = settings.partner
    known = partners(sources, told)
    given = {absolute(source.name) for source in sources}
    found: dict[Path, SourceText] = {}
    for srdf in _srdfs(sources):
        name = srdf.source.name
        if name in known:
            continue
        if (path := told(name)) is not None:
            found[Path(path)] = _told(Path(path), overlay)
        elif name[:1] != "<":
            beside = (one for one in urdfs_beside(absolute(name)) if one not in given)
            found.update(_fitting(srdf, beside, overlay))
    return list(found.values())


def _srdfs(sources: Iterable[SourceText]) -> Iterator[Description]:
    for each in map(describe, sources):
        if each is not None and each.kind == SRDF:
            yield each


def _fitting(
    srdf: Description, candidates: Iterable[Path], overlay: Mapping[Path, SourceText]
) -> dict[Path, SourceText]:
    """The first of *candidates* that *srdf* may be about, with its text."""
    for path in candidates:
        try:
            urdf = describe(_companion(path, overlay))
        except (OSError, SourceError):
            continue
        if urdf is not None and not urdf.varies and srdf.may_mean(urdf):
            return {path: urdf.source}
    return {}


def _companion(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    if overlay and (open_ := overlay.get(real(path))):
        return replace(open_, companion=True)
    if not path.is_file():
        raise SourceError(shown(path), "not a regular file")
    return replace(decode(shown(path), path.read_bytes()), companion=True)


def _told(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    try:
        return _companion(path, overlay)
    except (OSError, SourceError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        problem = cause if path.exists() else missing(path)
        raise ConfigError(f"srdf: {shown(path)}: {problem}") from None
