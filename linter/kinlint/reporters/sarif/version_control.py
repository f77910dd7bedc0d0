"""The repository and revision that files come from, read from `.git` without running git."""

from __future__ import annotations

import re
from configparser import ConfigParser
from configparser import Error as ConfigParserError
from pathlib import Path
from typing import Any
from urllib.parse import quote

from kinlint.reporters.sarif.artifact_location import SOURCE_ROOT

LOCAL = "urn:kinlint:repository:"
"""Begins the name of a repository that is on no server."""
_SCP = re.compile(r"(?:[\w.-]+@)?([\w.-]+):(?!//)/?(.+)")
_WEB = re.compile(r"(?:https?|ssh|git)://(?:[^@/]+@)?([^/:]+)(?::\d+)?/(.+)")


def repository_top(start: str) -> str | None:
    """The nearest directory at or above *start* that is the top of a git working tree."""
    for directory in (Path(start), *Path(start).parents):
        if (directory / ".git").exists():
            return str(directory)
    return None


def provenance(top: str) -> dict[str, Any] | None:
    """The `versionControlDetails` of the working tree with its top at *top*.

    The repository is called as the remote on a server, origin if there are several; credentials
    in its URL are left out. One without is called by its directory, not by its place on this
    machine. None if it cannot be read.
    """
    try:
        git = _directory(Path(top) / ".git")
        shared = git / _read(git / "commondir") if (git / "commondir").is_file() else git
        uri = _remote(shared) or f"{LOCAL}{quote(Path(top).name)}"
        head = _read(git / "HEAD")
        revision = _revision(git, shared, head)
    except (OSError, UnicodeDecodeError, ConfigParserError):
        return None
    details: dict[str, Any] = {"repositoryUri": uri}
    if revision:
        details["revisionId"] = revision
    if head.startswith("ref: refs/heads/"):
        details["branch"] = head.removeprefix("ref: refs/heads/")
    return {**details, "mappedTo": {"uriBaseId": SOURCE_ROOT}}


def _directory(entry: Path) -> Path:
    """Return the directory of git: `.git`, or the one that the file `.git` names."""
    if entry.is_file():
        return entry.parent / _read(entry).removeprefix("gitdir: ")
    return entry


def _remote(git: Path) -> str:
    config = ConfigParser(strict=False, interpolation=None, allow_no_value=True)
    config.read_string(re.sub(r"(?m)^\s+", "", _read(git / "config")))
    names = [name for name in config.sections() if name.startswith("remote ")]
    for name in sorted(names, key=lambda name: name != 'remote "origin"'):
        url = config.get(name, "url", fallback="") or ""
        if match := _WEB.fullmatch(url) or _SCP.fullmatch(url):
            return f"https://{match[1]}/{match[2].removesuffix('.git')}"
    return ""


def _revision(git: Path, shared: Path, head: str) -> str:
    if not head.startswith("ref: "):
        return head
    name = head.removeprefix("ref: ")
    for place in (git, shared):
        if (place / name).is_file():
            return _read(place / name)
    packed = shared / "packed-refs"
    lines = _read(packed).splitlines() if packed.is_file() else []
    return next((line.split(" ", 1)[0] for line in lines if line.endswith(f" {name}")), "")


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8").strip()
