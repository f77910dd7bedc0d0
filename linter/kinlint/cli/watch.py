"""`kinlint --watch`: lints, waits until something changes that may matter, and lints again.

Reports of what did not change are recalled, so only what changed is linted again.
"""

from __future__ import annotations

import gc
import os
import sys
from argparse import Namespace
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint.configuration.config_file import NAMES
from kinlint.configuration.keys import OUTPUT_FORMATS
from kinlint.configuration.settings import Settings
from kinlint.errors import KinlintError, UsageError
from kinlint.files.file_exists import KINDS
from kinlint.files.packages import REPOSITORY
from kinlint.files.pathglob import MAGIC, absolute
from kinlint.files.pathname import shown
from kinlint.formats.records import GLOBBED
from kinlint.light_dataclasses import dataclass, field
from kinlint.project.layers import cache_directory
from kinlint.reporters.reporter_registry import FORMATS

if TYPE_CHECKING:
    from watchfiles import Change

CLEAR = "\x1b[2J\x1b[3J\x1b[H"
"""Escape sequence that clears the terminal and its scrollback."""
SUFFIXES = frozenset({"", ".config", ".toml", ".xml", ".py"}.union(GLOBBED, *KINDS))
"""Suffixes of files that may affect a run.

Models, what they name, what governs them; "" for directories.
"""
PASSED_OVER = frozenset({"node_modules", "__pycache__", "site-packages"})
GLANCE, CALM, MOST = 200, 50, 400
"""Milliseconds: between two looks at what lies elsewhere; without a change before a series of them
is over; and how long such a series may take."""

Check = Callable[[Namespace, Callable[[Settings], None]], int]


def watch(options: Namespace, check: Check) -> int:
    """Do as `check` says with *options* again and again; 0 when the user has enough of it."""
    _refuse(options)
    watcher = Watcher(options, check)
    try:
        while True:
            watcher.stay()
    except KeyboardInterrupt:
        return 0


def _refuse(options: Namespace) -> None:
    """Raise `UsageError` if *options* make sense only once."""
    if "-" in options.paths or options.stdin_filename:
        raise UsageError("--watch and standard input exclude each other: it comes but once")
    files = {f"--{name}-output": f"{name.replace('-', '_')}_output" for name in OUTPUT_FORMATS}
    for option, name in {"--output-file": "output_file", **files}.items():
        if getattr(options, name):
            raise UsageError(f"--watch and {option} exclude each other: it shows reports only here")
    form = options.output_format
    if form is not None and FORMATS[form].machine:
        people = ", ".join(name for name, one in FORMATS.items() if not one.machine)
        raise UsageError(f"--watch is for people: --output-format {people}, not {form}")


class Unwatchable(Exception):
    """The system does not tell of changes, for the reason given."""


