"""The robots whose joints a YAML file of ros2_control or MoveIt may name.

These are the robots of its package and of the packages that this one depends on: those of the run,
or else those that lie there. A launch file that names the YAML file and some of them leaves these.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files.bounded_read import head
from kinlint.files.environment import kind, listing
from kinlint.files.packages import MANIFEST, Packages
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real, shown
from kinlint.formats.decoding import decode
from kinlint.formats.dependencies.robot_descriptions import Description, describe
from kinlint.formats.urdf.format import URDF
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.text import Pairing, SourceText

HEAD = 1 << 16
MOST = 40
"""Most robots that are looked at beside those of the run."""
FOLDERS = ("urdf", "robots", "config", ".")
ENDINGS = (".urdf", ".urdf.xacro", ".xacro")
LAUNCH = ("launch",)
_DEPENDS = re.compile(r"<(?:build_|exec_|build_export_|run_)?depend\b[^>]*>\s*([^<\s]+)\s*</")


def pair_configurations(
    sources: Sequence[SourceText],
    settings: Settings,
    packages_of: Callable[[str], Packages],
    overlay: Mapping[Path, SourceText],
) -> list[SourceText]:
    """Return *sources*, in which each YAML file says which robots it may be about.

    Robots that are not among *sources* are added as companions. *packages_of* returns the packages
    that the file of a name can name; *overlay* has texts that files are taken to hold.
    """
    finder = _Finder(sources, packages_of, overlay)
    paired = [
        replace(each, pairing=finder.pairing(each, settings.partner(each.name)))
        if each.format == YAML and each.pairing is None and not each.companion
        else each
        for each in sources
    ]
    return [*paired, *finder.borrowed.values()]


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
        self._given = [one for each in sources if (one := _robot(each)) is not None]
        self._homes: dict[Path, Path | None] = {}
        self._lying: dict[Path, list[Description]] = {}

    def pairing(self, source: SourceText, configured: str | None) -> Pairing | None:
        """Return the robots that *source* may be about; None if there are none."""
        path = absolute(source.name)
        if configured is not None:
            return self._pairing([*self._read([Path(configured)])], "it is configured")
        home = self._home(path.parent)
        if home is None:
            return None
        found = [each for each in self._given if self._home(each.path.parent) == home]
        reason = "it is in the same package"
        if not found and not (found := self._of(home)):
            reason = "it is in a package that this one depends on"
            homes = [*self._depended(home, source.name)]
            found = [each for each in self._given if self._home(each.path.parent) in homes]
            found = found or [one for each in homes for one in self._of(each)]
        launched = [*_launched(home, path.name, found)]
        if launched:
            found, reason = launched, "a launch file names both"
        return self._pairing(found, reason)

    def _pairing(self, found: Sequence[Description], reason: str) -> Pairing | None:
        if not found:
            return None
        for each in found:
            if each not in self._given:
                self.borrowed[each.path] = each.source
        names = sorted(each.source.name for each in found)
        return Pairing(names[0], reason, tuple(names[1:]), certain=len(names) == 1)

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

    def _of(self, home: Path) -> list[Description]:
        """Return the robots that lie in the package at *home*."""
        if home not in self._lying:
            paths = [
                home / folder / name
                for folder in FOLDERS
                for name, inner in listing(home / folder).items()
                if not inner and name.endswith(ENDINGS)
            ]
            self._lying[home] = [*self._read(paths[:MOST])]
        return self._lying[home]

    def _read(self, paths: Sequence[Path]) -> Iterator[Description]:
        given = {each.path: each for each in self._given}
        for path in paths:
            if path in given:
                yield given[path]
                continue
            try:
                text = self.overlay.get(real(path)) or decode(shown(path), path.read_bytes())
            except (OSError, SourceError):
                continue
            if found := _robot(replace(text, companion=True)):
                yield found


def _robot(source: SourceText) -> Description | None:
    """Return the description of the robot in *source*; None for mere definitions of macros."""
    found = describe(source)
    if found is None or found.kind != URDF or found.unexpanded:
        return None
    return found if found.robot and found.names else None


def _launched(home: Path, name: str, robots: Sequence[Description]) -> Iterator[Description]:
    """Yield those of *robots* that a launch file of the package names together with *name*."""
    texts = [
        text
        for folder in LAUNCH
        for each in listing(home / folder)
        if name in (text := head(home / folder / each, HEAD) or "")
    ]
    for each in robots if len(robots) > 1 else ():
        if any(each.path.name in text for text in texts):
            yield each
