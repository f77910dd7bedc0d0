"""Texts that are read where they are linted: this process knows only what divides them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files import url_mirror
from kinlint.files.pathglob import absolute
from kinlint.formats.dependencies.file_groups import CONFIGURATIONS, JoinKeys, join_keys
from kinlint.formats.dependencies.mentions import includes_nothing
from kinlint.light_dataclasses import dataclass
from kinlint.project.discovery import Input, may_be_model
from kinlint.project.reading import read_models, read_source
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.files.url_root import Root


@dataclass(frozen=True)
class UnreadText(SourceText):
    """A text that is not here; `text` is empty."""

    size: int = 0
    """Number of its characters."""
    closed: bool = False
    """True if it depends on no other file."""
    robots: frozenset[str] = frozenset()
    """Names of the robots that it describes."""
    included: tuple[str, ...] = ()
    """Paths of the files that it includes."""
    paired: bool = False
    """True if it is judged by others, which are found for it."""

    @property
    def keys(self) -> JoinKeys:
        """Properties that may join it to others."""
        return JoinKeys(self.format, self.robots, self.included)


class Survey(NamedTuple):
    """Facts that are known of some inputs without their texts."""

    texts: list[UnreadText]
    """The models."""
    errors: list[SourceError]
    """Inputs that cannot be read."""
    passed: list[SourceError]
    """Inputs that may have been meant as models."""


def survey(settings: Settings, roots: Sequence[Root], inputs: Sequence[Input]) -> Survey:
    """Look at *inputs* here, those by URL below *roots*."""
    url_mirror.mirror(roots)
    url_mirror.fetch([each.name for each in inputs])
    meant = [one for one in inputs if one.named or not one.remote or _may_be_model(one)]
    passed: list[SourceError] = []
    sources, errors = read_models(meant, settings, passed)
    return Survey([_unread(each) for each in sources], errors, passed)


def _may_be_model(one: Input) -> bool:
    try:
        return may_be_model(absolute(one.name))
    except OSError:
        return True  # whoever reads it says why


def _unread(source: SourceText) -> UnreadText:
    from kinlint.formats.dependencies.robot_descriptions import may_be_srdf  # noqa: PLC0415

    keys = join_keys(source)
    return UnreadText(
        source.name,
        "",
        named=source.named,
        format=keys.format,
        size=len(source.text),
        closed=includes_nothing(source),
        robots=keys.robots,
        included=keys.included,
        paired=may_be_srdf(source) or keys.format in CONFIGURATIONS,
    )


def texts(model: Sequence[SourceText]) -> list[SourceText]:
    """Return *model* with its texts. Raises `SourceError` for one that cannot be read any more."""
    return [_text(each) if isinstance(each, UnreadText) else each for each in model]


def _text(unread: UnreadText) -> SourceText:
    path = None if url_mirror.path_of(unread.name) else absolute(unread.name)
    return read_source(Input(unread.name, path, unread.named, remote=path is None))


def provided(
    share: Sequence[Sequence[SourceText]], roots: Sequence[Root]
) -> list[list[SourceText]]:
    """Return the models of *share* with their texts, fetched together."""
    url_mirror.mirror(roots)
    url_mirror.fetch([each.name for model in share for each in model if _is_unread(each)])
    return [texts(model) for model in share]


def _is_unread(source: SourceText) -> bool:
    return isinstance(source, UnreadText)


def keys_of(source: SourceText) -> JoinKeys:
    """Return what may join *source* to others."""
    return source.keys if isinstance(source, UnreadText) else join_keys(source)


def is_closed(source: SourceText) -> bool:
    """Tell whether *source* certainly depends on no other file."""
    return source.closed if isinstance(source, UnreadText) else includes_nothing(source)


def size(source: SourceText) -> int:
    """Return the number of characters of *source*."""
    return source.size if isinstance(source, UnreadText) else len(source.text)
