"""The latest examination of one model, and what it was made from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.files.pathname import real
from kinlint.fixes.texts import Texts
from kinlint.incremental.examiner import Cancelled, Incremental
from kinlint.lint import Examination, examine
from kinlint.model import Finding, Fix
from kinlint.phases import Phases
from kinlint.server.cancellation import Interruptible
from kinlint.server.document_store import Stamp, Stock, stamp
from kinlint.server.frozen_state import Snapshot
from kinlint.server.workspace_folder import Model
from kinlint.text import SourceText, Span

LARGE, MUCH = 1_000_000, 4
"""A model of so many characters is previewed where not more than a fourth of them is open."""
Named: TypeAlias = tuple[str, str, Span, str]


@dataclass
class Bench:
    """Examines a model again and again.

    `examination` is None while it is not what the files hold now, or if it failed. `outside` are
    files that are read along, with what changes with them. It is `resting` when nobody has one of
    its files open: then only what was told of it is kept, elsewhere. It is `young` while what
    it keeps is new.
    """

    model: Model
    book: Rulebook
    examination: Examination | None = None
    outside: dict[Path, Stamp] = field(default_factory=dict)
    fixes: dict[Named, tuple[Fix, ...]] = field(default_factory=dict)
    _incremental: Incremental | None = None
    _repairing: Examination | None = None
    _overlay: Mapping[Path, SourceText] = field(default_factory=dict)
    resting: bool = False
    young: bool = False
    _tried: bool = False
    _previewed: int = -1
    _complete: bool = False

    def holds(self, model: Model, book: Rulebook, stock: Stock, *, looking: bool) -> bool:
        """Whether what is known still is what there is to know of *model*.

        *looking* tells that files on disk may have changed.
        """
        mine = self.model
        return (
            self._tried
            and mine.sources == model.sources
            and mine.beside == model.beside
            and mine.settings == model.settings
            and self.book is book
            and all(self._overlay.get(path) is stock.overlay.get(path) for path in self.outside)
            and not (looking and self._moved())
        )

    def _moved(self) -> bool:
        return any(stamp(path) != before for path, before in self.outside.items())

    def look(
        self, model: Model, book: Rulebook, stock: Stock, cancelled: Callable[[], bool]
    ) -> Bench:
        """Examine *model*; what knows now what can be told, which may be of its open files alone.

        Raises `Cancelled` if that is asked for, `UsageError` if the settings name what is not.
        """
        part = self._preview(model, stock.snapshot, cancelled)
        if part is not None:
            return part
        self._examine(model, book, stock, cancelled)
        return self

    def _preview(
        self, model: Model, snapshot: Snapshot, cancelled: Callable[[], bool]
    ) -> Bench | None:
        """What is found in the open files alone, once for each state of a large model.

        None where that is not worth its time: the model is small, or known so far.
        """
        if self._complete or self._previewed == snapshot.generation:
            return None
        near = [one for one in model.sources if model.paths[one.name] in snapshot.buffers]
        size, whole = (sum(len(one.text) for one in some) for some in (near, model.sources))
        if not near or whole < LARGE or size * MUCH > whole:
            return None
        part = replace(
            model,
            paths={one.name: model.paths[one.name] for one in near},
            sources=tuple(near),
            settings=replace(model.settings, partial=True),
        )
        overlay = {real(path): each.source for path, each in snapshot.buffers.items()}
        made = examine(
            [*part.sources, *part.beside],
            part.errors,
            part.settings,
            self.book,
            Interruptible(cancelled),
            overlay=overlay,
        )
        self._previewed = snapshot.generation
        return Bench(part, self.book, made)

    def _examine(
        self, model: Model, book: Rulebook, stock: Stock, cancelled: Callable[[], bool]
    ) -> None:
        if self.model.settings != model.settings or self.book is not book or self._moved():
            self._incremental, self._complete = None, False
        self.model, self.book, self.examination = model, book, None
        self._repairing, self._tried, self.resting = None, True, False
        self._overlay = stock.overlay
        self.fixes.clear()
        try:
            if self._incremental is None:
                Policies(model.settings, book.rules).check()
                self._incremental, self.young = Incremental(model.settings, book), True
            made = self._incremental.examine(
                [*model.sources, *model.beside],
                model.errors,
                overlay=self._overlay,
                cancelled=cancelled,
            )
        except Cancelled:
            self._tried = False
            raise
        except Exception:
            self._incremental, self._complete = None, False
            raise
        own = set(model.paths)
        texts = (text for document in made.documents for text in document.sources)
        paths = {real(text.name) for text in texts if text.name not in own}
        self.outside = {path: stamp(path) for path in paths}
        self.examination, self._complete = made, True

    def rest(self) -> None:
        """Keep nothing of what was found, but that it is known."""
        self.resting, self.examination = True, None
        self._incremental, self._repairing, self._complete = None, None, False
        self.fixes.clear()

    def wake(self) -> None:
        """Have it examined again, since somebody asks."""
        self._tried = False

    @property
    def failed(self) -> bool:
        """Whether the examination broke down, and will do so again unless something changes."""
        return self._tried and self.examination is None and not self.resting

    def repairing(self, phases: Phases) -> Examination:
        """The examination with all that repairs ask for."""
        if self._repairing is None:
            model = self.model
            self._repairing = examine(
                self.texts.given,
                model.errors,
                model.settings,
                self.book,
                phases,
                repairing=True,
                overlay=self._overlay,
            )
        return self._repairing

    @property
    def texts(self) -> Texts:
        """The texts that were examined, for those who change them."""
        return Texts([*self.model.sources, *self.model.beside], changed=self._overlay)


def named(finding: Finding) -> Named:
    """What a finding has in common with the same one of another examination."""
    place = finding.location
    return finding.rule.code, place.source.name, place.span, finding.message
