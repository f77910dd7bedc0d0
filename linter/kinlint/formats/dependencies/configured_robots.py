"""The robots whose parts a YAML file of ROS may name.

These are, in this order, those that a launch file names together with it, those of its package, of
the packages that this one depends on, or the only robot of the run. Robots that are not linted are
looked for in these packages. An SRDF without a robot gets those of its name that they have.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.files.bounded_read import head
from kinlint.files.environment import kind, listing
from kinlint.files.packages import MANIFEST, Packages
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real, shown
from kinlint.files.url_mirror import provide
from kinlint.formats.decoding import decode
from kinlint.formats.dependencies.launch_mentions import LaunchMentions
from kinlint.formats.dependencies.robot_descriptions import Description, describe
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.text import Pairing, SourceText

HEAD = 1 << 16
MOST = 40
"""Most robots of a package that are looked at beside those of the run."""
DEPENDED = "it is in a package that this one depends on"
FOLDERS = ("urdf", "robots", "config", "srdf", ".")
ENDINGS = (".urdf", ".urdf.xacro", ".xacro", ".srdf")
_DEPENDS = re.compile(r"<(?:build_|exec_|build_export_|run_)?depend\b[^>]*>\s*([^<\s]+)\s*</")


def pair_configurations(
    sources: Sequence[SourceText],
    settings: Settings,
    packages_of: Callable[[str], Packages],
    overlay: Mapping[Path, SourceText],
) -> list[SourceText]:
    """Return *sources*, in which each YAML file says which robots it may be about.

    So does an SRDF for which `companions` found none. Robots that are not among *sources* are added
    as companions. *packages_of* returns the packages that the file of a name can name; *overlay*
    has texts that files are taken to hold.
    """
    finder = _Finder(sources, packages_of, overlay)

    def paired(each: SourceText) -> SourceText:
        if each.companion:
            return each
        if each.format == YAML and each.pairing is None:
            return replace(each, pairing=finder.pairing(each, settings.partner(each.name)))
        if each.pairing is not None and not each.pairing.partner:
            return replace(each, pairing=finder.namesakes(each) or each.pairing)
        return each

    return [*map(paired, sources), *finder.borrowed.values()]


class _Finder:
    """The robots of a run, by their packages; `borrowed` are others that were taken."""

    def __init__(
        self,
        sources: Sequence[SourceText],
        packages_of: Callable[[str], Packages],
        overlay: Mapping[Path, SourceText],
    ) -> None:
        self.packages_of, self.overlay = packages_of, overlay
        self.borrowed: dict[Path, SourceText] = {}
        self._sources = sources
        self._every = [one for each in sources if (one := _robot(each)) is not None]
        self._given = [each for each in self._every if each.kind == URDF]
        self._homes: dict[Path, Path | None] = {}
        self._lying: dict[Path, list[Description]] = {}
        self._launch = LaunchMentions()

    def pairing(self, source: SourceText, configured: str | None) -> Pairing | None:
        """Return the robots that *source* may be about; None if there are none."""
        path = absolute(source.name)
        home = self._home(path.parent)
        if configured is not None:
            chosen = [*self._read([Path(configured)])]
            return self._pairing(chosen, home, "it is configured", stated=True)
        if home is None:
            return self._only(None)
        depended = [*self._depended(home, source.name)]
        if launched := self._launched(path, home, depended):
            return self._pairing(launched, home, "a launch file names both", stated=True)
        if found := self._in([home]):
            return self._pairing(found, home, "it is in the same package")
        if found := self._in(depended):
            return self._pairing(found, home, DEPENDED)
        return self._only(home)

    def namesakes(self, srdf: SourceText) -> Pairing | None:
        """Return the robots of the name in *srdf* that its package depends on; None without any."""
        about, home = describe(srdf), self._home(absolute(srdf.name).parent)
        if about is None or home is None:
            return None
        found = self._in([*self._depended(home, srdf.name)])
        own = sorted((each for each in found if each.robot == about.robot), key=_file)
        self.borrowed.update((each.path, each.source) for each in own if each not in self._every)
        names = [each.source.name for each in own]
        reason = f"{DEPENDED}, and has its name"
        return Pairing(names[0], reason, tuple(names[1:]), certain=len(names) == 1) if own else None

    def _only(self, home: Path | None) -> Pairing | None:
        own = [each for each in self._given if not each.source.companion]
        if len(own) != 1:
            return None
        return self._pairing(own, home, "it is the only robot of the run")

    def _pairing(
        self, found: Sequence[Description], home: Path | None, reason: str, *, stated: bool = False
    ) -> Pairing | None:
        if not found:
            return None
        groups = self._annotations(home, found)
        for each in (*found, *groups):
            if each not in self._every:
                self.borrowed[each.path] = each.source
        names = sorted(each.source.name for each in found)
        srdf = tuple(sorted(each.source.name for each in groups))
        others, certain = tuple(names[1:]), len(names) == 1
        return Pairing(names[0], reason, others, certain=certain, annotations=srdf, stated=stated)

    def _annotations(
        self, home: Path | None, robots: Sequence[Description]
    ) -> Sequence[Description]:
        """Return the SRDF files of the package at *home*, or else those about *robots*."""
        every = [each for each in self._every if each.kind == SRDF]
        if home is not None:
            own = [each for each in every if self._home(each.path.parent) == home]
            if own or (own := self._of(home, SRDF)):
                return own
        names = {each.robot for each in robots}
        return [each for each in every if each.robot in names]

    def _launched(self, path: Path, home: Path, depended: Sequence[Path]) -> list[Description]:
        """Return the robots that a launch file names together with the file at *path*."""
        launches = self._launch.naming(path.name, dict.fromkeys((home, *depended, *self._known)))
        if not launches:
            return []
        packages = self.packages_of(str(path))
        names = sorted({name for each in launches for name in each.packages})
        found = (packages.find(each, home) for each in names)
        homes = dict.fromkeys((home, *depended, *(each for each in found if each is not None)))
        files = {name for each in launches for name in each.files}
        return [each for each in self._in([*homes], lying=True) if each.path.name in files]

    @cached_property
    def _known(self) -> Sequence[Path]:
        """The packages of the files that are linted."""
        parents = dict.fromkeys(absolute(each.name).parent for each in self._sources)
        homes = (self._home(each) for each in parents)
        return [*dict.fromkeys(each for each in homes if each is not None)]

    def _home(self, directory: Path) -> Path | None:
        """Return the directory of the package that *directory* is in."""
        if directory not in self._homes:
            at_top = directory == directory.parent
            own = kind(directory / MANIFEST) == "file"
            above = None if at_top else self._home(directory.parent)
            self._homes[directory] = directory if own else above
        return self._homes[directory]

    def _depended(self, home: Path, name: str) -> Iterator[Path]:
        packages = self.packages_of(name)
        for each in _DEPENDS.findall(head(home / MANIFEST, HEAD) or ""):
            if found := packages.find(each, home):
                yield found

    def _in(self, homes: Sequence[Path], *, lying: bool = False) -> list[Description]:
        """Return the robots of the run in the packages at *homes*, or else those that lie there.

        Both if *lying*.
        """
        found = [each for each in self._given if self._home(each.path.parent) in homes]
        if lying or not found:
            paths = {each.path for each in found}
            more = (one for each in homes for one in self._of(each, URDF))
            found += [each for each in more if each.path not in paths]
        return found

    def _of(self, home: Path, form: Format) -> list[Description]:
        """Return the robots of the format *form* that lie in the package at *home*."""
        if home not in self._lying:
            paths = [
                home / folder / name
                for folder in FOLDERS
                for name, inner in listing(home / folder).items()
                if not inner and name.endswith(ENDINGS)
            ]
            self._lying[home] = [*self._read(paths[:MOST])]
        return [each for each in self._lying[home] if each.kind == form]

    def _read(self, paths: Sequence[Path]) -> Iterator[Description]:
        given = {each.path: each for each in self._every}
        for path in paths:
            if path in given:
                yield given[path]
                continue
            try:
                provide(path, content=True)
                text = self.overlay.get(real(path)) or decode(shown(path), path.read_bytes())
            except (OSError, SourceError):
                continue
            if found := _robot(replace(text, companion=True)):
                yield found


def _file(robot: Description) -> str:
    return robot.source.name


def _robot(source: SourceText) -> Description | None:
    """Return the description of the robot in *source*; None for mere definitions of macros."""
    found = describe(source)
    if found is None or found.unexpanded:
        return None
    has_parts = found.names or found.kind == SRDF or found.mentions.calls_macros
    return found if found.robot and has_parts else None
