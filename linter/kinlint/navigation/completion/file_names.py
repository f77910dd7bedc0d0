"""Names of files: packages, models, and what is in them or beside the text."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import quote, unquote

from kinlint.files.packages import MANIFEST
from kinlint.navigation.completion.candidate import Candidate, Kind
from kinlint.navigation.completion.situation import Situation

PACKAGE, MODEL = "package://", "model://"
SCHEMES = (PACKAGE, MODEL, "file://")
MOST = 1_000
"""Most entries of a directory that are offered."""


def file_names(situation: Situation, written: str) -> Iterator[Candidate]:
    """Yield the next step of the path *written* so far, each with what is written before it."""
    scheme = next((each for each in SCHEMES if written.startswith(each)), "")
    if not scheme and "://" in written:
        return
    path = written.removeprefix(scheme)
    folder, slash, _ = path.rpartition("/")
    if scheme in (PACKAGE, MODEL) and not slash:
        yield from packages(situation, f"{scheme}", "/")
        return
    if not written:
        yield from (Candidate(each, Kind.WORD, rank=2, again=True) for each in SCHEMES[:2])
    directory = _directory(situation, scheme, folder, absolute=path.startswith("/"))
    if directory is not None:
        yield from entries(directory, f"{scheme}{folder}{slash}", quote if scheme else str)


def packages(situation: Situation, before: str, behind: str) -> Iterator[Candidate]:
    """Yield the packages that the text can name, written between *before* and *behind*."""
    for name, home in situation.packages.known(situation.directory).items():
        yield Candidate(f"{before}{name}{behind}", Kind.FOLDER, str(home), again=bool(behind))


def entries(
    directory: Path, before: str, encode: Callable[[str], str] = str
) -> Iterator[Candidate]:
    """Yield what is in *directory*, written behind *before*; what is hidden is left out."""
    try:
        with os.scandir(directory) as found:
            listed = sorted(found, key=lambda each: each.name)[:MOST]
    except OSError:
        return
    for each in listed:
        if each.name.startswith(".") or each.name == MANIFEST:
            continue
        if each.is_dir():
            yield Candidate(f"{before}{encode(each.name)}/", Kind.FOLDER, rank=2, again=True)
        else:
            yield Candidate(f"{before}{encode(each.name)}", Kind.FILE)


def _directory(situation: Situation, scheme: str, folder: str, *, absolute: bool) -> Path | None:
    """Return the directory *folder*, which is written behind *scheme*."""
    if scheme in (PACKAGE, MODEL):
        return situation.packages.resolve(f"{scheme}{folder}/", situation.directory)
    if absolute:
        return Path(f"{unquote(folder) if scheme else folder}/")
    return None if scheme else situation.directory / folder
