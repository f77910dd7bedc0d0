"""Files by URL: a mirror of what is asked for, below a directory of this run.

An address that the user names is mirrored with what lies below its host, bucket, archive or
repository, and no other one is ever asked. Directories are listed, and files are fetched, when a
question is about them, so that all that reads files reads these like others. Names of mirrored
files are their URLs; a member of an archive is `zip://ARCHIVE!/MEMBER`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinlint.errors import SourceError
from kinlint.light_dataclasses import dataclass, field

if TYPE_CHECKING:
    from kinlint.files.url_root import Root

_URL = re.compile(r"[A-Za-z][\w+.-]+://")
_ARCHIVE = re.compile(r"zip://(.+?\.zip)(?:!?/(.*))?", re.DOTALL | re.IGNORECASE)
LARGEST = 1 << 26
"""Bytes of the beginning of a file that are fetched: none that is larger is read."""
MOST_KEPT = 1 << 30
"""Bytes that a process keeps of fetched files."""
LEVELS = ("url", "of", "files")
"""Directories around a mirror, so that what is near it is near nothing else."""


@dataclass
class UrlMirror:
    """The mirror of one process."""

    root: Root
    """The place that is mirrored."""
    top: Path
    """The directory that stands for it."""
    process: int
    """The process whose mirror this is."""
    _system: Any = None
    _listed: set[str] = field(default_factory=set)
    _sizes: dict[str, int] = field(default_factory=dict)
    _fetched: dict[str, int] = field(default_factory=dict)

    @property
    def system(self) -> Any:
        """The file system of fsspec."""
        if self._system is None:
            from kinlint.files.url_root import system_of  # noqa: PLC0415  few runs

            self._system = system_of(self.root.url)[0]
        return self._system

    def provide(self, below: str, *, content: bool) -> None:
        """Have the mirror hold *below*, a path in it; if *content*, what is in that file."""
        steps = [each for each in below.split("/") if each != "."]
        for number in range(len(steps) + 1):
            here = "/".join(steps[:number])
            if number and not (self.top / here).is_dir():
                break
            self._list(here)
        if content and below in self._sizes and below not in self._fetched:
            self._store(below, self._asked(self.system.cat_file, below, end=LARGEST))

    def has(self, path: Path) -> bool:
        """Tell whether what is in the file at *path* was fetched."""
        inside = path.is_relative_to(self.top)
        return inside and path.relative_to(self.top).as_posix() in self._fetched

    def fetch(self, every: Sequence[str]) -> None:
        """Have the mirror hold the files *every*, which are there, all at once."""
        self._forget()
        wanted = [each for each in every if each not in self._fetched]
        if not wanted:
            return
        paths = {self.root.base + each: each for each in wanted}
        found = self.system.cat(list(paths), on_error="return")
        found = found if isinstance(found, dict) else {next(iter(paths)): found}
        for path, data in found.items():
            if isinstance(data, bytes) and path in paths:
                self._store(paths[path], data[: LARGEST + 1])

    def _list(self, below: str) -> None:
        if below in self._listed:
            return
        self._listed.add(below)
        (self.top / below).mkdir(parents=True, exist_ok=True)
        for entry in self._asked(self.system.ls, below, detail=True) or ():
            inner = str(entry["name"]).removeprefix(self.root.base).strip("/")
            name = inner.rpartition("/")[2]
            if inner.rpartition("/")[0] != below or name in {"", ".", ".."}:
                continue
            path = self.top / inner
            with suppress(OSError, ValueError):  # a name that no file here can have
                if entry["type"] == "directory":
                    path.mkdir(exist_ok=True)
                elif not path.is_dir():
                    self._sizes[inner] = int(entry.get("size") or 0)
                    with path.open("ab") as stream:
                        stream.truncate(self._sizes[inner])

    def _asked(self, ask: Any, below: str, **given: Any) -> Any:
        """Return what *ask* answers about *below*; None if there is no such file."""
        try:
            return ask(self.root.base + below, **given)
        except (FileNotFoundError, NotADirectoryError):
            return None
        except Exception as error:  # noqa: BLE001  each file system has its own
            from kinlint.files.url_root import cause_of  # noqa: PLC0415  see above

            raise SourceError(self.root.name + below, cause_of(error)) from None

    def _store(self, below: str, data: bytes | None) -> None:
        if data is None:
            return
        path = self.top / below
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        if self._sizes.get(below, 0) > len(data):
            os.truncate(path, self._sizes[below])
        self._fetched[below] = len(data)

    def _forget(self) -> None:
        """Begin anew if too much is kept."""
        if sum(self._fetched.values()) > MOST_KEPT:
            _remove(self.top)
            for each in (self._listed, self._sizes, self._fetched):
                each.clear()


_mirrors: dict[str, UrlMirror] = {}
"""The mirrors of this process, by the names that those of their files begin with."""


def in_use() -> bool:
    """Tell whether this process has any mirror."""
    return bool(_mirrors)


def is_url(given: str) -> bool:
    """Tell whether *given* is the address of files elsewhere."""
    return _URL.match(given) is not None


def mirrored() -> tuple[Root, ...]:
    """Return what this process has mirrors of."""
    return tuple(each.root for each in _mirrors.values())


def mirror(roots: Sequence[Root]) -> None:
    """Let this process mirror *roots*."""
    for root in roots:
        known = _mirrors.get(root.name)
        if known is None or known.process != os.getpid() or known.root != root:
            own = Path(root.directory, *LEVELS, f"{os.getpid()}-{len(_mirrors)}")
            _mirrors[root.name] = UrlMirror(root, own, os.getpid())


def end(roots: Sequence[Root]) -> None:
    """Remove the mirrors that this process has of *roots*."""
    for known in [_mirrors.pop(each.name, None) for each in roots]:
        if known is not None and known.process == os.getpid():
            _remove(known.top)


def path_of(name: str) -> Path | None:
    """Return the path of the mirrored file called *name*, if it is one."""
    for each in _mirrors.values():
        if name.startswith(each.root.name):
            path = Path(os.path.normpath(each.top / name[len(each.root.name) :]))
            return path if path.is_relative_to(each.top) else None
    return None


def name_of(path: Path) -> str | None:
    """Return the name of the file whose mirror is at *path*, if that is one."""
    for each in _mirrors.values():
        if path.is_relative_to(each.top):
            return f"{each.root.name}{path.relative_to(each.top).as_posix()}"
    return None


def provide(path: Path, *, content: bool) -> None:
    """Have the mirror that *path* lies in, if any, hold what is there."""
    for each in _mirrors.values():
        if path.is_relative_to(each.top):
            each.provide(path.relative_to(each.top).as_posix(), content=content)


def provide_below(directory: Path, depth: int) -> None:
    """Have the mirror that *directory* lies in, if any, hold what is at most so far below it."""
    if any(directory.is_relative_to(each.top) for each in _mirrors.values()):
        provide(directory, content=False)
        for inner in (each for each in directory.iterdir() if depth and each.is_dir()):
            provide_below(inner, depth - 1)


def fetch(names: Sequence[str]) -> None:
    """Have mirrors hold the files called *names*, as many at once as their servers give."""
    for each in _mirrors.values():
        start = each.root.name
        every = [name[len(start) :] for name in names if name.startswith(start)]
        if every:
            each.fetch(every)


def contents_of(name: str) -> bytes:
    """Return what is in the file called *name*. Raises `SourceError` if that cannot be read."""
    path = path_of(name)
    if path is None:
        raise SourceError(name, "it is not below an address of this run")
    try:
        if not any(each.has(path) for each in _mirrors.values()):
            provide(path, content=True)
        if path.stat().st_size > LARGEST:
            raise SourceError(name, f"more than {LARGEST >> 20} MiB")
        return path.read_bytes()
    except OSError as error:
        raise SourceError(name, error.strerror or str(error)) from None


def find(given: str) -> tuple[list[str], bool]:
    """Return the names of the files that *given* stands for, and whether it names one of them.

    What holds them is mirrored until this process ends. Raises `SourceError` where it cannot be
    reached, and `UsageError` where nothing is known of such addresses.
    """
    from kinlint.files import url_root  # noqa: PLC0415  few runs

    archive = _ARCHIVE.fullmatch(given) if "::" not in given else None
    url = f"zip://{archive[2] or ''}::{archive[1]}" if archive else given
    system, path = url_root.system_of(url)
    root = url_root.root_of(url, path, _directory())
    mirror([root])
    _mirrors[root.name]._system = system  # noqa: SLF001  it is connected
    try:
        found = url_root.expanded(system, path)
        system.invalidate_cache()  # a search remembers directories without what lies deeper
    except FileNotFoundError:
        raise SourceError(given, "no such file or directory") from None
    except Exception as error:  # noqa: BLE001  each file system has its own
        raise SourceError(given, url_root.cause_of(error)) from None
    names = sorted(root.name + each.lstrip("/").removeprefix(root.base) for each in found)
    return names, found == [path] and url_root.MAGIC.search(path) is None


@cache
def _directory() -> str:
    """Return the directory of the mirrors of this run, which goes when this process ends."""
    import atexit  # noqa: PLC0415  few runs
    from tempfile import mkdtemp  # noqa: PLC0415

    made = mkdtemp(prefix="kinlint-")
    owner = os.getpid()

    def leave() -> None:
        if os.getpid() == owner:
            _remove(Path(made))

    atexit.register(leave)
    return made


def _remove(directory: Path) -> None:
    import shutil  # noqa: PLC0415  few runs

    shutil.rmtree(directory, ignore_errors=True)
