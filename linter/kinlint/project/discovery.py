"""Finds the files to lint: what was named, and the models in directories and globs.

In directories these are `.jsonld` files, those `.json` files with keywords of JSON-LD, and robots
in the XML formats, by the ends of their names or the root element of `.xml` files; of COLLADA and
USD, those that describe joints or bodies, and of layers those that no other leads to. Turtle and
N-Quads are as often shapes or vocabularies as models, so they are read only when they are named,
when a glob does not leave them out, or when they describe what the models of a directory only name.
All else is passed over.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint.errors import SourceError
from kinlint.files.bounded_read import head
from kinlint.files.environment import listing
from kinlint.files.globbing import ANY_DEPTH, matches
from kinlint.files.packages import CATKIN, IGNORED, working_copies
from kinlint.files.pathglob import MAGIC, Glob, absolute
from kinlint.files.pathname import missing, printable, real, shown
from kinlint.files.url_mirror import find, is_url
from kinlint.formats.records import BY_NAME, GLOBBED, JSON, SEARCHED, SHARED, TOLD, by_suffix
from kinlint.light_dataclasses import dataclass, field

if TYPE_CHECKING:
    from kinlint.file_format import Format
    from kinlint.files.gitignore import GitIgnore

SKIPPED = (
    *(".*", "node_modules", "__pycache__", "site-packages", "venv"),
    *("build", "dist", "install", "log"),
)
"""Names of directories that hold no models; the default of `exclude`."""
MARKERS = frozenset({"pyvenv.cfg", CATKIN, *IGNORED})
"""Files that mark a directory as no part of a project: a virtual environment of Python, a space
that catkin builds in, or what build tools of ROS ignore."""
HEAD = 1 << 16
YAML, LAUNCH = BY_NAME["yaml"], BY_NAME["launch"]
TURTLE = BY_NAME["turtle"].suffixes[0]
KEYWORDS = (b'"@context"', b'"@graph"', b'"@id"', b'"@type"')
"""Keys by which JSON is JSON-LD."""
WIDE = (b"\xff\xfe", b"\xfe\xff")
"""The beginnings of files in UTF-16, as editors on Windows write them."""
LONGEST = max(map(len, KEYWORDS))


@dataclass(frozen=True, slots=True)
class Input:
    """A file to read."""

    name: str
    """The name in messages."""
    path: Path | None
    """The path; None for standard input."""
    named: bool = True
    """True if the user named this very file."""
    remote: bool = False
    """True if the name is a URL; the path is None."""


@dataclass
class Found:
    """The result of a search."""

    inputs: list[Input] = field(default_factory=list)
    """The files found."""
    errors: list[SourceError] = field(default_factory=list)
    """Directories and files that cannot be accessed."""
    barren: list[str] = field(default_factory=list)
    """Arguments that were searched in vain."""
    turtle: list[Path] = field(default_factory=list)
    """Turtle files that a search of directories passed over."""
    asides: frozenset[str] = frozenset()
    """Names of files that are read for what they state about others; their findings are not
    reported.
    """
    directories: list[Path] = field(default_factory=list)
    """Directories that were named, and searched."""


@dataclass(frozen=True)
class Search:
    """A search for files."""

    excluding: Callable[[Path], Sequence[Glob]]
    """A function that returns the patterns of paths to pass over in a directory."""
    force: bool = False
    """True if these patterns hold for named files, too."""
    stdin: str = "<stdin>"
    """The name of `-`."""
    gitignored: Callable[[Path], bool] = field(default=lambda _: True)
    """Function that tells whether what git ignores in a directory is passed over."""

    def find(self, paths: Sequence[str]) -> Found:
        """The inputs that *paths* stand for, each file once, in their order.

        A search finds a file rather than links to it.
        """
        found, seen = Found(), dict[str, int]()
        # What comes by standard input is a newer state of the file of that name, if there is one.
        for given in sorted(paths, key=lambda path: path != "-"):
            before = len(found.errors)
            inputs = list(self._expand(given, found))
            if not inputs and len(found.errors) == before and given != "-":
                found.barren.append(given)
            for one in inputs:
                identity = os.path.realpath(one.path or one.name)
                at = seen.setdefault(identity, len(found.inputs))
                if at == len(found.inputs):
                    found.inputs.append(one)
                elif not found.inputs[at].named and str(one.path) == identity:
                    found.inputs[at] = one
        return found

    def _expand(self, given: str, found: Found) -> Iterator[Input]:
        if given == "-":
            yield Input(self.stdin, None)
            return
        try:
            yield from self._path(given, found)
        except (OSError, ValueError) as error:  # such as a name longer than any may be
            cause = getattr(error, "strerror", None) or str(error)
            found.errors.append(SourceError(printable(given), cause))

    def _path(self, given: str, found: Found) -> Iterator[Input]:
        if is_url(given):
            yield from self._url(given, found)
            return
        path = absolute(os.path.expanduser(given))  # noqa: PTH111  never fails
        if path.is_dir():
            yield from self._directory(path, found)
        elif os.path.lexists(path):
            if not self._forced_out(path):
                yield Input(shown(path, given), path)
        elif MAGIC.search(given):
            yield from self._glob(given, found)
        else:
            found.errors.append(SourceError(printable(given), missing(path)))

    def _url(self, given: str, found: Found) -> Iterator[Input]:
        """Yield the files that a URL stands for; which of them are models, their readers see."""
        try:
            names, named = find(given)
        except SourceError as error:
            found.errors.append(error)
            return
        if not names:
            found.errors.append(SourceError(given, "no file matches"))
        ends = GLOBBED if MAGIC.search(given) else SEARCHED
        patterns = self.excluding(Path.cwd())
        for name in names:
            path = Path(os.path.abspath(name))  # noqa: PTH100  where patterns take it to be
            excluded = any(each.covers(path) for each in patterns)
            if named or (name.lower().endswith(ends) and not excluded):
                yield Input(name, None, named, remote=True)

    def _glob(self, pattern: str, found: Found) -> Iterator[Input]:
        from kinlint.files.gitignore import GitIgnore  # noqa: PLC0415  only of searches

        ignore = GitIgnore(Path.cwd(), Path.cwd())

        def skip(path: Path) -> bool:
            marked = not MARKERS.isdisjoint(listing(path))
            return marked or self._passed_over(path, ignore, directory=path.is_dir())

        paths = matches(pattern, skip, _teller(pattern, found.errors))
        if not paths:
            found.errors.append(SourceError(printable(pattern), "no file matches"))
        for path in paths:
            if path.is_dir() and not path.is_symlink() and ANY_DEPTH not in pattern:
                yield from self._directory(path, found)
            elif (
                path.is_file() and path.name.lower().endswith(GLOBBED) and _stays(path, Path.cwd())
            ):
                yield from self._candidate(path, found.errors)

    def _directory(self, top: Path, found: Found) -> Iterator[Input]:
        """Models below *top*, by name.

        Links to directories are not followed, nor those to files out of *top* and its repository.
        """
        if self._forced_out(top):
            return
        found.directories.append(top)
        from kinlint.files.gitignore import GitIgnore  # noqa: PLC0415  only of searches

        ignore = GitIgnore(top, Path.cwd() if top.is_relative_to(Path.cwd()) else top)
        scenes: dict[Format, list[Path]] = {}
        for here, folders, files in os.walk(top, onerror=_teller(str(top), found.errors)):
            base = Path(here)
            if base != top and not MARKERS.isdisjoint(files):
                folders.clear()
                continue
            folders[:] = sorted(
                name
                for name in folders
                if not self._passed_over(base / name, ignore, directory=True)
            )
            for name in sorted(files):
                path = base / name
                if not name.lower().endswith((TURTLE, *SEARCHED, *TOLD)) or self._passed_over(
                    path, ignore
                ):
                    continue
                if not _stays(path, top):
                    continue
                if path.suffix.lower() == TURTLE:
                    found.turtle.append(path)
                elif (form := TOLD.get(path.suffix.lower())) is not None:
                    scenes.setdefault(form, []).append(path)
                else:
                    yield from self._candidate(path, found.errors)
        yield from _robots(scenes)

    def _passed_over(self, path: Path, ignore: GitIgnore, *, directory: bool = False) -> bool:
        if self._excluded(path):
            return True
        return self.gitignored(path.parent) and ignore.ignores(path, directory=directory)

    def _excluded(self, path: Path) -> bool:
        return any(pattern.matches(path) for pattern in self.excluding(path.parent))

    def _forced_out(self, path: Path) -> bool:
        return self.force and any(pattern.covers(path) for pattern in self.excluding(path.parent))

    def _candidate(self, path: Path, errors: list[SourceError]) -> Iterator[Input]:
        name = shown(path)
        try:
            if may_be_model(path):
                yield Input(name, path, named=False)
        except OSError as error:
            errors.append(SourceError(name, error.strerror or str(error)))


def _robots(scenes: Mapping[Format, Iterable[Path]]) -> Iterator[Input]:
    """Yield those of the *scenes* that their formats tell to be robots."""
    for form, paths in scenes.items():
        for path in import_module(str(form.robot_files)).robots(paths):
            yield Input(shown(path), path, named=False)


def _stays(path: Path, top: Path) -> bool:
    """Tell whether *path* is no link, or one that stays in its directory, *top* or a repository."""
    if not path.is_symlink():
        return True
    around = (path.parent, top, *working_copies(path.parent))
    return any(real(path).is_relative_to(real(each)) for each in around)


def may_be_model(path: Path) -> bool:
    """Tell whether the file at *path*, of a name that others use, too, may be about robots."""
    if path.suffix.lower() == JSON:
        return may_be_jsonld(path)
    form = by_suffix(path.name)
    if form == LAUNCH:
        return path.is_file() and "xacro" in (head(path, HEAD) or "")
    if path.suffix.lower() in SHARED:
        from kinlint.formats.xml.xml_recognition import robot_root  # noqa: PLC0415  few files

        return path.is_file() and robot_root(head(path, HEAD) or "", path.suffix.lower())
    if form == YAML:
        from kinlint.formats.yaml.ros_keys import may_name_parts  # noqa: PLC0415  few files

        return may_name_parts(path)
    return True


def _teller(given: str, errors: list[SourceError]) -> Callable[[OSError], None]:
    """Return a handler that adds unreadable directories to *errors*."""

    def tell(error: OSError) -> None:
        where = shown(absolute(error.filename or given))
        errors.append(SourceError(where, error.strerror or str(error)))

    return tell


def may_be_jsonld(path: Path) -> bool:
    """Tell whether the file at *path* may be JSON-LD, without decoding or parsing it."""
    if not path.is_file():
        return False
    with path.open("rb") as stream:
        head = stream.read(HEAD)
        if head.startswith(WIDE) or b"\0" in head[:2]:
            # Its reader says that it is not UTF-8.
            return any(keyword in head.replace(b"\0", b"") for keyword in KEYWORDS)
        if head.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] not in (b"{", b"["):
            return False
        while not any(keyword in head for keyword in KEYWORDS):
            more = stream.read(HEAD)
            if not more:
                return False
            head = head[-LONGEST:] + more
    return True
