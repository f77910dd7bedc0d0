"""The files that a xacro file names: which of them are read, and what they are called."""

from __future__ import annotations

import os
from pathlib import Path

from kinlint.files.bounded_read import SIZE, Unreadable, contents
from kinlint.files.pathname import shown
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.dependencies.included_text import included_text, keep
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText

TABLE_SIZE = 1 << 17
"""Maximum size of a YAML file, in bytes."""
TABLES = (".yaml", ".yml", ".json")


@dataclass
class Pieces:
    """Texts that an expansion reads, each once, and their offsets in the whole."""

    main: SourceText
    """The file itself."""
    path: Path
    """Its path."""
    options: ReadOptions
    """Options of reading; their memory keeps texts for the next file."""
    _begins: dict[int, int] = field(default_factory=dict)
    _listed: list[tuple[int, SourceText]] = field(default_factory=list)
    _end: int = 0

    def __post_init__(self) -> None:
        self._add(self.main)
        keep(self.path, self.main, self.options)

    @property
    def reach(self) -> ProjectReach:
        """The files that may be read."""
        return ProjectReach(self.path, self.options.packages_of(self.main.name))

    @property
    def listed(self) -> tuple[tuple[int, SourceText], ...]:
        """The offset of each text, and the text."""
        return tuple(self._listed)

    def begin(self, source: SourceText) -> int:
        """Return the offset of *source*."""
        return self._begins[id(source)]

    def text(self, path: Path) -> SourceText:
        """Return the XML text of the file at *path*.

        Raises Unreadable, or what decoding it does.
        """
        if path == self.path:
            return self.main
        source = included_text(path, self.reach, self._name(path), self.options, SIZE)
        if not source.text.lstrip().startswith("<"):
            raise Unreadable(f"'{source.name}' is not XML")
        if id(source) not in self._begins:
            self._add(source)
        return source

    def append(self, source: SourceText) -> int:
        """Append *source*, which others read, and return its offset."""
        if id(source) not in self._begins:
            self._add(source)
        return self._begins[id(source)]

    def _add(self, source: SourceText) -> None:
        self._begins[id(source)] = self._end
        self._listed.append((self._end, source))
        self._end += len(source.text) + 1

    def _name(self, path: Path) -> str:
        """Return the name of the file at *path*: relative or absolute as that of the main file."""
        given = os.path.dirname(self.main.name)  # noqa: PTH120  names are no paths
        if Path(self.main.name).is_absolute():
            return shown(path)
        return shown(path, os.path.normpath(f"{given or '.'}/{_from(self.path.parent, path)}"))


def _from(directory: Path, path: Path) -> str:
    """Return the path from *directory* to *path*."""
    try:
        return os.path.relpath(path, directory)
    except ValueError:  # another drive
        return str(path)


def table(path: Path, reach: ProjectReach) -> bytes:
    """Return the bytes of the YAML file at *path*.

    Raises `Unreadable` as `contents` does, and unless it is called a YAML file and within *reach*.
    """
    reach.require(path)
    if path.suffix.lower() not in TABLES:
        raise Unreadable(f"'{shown(path)}' is not called a YAML file")
    return contents(path, reach.near, TABLE_SIZE)
