"""Companions: the URDF that an SRDF refers to, whose links and joints it names.

That is decided from the texts, without parsing them: among the files of a run, or else in the
directories near the SRDF.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import takewhile
from pathlib import Path
from types import MappingProxyType

from kinlint.addresses import root_of
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.errors import ConfigError, SourceError
from kinlint.file_format import Format
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import missing, real, shown
from kinlint.formats.decoding import decode
from kinlint.formats.dependencies.mentions import Mentions
from kinlint.formats.recognition import with_format
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.formats.xml.references import names_in, resolve_references
from kinlint.formats.xml.schema import schema
from kinlint.terms import RDF_TYPE, iri
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

JOINED_TO = iri(f"{SRC}joinedTo")
LOSSES = frozenset(
    iri(f"{SRC}{name}")
    for name in (
        *("Unexpanded", "ExpansionFailure"),
        *("UnknownPackage", "UnknownArgument", "UnknownVariable"),
    )
)
"""Types of statements which imply that the robot may have parts that were not read."""
UNREAD = frozenset({iri(f"{SRC}unread")})
NOTHING: Mapping[Path, SourceText] = MappingProxyType({})
FOLDERS = (".", "..", "urdf", "../urdf", "robots", "../robots")
"""Directories searched for a URDF, relative to that of the SRDF, the most likely first."""
PATTERNS = ("*.urdf", "*.urdf.xacro")
ENDING = SRDF.suffixes[0]
MOST = 0.5
"""Share of the names in an SRDF that a URDF must define to be taken for its companion."""


@dataclass(frozen=True)
class Description:
    """A text that describes a robot: a URDF, or an SRDF about one."""

    source: SourceText
    kind: Format

    @cached_property
    def mentions(self) -> Mentions:
        """The names in its text."""
        return Mentions(self.source)

    @property
    def robot(self) -> str:
        """The name of the robot."""
        return self.mentions.robot

    @cached_property
    def names(self) -> frozenset[str]:
        """The links and joints that it has or, an SRDF, that it speaks of."""
        parts = self.mentions.parts
        return parts | self.mentions.references if self.kind == SRDF else parts

    @property
    def generated(self) -> bool:
        """Tell whether its names are made up when it is expanded."""
        return self.source.format is not None and self.source.format.expands_to is not None

    @property
    def varies(self) -> bool:
        """Tell whether arguments without known values decide its content."""
        return self.generated and self.mentions.has_arguments

    @property
    def unexpanded(self) -> bool:
        """Tell whether it contains names that only an expansion would make up."""
        return not self.generated and any("$" in name for name in (self.robot, *self.names))

    def share_defined(self, names: frozenset[str]) -> float:
        """Return the share of *names* that it defines, from 0 to 1."""
        return len(names & self.names) / len(names) if names else 1.0

    def may_refer_to(self, urdf: Description, *, alone: bool = False) -> bool:
        """Tell whether this SRDF may refer to *urdf*: it defines the robot's name and most others.

        Either will do if the two are *alone*.
        """
        named = self.robot == urdf.robot
        knows = self.generated or urdf.generated or urdf.share_defined(self.names) >= MOST
        return named or knows if alone else named and knows


def describe(source: SourceText) -> Description | None:
    """Return the description of *source*; None if it is neither SRDF nor URDF."""
    source = with_format(source)
    kind = source.format
    if kind is not None and kind.expands_to == URDF.name:
        kind = SRDF if ENDING in source.name.lower() else URDF
    return Description(source, kind) if kind in (SRDF, URDF) else None


def may_be_srdf(source: SourceText) -> bool:
    """Tell whether *source* is an SRDF, or may expand to one."""
    return with_format(source).format == SRDF or ENDING in source.name


def find_companions(
    sources: Iterable[SourceText], configured: Callable[[str], str | None] = lambda _: None
) -> dict[str, str]:
    """Return the name of the URDF among *sources* for each SRDF among them, by its name.

    It is the one *configured*, by its path, or one that has the robot's name and most of the links
    and joints that the SRDF refers to: the nearest of several. If there are no others, one of both
    will do.
    """
    every = [one for each in sources if (one := describe(each)) and not one.unexpanded]
    urdfs = [each for each in every if each.kind == URDF]
    srdfs = [each for each in every if each.kind == SRDF]
    found: dict[str, str] = {}
    for srdf in srdfs:
        name = srdf.source.name
        if (path := configured(name)) is not None:
            meant = [each for each in urdfs if _path(each) == path]
        else:
            alone = len(srdfs) == len(urdfs) == 1
            meant = [each for each in urdfs if srdf.may_refer_to(each, alone=alone)]
        if meant:
            found[name] = max(meant, key=lambda urdf: _fitness(srdf, urdf)).source.name
    return found


def _fitness(srdf: Description, urdf: Description) -> tuple[float, int]:
    """Return the share of common names, and then the number of common directories."""
    steps = zip(_path(srdf).split("/"), _path(urdf).split("/"), strict=False)
    return urdf.share_defined(srdf.names), sum(
        1 for _ in takewhile(lambda step: step[0] == step[1], steps)
    )


def _path(description: Description) -> str:
    return absolute(description.source.name).as_posix()


def join_companions(
    documents: Sequence[Document], configured: Callable[[str], str | None] = lambda _: None
) -> list[Document]:
    """Return *documents*, in which each SRDF says which URDF it is about; see `partners`.

    Documents with unread parts stay alone: what is missing there may be in the unread part.
    """
    texts = [document.source for document in documents]
    if not any(map(may_be_srdf, texts)):
        return list(documents)
    partner = find_companions(texts, configured)
    asked = {*partner, *partner.values()}
    whole = {
        each.source.name: each
        for each in documents
        if each.source.name in asked and _is_whole(each)
    }
    return [
        _joined(each, whole[found])
        if each.source.name in whole and (found := partner.get(each.source.name)) in whole
        else each
        for each in documents
    ]


def _is_whole(document: Document) -> bool:
    return not any(
        predicate in UNREAD or (predicate == RDF_TYPE and value in LOSSES)
        for _, predicate, value in document.statements
    )


def _joined(srdf: Document, urdf: Document) -> Document:
    """Return *srdf* with the root of *urdf* that it is joined to, and what it refers to there."""
    joined = root_of(urdf.graph)
    found = resolve_references(
        names_in(srdf), schema(SRDF.name), srdf.map.nodes, (joined, urdf.map.nodes)
    )
    leading = dict.fromkeys(((root_of(srdf.graph), JOINED_TO, joined), *dict(found)))
    return replace(srdf, statements=(*srdf.statements, *leading))


def find_nearby(
    sources: Sequence[SourceText], settings: Settings, overlay: Mapping[Path, SourceText] = NOTHING
) -> Sequence[SourceText]:
    """Return the texts of the URDF files that SRDF files among *sources* are about, if not given.

    *overlay* has texts that files are taken to hold, by their real paths. Raises `ConfigError`
    where a configuration names a URDF that cannot be read.
    """
    if not any(map(may_be_srdf, sources)):
        return ()
    configured = settings.partner
    known = find_companions(sources, configured)
    given = {absolute(source.name) for source in sources}
    found: dict[Path, SourceText] = {}
    for srdf in filter(None, map(describe, sources)):
        name = srdf.source.name
        if srdf.kind != SRDF or name in known:
            continue
        if (path := configured(name)) is not None:
            found[Path(path)] = _told(Path(path), overlay)
        elif name[:1] != "<":
            near = (one for one in _urdfs_near(absolute(name)) if one not in given)
            found.update(_fitting(srdf, near, overlay))
    return list(found.values())


def _urdfs_near(srdf: Path) -> Iterator[Path]:
    """Yield the URDF files that may describe the robot of the file at *srdf*, the nearest first."""
    for folder in dict.fromkeys(absolute(srdf.parent / folder) for folder in FOLDERS):
        for pattern in PATTERNS:
            yield from sorted(one for one in folder.glob(pattern) if one.is_file())


def _fitting(
    srdf: Description, candidates: Iterable[Path], overlay: Mapping[Path, SourceText]
) -> dict[Path, SourceText]:
    """Return the first of *candidates* that *srdf* may be about, with its text."""
    for path in candidates:
        try:
            urdf = describe(_companion(path, overlay))
        except (OSError, SourceError):
            continue
        if urdf is not None and not urdf.varies and srdf.may_refer_to(urdf):
            return {path: urdf.source}
    return {}


def _companion(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    if overlay and (open_ := overlay.get(real(path))):
        return replace(open_, companion=True)
    if not path.is_file():
        raise SourceError(shown(path), "not a regular file")
    return replace(decode(shown(path), path.read_bytes()), companion=True)


def _told(path: Path, overlay: Mapping[Path, SourceText]) -> SourceText:
    try:
        return _companion(path, overlay)
    except (OSError, SourceError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        problem = cause if path.exists() else missing(path)
        raise ConfigError(f"srdf: {shown(path)}: {problem}") from None
