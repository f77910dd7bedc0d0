"""Finds the files that an SDF file includes; only here, never on the network."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from urllib.parse import unquote

from kinlint.files.bounded_read import head
from kinlint.files.environment import kind, listing
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.light_dataclasses import dataclass
from kinlint.text import XML_COMMENT
from kinlint.uri_references import split_uri

MANIFESTS = ("model.config", "manifest.xml")
DEFAULT = "model.sdf"
_SDF = re.compile(r"<sdf\b([^<>]*)>([^<>]*)</sdf>")
_VERSION = re.compile(r"\bversion\s*=\s*[\"']([\d.]+)[\"']")
NEWEST = (1, 12)
HEAD = 1 << 16
LOCAL = ("", "file", "model", "package")


@dataclass(frozen=True)
class MissingModel:
    """Why there is no file to include."""

    reason: str
    """The reason, in words."""


def locate(uri: str, chain: tuple[Path, ...], packages: Packages) -> Path | MissingModel:
    """Return the SDF file that *uri* names in the last file of *chain*.

    The files of the chain include each other.
    """
    scheme = split_uri(uri).scheme if "://" in uri else ""
    if scheme not in LOCAL:
        return MissingModel("it is on the network")
    candidates = _candidates(uri, scheme, chain[-1].parent, packages)
    found = next((each for each in candidates if each in chain or kind(each)), None)
    if found is None:
        return MissingModel("there is no such file or model")
    if kind(found) != "directory":
        return found
    inner = _named_by_manifest(found)
    if inner is None:
        return MissingModel(f"the directory has no {MANIFESTS[0]}")
    if kind(inner) == "file":
        return inner
    return MissingModel(f"its {MANIFESTS[0]} names {inner.name}, which is not there")


def _candidates(uri: str, scheme: str, near: Path, packages: Packages) -> Iterator[Path]:
    """Yield the paths to try: next to the including file, then among the known models."""
    if scheme in ("model", "package"):
        resolved = packages.resolve(uri, near)
        if resolved is not None:
            yield resolved
        return
    path = unquote(uri.removeprefix("file://"))
    yield absolute(near / path)
    if scheme == "" and not path.startswith("/"):
        resolved = packages.resolve(f"model://{path}", near)
        if resolved is not None:
            yield resolved


def _named_by_manifest(directory: Path) -> Path | None:
    """Return the file of the newest version of the model in *directory*, by its manifest.

    Without a manifest it is `model.sdf`, or the only SDF file there.
    """
    for name in MANIFESTS:
        text = XML_COMMENT.sub("", head(directory / name, HEAD) or "")
        versions: Mapping[tuple[int, ...], str] = {
            _version(match[1]): match[2].strip()
            for match in _SDF.finditer(text)
            if match[2].strip()
        }
        readable = {each: file for each, file in versions.items() if each <= NEWEST}
        if readable:
            return directory / readable[max(readable)]
    if kind(default := directory / DEFAULT) == "file":
        return default
    others = [name for name in listing(directory) if name.endswith(".sdf")]
    return directory / others[0] if len(others) == 1 else None


def _version(attributes: str) -> tuple[int, ...]:
    match = _VERSION.search(attributes)
    return tuple(int(part) for part in match[1].split(".") if part) if match else ()
