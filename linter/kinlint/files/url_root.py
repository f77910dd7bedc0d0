"""Addresses of files: the place that holds them, and the files that they stand for."""

from __future__ import annotations

import re
from typing import Any

from kinlint.errors import SourceError, UsageError
from kinlint.files.glob_alternatives import alternatives
from kinlint.light_dataclasses import dataclass

MAGIC = re.compile(r"[*?\[{]")
MEMBER = "!/"


@dataclass(frozen=True)
class Root:
    """The place of the files of a URL: a bucket, a host, an archive or a repository."""

    url: str
    """The address by which fsspec finds it."""
    name: str
    """Beginning of the names of its files."""
    base: str
    """Beginning of their paths, as fsspec has them."""
    directory: str
    """Directory of the mirrors of the run."""


def system_of(url: str) -> tuple[Any, str]:
    """Return the file system of *url*, and the path in it."""
    try:
        from fsspec.core import url_to_fs  # noqa: PLC0415  few runs read URLs
    except ImportError:
        raise UsageError(f"'{url}': pip install 'kinlint[urls]'") from None
    try:
        system, path = url_to_fs(url)
    except (ImportError, ValueError) as error:
        raise UsageError(f"'{url}': {error}") from None
    except Exception as error:  # noqa: BLE001  each file system has its own
        raise SourceError(url, cause_of(error)) from None
    return system, str(path)


def root_of(url: str, path: str, directory: str) -> Root:
    """Return what holds *path*, which fsspec understands *url* to mean."""
    first, chain, inner = url.partition("::")
    scheme = first.partition("://")[0]
    if chain:
        return Root(f"{scheme}://::{inner}", f"{scheme}://{inner}{MEMBER}", "", directory)
    if first.partition("://")[2].strip("/") != path.strip("/") and "://" not in path:
        start = first[: len(first) - len(path)].rstrip("/") + "/"  # a repository and its revision
        return Root(start, start, "", directory)
    if "://" in path:  # HTTP's paths are addresses
        host = re.match(r"\w+://[^/]*/", f"{path}/")
        base = host[0] if host else path
        return Root(base, base, base, directory)
    start = "/" if path.startswith("/") else ""
    base = path.lstrip("/").partition("/")[0] + "/"
    return Root(f"{scheme}://{start}{base}", f"{scheme}://{base}", start + base, directory)


def expanded(system: Any, path: str) -> list[str]:
    """Return the paths of the files that *path* stands for, which may be a directory or a glob."""
    if MAGIC.search(path):
        found = dict[str, Any]()
        for each in alternatives(path):
            found |= system.glob(each, detail=True)
        return sorted(name for name, about in found.items() if about["type"] == "file")
    if path and system.isfile(path):
        return [path]
    found = system.find(path, detail=True)
    if not found:
        raise FileNotFoundError(path)
    return sorted(name for name, about in found.items() if about["type"] == "file")


def cause_of(error: Exception) -> str:
    """Return *error* of a file system in words."""
    told = str(error).strip().splitlines()
    return f"{type(error).__name__}: {told[0]}" if told else type(error).__name__
