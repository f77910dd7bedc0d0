"""The texts that fixes change: those that are given, and those that these include."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Protocol

from kinlint.document import Document
from kinlint.edits import Edit, applied
from kinlint.files.pathname import real
from kinlint.formats.recognition import with_text
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.text import SourceText


class Changes(Protocol):
    """Edits of texts, by the paths of their files."""

    @property
    def sources(self) -> Mapping[Path, SourceText]:
        """The texts as they are."""
        ...

    @property
    def edits(self) -> Mapping[Path, Sequence[Edit]]:
        """The edits of each."""
        ...


@dataclass(frozen=True)
class Texts:
    """The texts of a run, and their changes so far."""

    given: Sequence[SourceText]
    """The texts as they were read."""
    streamed: Collection[str] = ()
    """Names of texts that are no files; what they include stays as it is, too."""
    kept: Collection[str] = ()
    """Names of texts that stay as they are."""
    changed: Mapping[Path, SourceText] = field(default_factory=dict)
    """The changed texts by the real paths of their files."""
    _paths: dict[str, Path] = field(default_factory=dict, repr=False)

    def same(self, other: Texts) -> bool:
        """Tell whether all that is given and changed reads as in *other*."""
        return list(self.given) == list(other.given) and self.changed == other.changed

    def only(self, sources: Iterable[SourceText]) -> Texts:
        """Return the same with those of the given texts that are among *sources*."""
        names = {each.name for each in sources}
        return replace(self, given=[each for each in self.given if each.name in names])

    @property
    def size(self) -> int:
        """The number of characters of the given texts."""
        return sum(len(each.text) for each in self.given)

    def path(self, source: SourceText) -> Path:
        """Return the file that holds *source*, with all links followed."""
        if source.name not in self._paths:
            self._paths[source.name] = real(source.name)
        return self._paths[source.name]

    def paths(self, document: Document) -> Iterable[Path]:
        """Return the files that *document* is read from."""
        return map(self.path, document.sources)

    def rewritten(self, batch: Iterable[Changes]) -> Texts:
        """Return these texts with the edits of *batch*, those that several make once."""
        edits: dict[Path, dict[Edit, None]] = {}
        sources: dict[Path, SourceText] = {}
        for each in batch:
            sources |= each.sources
            for path, made in each.edits.items():
                edits.setdefault(path, {}).update(dict.fromkeys(made))
        new = {
            path: with_text(sources[path], applied(sources[path].text, made))
            for path, made in edits.items()
        }
        given = [
            with_text(source, new[path].text) if (path := self.path(source)) in new else source
            for source in self.given
        ]
        return replace(self, given=given, changed={**self.changed, **new})
