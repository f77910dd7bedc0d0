"""The files that a xacro file names: which of them are read, and what they are called."""

from __future__ import annotations

import os
import stat
from collections.abc import Hashable, MutableMapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.formats.decoding import decode
from kinlint.text import SourceText

SIZE = 1 << 23
TABLE_SIZE = 1 << 20
SYSTEM = [(name,) for name in ("dev", "etc", "proc", "run", "sys")]
TABLES = (".yaml", ".yml", ".json")


class Unreadable(Exception):
    """A file that is named cannot be used; the text says why. *missing*: there is none."""

    def __init__(self, cause: str, *, missing: bool = False) -> None:
        super().__init__(cause)
        self.missing = missing


@dataclass
class Pieces:
    """The texts that an expansion reads, each once, and where each begins among all.

    `main` is the file itself at `path`. `memory` keeps texts for the next file of the run.
    """

    main: SourceText
    path: Path
    memory: MutableMapping[Hashable, Any]
    _begins: dict[int, int] = field(default_factory=dict)
    _listed: list[tuple[int, SourceText]] = field(default_factory=list)
    _end: int = 0

    def __post_init__(self) -> None:
        self._add(self.main)
        self.memory.setdefault(("xacro", self.path), self.main)

    @property
    def listed(self) -> tuple[tuple[int, SourceText], ...]:
        """The offset of each text, and the text."""
        return tuple(self._listed)

    def begin(self, source: SourceText) -> int:
        """The offset of *source*."""
        return self._begins[id(source)]

    def text(self, path: Path) -> SourceText:
        """The XML text of the file at *path*; raises Unreadable, or what decoding it does."""
        if path == self.path:
            return self.main
        key = "xacro", path
        source: SourceText | None = self.memory.get(key)
        if source is None:
            source = self.memory[key] = decode(self._name(path), contents(path, self.path))
        if not source.text.lstrip().startswith("<"):
            raise Unreadable(f"'{source.name}' is no XML")
        if id(source) not in self._begins:
            self._add(source)
        return source

    def append(self, source: SourceText) -> int:
        """The offset of *source*, which others read and is put at the end."""
        if id(source) not in self._begins:
            self._add(source)
        return self._begins[id(source)]

    def _add(self, source: SourceText) -> None:
        self._begins[id(source)] = self._end
        self._listed.append((self._end, source))
        self._end += len(source.text) + 1

    def _name(self, path: Path) -> str:
        """What the file at *path* is called: as if named in the way of the main file."""
        given = os.path.dirname(self.main.name)  # noqa: PTH120  names are no paths
        if Path(self.main.name).is_absolute():
            return shown(path)
        return shown(path, os.path.normpath(f"{given or '.'}/{_from(self.path.parent, path)}"))


def _from(directory: Path, path: Path) -> str:
    """How *path* is reached from *directory*."""
    try:
        return os.path.relpath(path, directory)
    except ValueError:  # another drive
        return str(path)


def contents(path: Path, near: Path, limit: int = SIZE) -> bytes:
    """The bytes of the regular file at *path*, at most *limit*, which a file at *near* names.

    Raises Unreadable, also for what lies hidden or belongs to the system.
    """
    if _is_private(path, near):
        raise Unreadable(f"'{shown(path)}' is none of the files that a robot is made of")
    try:
        about = path.stat()
        if not stat.S_ISREG(about.st_mode):
            raise Unreadable(f"'{shown(path)}' is not a file")
        if about.st_size > limit:
            raise Unreadable(f"'{shown(path)}' has more than {limit >> 20} MiB")
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        raise Unreadable(f"there is no file '{shown(path)}'", missing=True) from None
    except (OSError, ValueError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        raise Unreadable(f"'{shown(path)}' cannot be read: {cause}") from None


def table(path: Path, near: Path) -> bytes:
    """The bytes of the YAML file at *path*, which has to be called one, as in `contents`."""
    if path.suffix.lower() not in TABLES:
        raise Unreadable(f"'{shown(path)}' is not called a YAML file")
    return contents(path, near, TABLE_SIZE)


def _is_private(path: Path, near: Path) -> bool:
    """Whether *path* leads to where *near* does not lie and no robots are kept."""
    try:
        real, own = Path(os.path.realpath(path)), Path(os.path.realpath(near))
    except (OSError, ValueError):
        return False
    apart = next((i for i, (a, b) in enumerate(zip(real.parts, own.parts)) if a != b), 0)  # noqa: B905  of any length
    hidden = any(part.startswith(".") for part in real.parts[apart:])
    return hidden or (real.parts[1:2] in SYSTEM and own.parts[1:2] != real.parts[1:2])


def place(name: str) -> Path:
    """Where the file called *name* is; standard input is taken to lie in the directory of work."""
    return absolute(name)