@dataclass
class Watcher:
    """Watches what *options* name, and what governs it."""

    options: Namespace
    """The options of the command line, which name the files."""
    check: Check
    """Lints once and reports."""
    _settings: Settings = field(default_factory=Settings)
    _polling: bool | None = None
    _before: list[object] = field(default_factory=list)

    def stay(self) -> None:
        """Lint at every change, until other directories have to be watched, or so in another way.

        Raises `UsageError` if the system lets nobody watch.
        """
        tops = list(_tops(self.options.paths))
        try:
            with closing(self._changes(tops)) as changes:
                next(changes)  # From here on no change is missed.
                while list(_tops(self.options.paths)) == tops:
                    self._lint()
                    while not next(changes) and self._elsewhere() == self._before:
                        pass
        except Unwatchable as error:
            # There is a bound to how much may be watched; looking again and again has none.
            if self._polling:
                raise UsageError(f"cannot watch: {error}") from None
            self._polling = True

    def _changes(self, tops: Sequence[Path]) -> Generator[bool, None, None]:
        """Yield at each poll whether anything changed below *tops* since the last one."""
        import watchfiles  # noqa: PLC0415  few runs stay

        changes = watchfiles.watch(
            *tops,
            watch_filter=Filter(tops, self._given(), self._cache()),
            debounce=MOST,
            step=CALM,
            rust_timeout=GLANCE,
            yield_on_timeout=True,
            force_polling=self._polling,
            ignore_permission_denied=True,
        )
        while True:
            try:
                found = next(changes)
            except (OSError, RuntimeError) as error:
                raise Unwatchable(str(error)) from None
            yield bool(found)

    def _lint(self) -> None:
        """Report once, whatever may be wrong."""
        self._before = self._elsewhere()
        if sys.stdout.isatty():
            sys.stdout.write(CLEAR)
        try:
            self.check(self.options, self._govern)
        except KinlintError as error:
            sys.stderr.write(f"kinlint: error: {error}\n")
        sys.stdout.flush()
        if not self.options.silent:
            sys.stderr.write("Watching for changes; Ctrl-C ends it.\n")
        sys.stderr.flush()
        gc.collect()

    def _govern(self, settings: Settings) -> None:
        """Hear by which settings a run goes, before it reads what they name."""
        self._settings = settings
        self._before = self._elsewhere()

    def _given(self) -> frozenset[str]:
        return frozenset(str(absolute(path)) for path in self.options.paths)

    def _cache(self) -> str:
        return str(absolute(cache_directory(os.environ, self.options.cache_dir)))

    def _elsewhere(self) -> list[object]:
        """The states of what governs the files and may lie outside of what is watched."""
        above = {each for top in _tops(self.options.paths) for each in top.parents}
        said = self._settings
        named = (*said.rules, *said.shapes, *said.context_directories)
        files = [
            *(each / name for each in sorted(above) for name in NAMES),
            *map(absolute, self.options.config or ()),
            *said.extra_contexts.values(),
            *(path for each in named for path in (each, *sorted(each.glob("**/*")))),
        ]
        return [_state(path) for path in files]


@dataclass(frozen=True)
class Filter:
    """Filter of changes of files."""

    tops: Sequence[Path]
    """Directories below which changes count."""
    given: frozenset[str]
    """Names of the files that were given."""
    cache: str
    """The directory of the cache, changes of which are ignored."""

    def __call__(self, _change: Change, path: str) -> bool:
        """Tell whether a change at *path* matters."""
        if path in self.given:
            return True
        place = Path(path)
        if place.suffix.lower() not in SUFFIXES or place.is_relative_to(self.cache):
            return False
        top = next((each for each in self.tops if place.is_relative_to(each)), place.parent)
        *folders, name = place.relative_to(top).parts or ("",)
        if name.startswith(".") and name not in NAMES:
            return False
        return not any(each.startswith(".") or each in PASSED_OVER for each in folders)


def _tops(paths: Sequence[str]) -> Iterator[Path]:
    """The directories to watch, with all below: those of *paths*, and of the repository of each."""
    found: dict[Path, None] = {}
    for given in paths or ["."]:
        folder = _folder(given)
        above = (folder, *folder.parents)
        repository = next((each for each in above if (each / REPOSITORY).exists()), None)
        found |= dict.fromkeys(_real([folder, *([] if repository is None else [repository])]))
    yield from (each for each in found if not any(one in each.parents for one in found))


def _folder(given: str) -> Path:
    """The nearest directory that is there, of what *given* names or is a pattern of."""
    path = absolute(os.path.expanduser(given))  # noqa: PTH111  never fails
    while not path.is_dir() or (MAGIC.search(path.name) and not path.exists()):
        path = path.parent
    return path


def _real(paths: Iterable[Path]) -> Iterator[Path]:
    return (Path(os.path.realpath(path)) for path in paths)


def _state(path: Path) -> object:
    """Return a value that differs whenever the file at *path* was written or removed."""
    try:
        about = path.stat()
    except OSError:
        return None
    return shown(path), about.st_mtime_ns, about.st_size, about.st_ino
