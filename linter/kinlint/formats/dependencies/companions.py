"""Companions: the URDF by which an SRDF is judged, whose links and joints it names.

That is decided from the texts, without parsing them, and by the same order wherever the SRDF was
found: a URDF that was named together with it, one of the same stem in its package, the only one of
its package, and then the name of the robot. Where that leaves several, none is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from kinlint.configuration.settings import Settings
from kinlint.errors import ConfigError, SourceError
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import missing, real, shown
from kinlint.files.url_mirror import provide, provide_below
from kinlint.formats.decoding import decode
from kinlint.formats.dependencies.robot_collection import Robots, shared_directories
from kinlint.formats.dependencies.robot_descriptions import Description, describe, may_be_srdf
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.text import Pairing, SourceText

NOTHING: Mapping[Path, SourceText] = MappingProxyType({})
FOLDERS = (".", "..", "urdf", "../urdf", "robots", "../robots")
"""Directories of the package of an SRDF that may hold its URDF, relative to that of the SRDF."""
PATTERNS = ("*.urdf", "*.urdf.xacro")
NEIGHBOURS = ("*/urdf", "*/robots", "*")
"""Directories of other packages, relative to the one that holds the package of an SRDF."""
MANIFEST = "package.xml"
MOST_FILES = 200
"""Number of files in other packages that are looked into."""
TOGETHER = "it was named together with it"
NONE = Pairing("", "", certain=False)
"""The pairing of an SRDF whose robot was not found."""


def pair(
    sources: Sequence[SourceText], settings: Settings, overlay: Mapping[Path, SourceText] = NOTHING
) -> list[SourceText]:
    """Return *sources*, in which each SRDF says by which URDF it is judged, with those that lack.

    *overlay* has texts that files are taken to hold, by their real paths. Raises `ConfigError`
    where a configuration names a URDF that cannot be read.
    """
    paired = list(sources)
    if any(map(may_be_srdf, sources)):
        shelf = _Shelf(sources, overlay)
        paired = [shelf.paired(each, settings.partner) for each in sources]
        paired += shelf.borrowed.values()
    if any(each.format == YAML or each.pairing == NONE for each in paired):
        from kinlint.formats.dependencies.configured_robots import pair_configurations  # noqa: PLC0415
        from kinlint.formats.options import ReadOptions  # noqa: PLC0415  few runs have any

        packages_of = ReadOptions.from_settings(settings).packages_of
        return pair_configurations(paired, settings, packages_of, overlay)
    return paired


def paired_among(
    sources: Sequence[SourceText], configured: Callable[[str], str | None] = lambda _: None
) -> dict[str, Pairing]:
    """Return by which URDF among *sources* each SRDF there is judged, by the name of the SRDF."""
    if not any(map(may_be_srdf, sources)):
        return {}
    shelf = _Shelf(sources, None)
    found = {
        each.name: shelf.paired(each, configured).pairing for each in sources if may_be_srdf(each)
    }
    return {name: pairing for name, pairing in found.items() if pairing is not None}


class _Package(NamedTuple):
    """The robots of a package."""

    robots: Robots
    """The robots that are known."""
    unknown: Robots
    """The robots that lie there and depend on arguments."""


class _Shelf:
    """The robots of a run, and those in the directories near an SRDF.

    `overlay` is None if only those of the run are there; `borrowed` are others that were taken.
    """

    def __init__(
        self, sources: Iterable[SourceText], overlay: Mapping[Path, SourceText] | None
    ) -> None:
        every = [one for each in sources if (one := describe(each)) and not one.unexpanded]
        self.given = [each for each in every if each.kind == URDF]
        self.overlay = overlay
        self.borrowed: dict[Path, SourceText] = {}
        self._read: dict[Path, Description | None] = {each.path: each for each in self.given}
        self._given = Robots(self.given)
        self._named = Robots([each for each in self.given if each.source.named])
        self._packages: dict[tuple[Path, bool], _Package] = {}

    def paired(self, source: SourceText, configured: Callable[[str], str | None]) -> SourceText:
        """Return *source* with its pairing, if it is an SRDF."""
        srdf = describe(source)
        if srdf is None or srdf.kind != SRDF or source.pairing is not None or source.companion:
            return source
        if (path := configured(source.name)) is not None:
            return replace(source, pairing=self._configured(Path(path)))
        if srdf.unexpanded:
            return source
        chosen, others, reason = self._choice(srdf)
        if not chosen:
            return source if self.overlay is None else replace(source, pairing=NONE)
        known = frozenset[str]().union(*{each.names for each in others}) - chosen[0].names
        if chosen[0] not in self._given:
            self.borrowed[chosen[0].path] = chosen[0].source
        return replace(
            source,
            pairing=Pairing(
                chosen[0].source.name,
                reason,
                tuple(sorted(each.source.name for each in others)),
                tuple(sorted(srdf.names & known)),
                certain=len(chosen) == 1,
            ),
        )

    def _choice(
        self, srdf: Description
    ) -> tuple[Sequence[Description], Sequence[Description], str]:
        """Return the URDF of *srdf*, others of its name, and the reason; several are a doubt."""
        named = self._named if srdf.source.named else Robots(())
        alone = named.every if len(named.every) == 1 else ()
        together = _of_stem(srdf, named) or [each for each in alone if _speaks_of(srdf, each)]
        if together:
            others = () if alone else named.of_name(srdf)
            return together, _namesakes(srdf, together[0], others), TOGETHER
        package = self._package(srdf)
        unknown = package.unknown.every
        if _of_stem(srdf, package.unknown) and not _of_stem(srdf, package.robots):
            return (), (), ""
        known = package.robots.of_name(srdf)
        for found, reason in (
            (_of_stem(srdf, package.robots), "its file has the same name"),
            (() if unknown else _only(srdf, package.robots), "it is the only one of its package"),
        ):
            if found:
                return found, _namesakes(srdf, found[0], known), reason
        found = named.of_name(srdf) or known or self._given.of_name(srdf)
        found = found or Robots([*self._in_others(srdf)]).of_name(srdf)
        if not found and alone:
            return alone, (), TOGETHER
        by_share = sorted(found, key=lambda urdf: (-urdf.share_defined(srdf.names), str(urdf.path)))
        return by_share, by_share[1:], "it describes the robot of that name"

    def _package(self, srdf: Description) -> _Package:
        """Return the robots of the package of *srdf*."""
        home = srdf.path.parent, srdf.source.name[:1] == "<"
        found = self._packages.get(home)
        if found is None:
            every = [*self._in_package(srdf)]
            unknown = [each for each in every if each.varies and each not in self._given]
            known = [each for each in every if each not in unknown]
            found = self._packages[home] = _Package(Robots(known), Robots(unknown))
        return found

    def _in_package(self, srdf: Description) -> Iterator[Description]:
        """Yield the robots of the package of *srdf*: those given, and those that lie there."""
        folders = dict.fromkeys(absolute(srdf.path.parent / folder) for folder in FOLDERS)
        given = Robots([each for each in self.given if each.path.parent in folders])
        yield from given.every
        if self.overlay is None or srdf.source.name[:1] == "<":
            return
        for folder in folders:
            provide(folder, content=False)
            for pattern in PATTERNS:
                yield from self._described(sorted(folder.glob(pattern)), given)

    def _in_others(self, srdf: Description) -> Iterator[Description]:
        """Yield the robots of the packages beside that of *srdf*."""
        homes = (srdf.path.parent, srdf.path.parent.parent)
        provide(srdf.path, content=False)
        home = next((each for each in homes if (each / MANIFEST).is_file()), None)
        if home is None or self.overlay is None:
            return
        provide_below(home.parent, 2)
        ways = (f"{folder}/{pattern}" for folder in NEIGHBOURS for pattern in PATTERNS)
        files = [path for way in ways for path in sorted(home.parent.glob(way))]
        found = self._described(files[:MOST_FILES], Robots(()))
        yield from (each for each in found if not each.varies)

    def _described(self, paths: Iterable[Path], known: Robots) -> Iterator[Description]:
        """Yield what the files at *paths* describe; not those *known*."""
        for path in paths:
            if path not in self._read:
                self._read[path] = self._at(path)
            found = self._read[path]
            if found is not None and found not in known:
                yield found

    def _at(self, path: Path) -> Description | None:
        try:
            found = describe(_companion(path, self.overlay or NOTHING))
        except (OSError, SourceError):
            return None
        return found if found is not None and found.kind == URDF and not found.unexpanded else None

    def _configured(self, path: Path) -> Pairing:
        """Return the pairing with the URDF that is configured."""
        given = next((each for each in self.given if each.path == path), None)
        if given is None and self.overlay is not None:
            self.borrowed[path] = _configured_companion(path, self.overlay)
        name = shown(path) if given is None else given.source.name
        return Pairing(name, "it is configured")


def _of_stem(srdf: Description, urdfs: Robots) -> list[Description]:
    """Return the one of *urdfs* whose file is called like that of *srdf*; rather no xacro."""
    found = urdfs.by_stem.get(srdf.stem, ())
    return sorted(found, key=lambda urdf: (urdf.generated, -shared_directories(srdf, urdf)))[:1]


def _only(srdf: Description, urdfs: Robots) -> Sequence[Description]:
    """Return the only one of *urdfs*, if it may be of the robot of *srdf*."""
    plain = urdfs.plain or urdfs.every
    fits = len(plain) == 1 and (plain[0].robot == srdf.robot or srdf.resembles(plain[0]))
    return plain if fits else ()


def _speaks_of(srdf: Description, urdf: Description) -> bool:
    """Tell whether *srdf* names the robot of *urdf*, or anything of it, as far as is known."""
    shared = srdf.generated or urdf.generated or not srdf.names.isdisjoint(urdf.names)
    return urdf.robot == srdf.robot or shared


def _namesakes(
    srdf: Description, chosen: Description, urdfs: Iterable[Description]
) -> list[Description]:
    """Return the others of *urdfs* if *chosen* has the name of the robot, as they do."""
    return [each for each in urdfs if each is not chosen and chosen.robot == srdf.robot]


def _companion(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    if overlay and (open_ := overlay.get(real(path))):
        return replace(open_, companion=True)
    provide(path, content=True)
    if not path.is_file():
        raise SourceError(shown(path), "not a regular file")
    return replace(decode(shown(path), path.read_bytes()), companion=True)


def _configured_companion(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    try:
        return _companion(path, overlay)
    except (OSError, SourceError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        problem = cause if path.exists() else missing(path)
        raise ConfigError(f"srdf: {shown(path)}: {problem}") from None
