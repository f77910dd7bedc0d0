"""The latest examination of one model, and what it was made from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.errors import FileTimeout
from kinlint.files.pathname import real
from kinlint.finding import FindingKey, Fix
from kinlint.fixes.texts import Texts
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.lint import examine
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import Analyzer, Cancelled, Examination
from kinlint.server.cancellation import CancellablePhases
from kinlint.server.document_store import DocumentStore, Stamp, stamp
from kinlint.server.frozen_state import FrozenState
from kinlint.server.thread_limit import ANALYSIS, TimeOver, thread_limit
from kinlint.server.workspace_folder import Model
from kinlint.text import SourceText

LARGE, MUCH = 1_000_000, 4
"""A model of so many characters is previewed where not more than a fourth of them is open."""


@dataclass
class Session:
    """The analysis of one model, repeated as its files change."""

    model: Model
    """The model as it was last given."""
    book: Rulebook
    """The rules it is checked against."""
    examination: Examination | None = None
    """The latest analysis; None while it is out of date, or if it failed."""
    outside: dict[Path, Stamp] = field(default_factory=dict)
    """Included files that are no sources of their own, with their stamps."""
    fixes: dict[FindingKey, tuple[Fix, ...]] = field(default_factory=dict)
    """Fixes already proven, by finding."""
    _incremental: Analyzer | None = None
    _mending: Analyzer | None = None
    _overlay: Mapping[Path, SourceText] = field(default_factory=dict)
    released: bool = False
    """True if the analysis was dropped since none of the files is open; its diagnostics stay."""
    fresh_cache: bool = False
    """True if the incremental state is new, so that the garbage collector has not settled it."""
    _tried: bool = False
    _previewed: int = -1
    _complete: bool = False

    def is_current(
        self, model: Model, book: Rulebook, documents: DocumentStore, *, looking: bool
    ) -> bool:
        """Tell whether the last analysis still holds for *model*.

        *looking* tells that files on disk may have changed.
        """
        mine = self.model
        return (
            self._tried
            and mine.sources == model.sources
            and mine.beside == model.beside
            and mine.settings == model.settings
            and self.book is book
            and all(self._overlay.get(path) is documents.overlay.get(path) for path in self.outside)
            and not (looking and self._moved())
        )

    def _moved(self) -> bool:
        return any(stamp(path) != before for path, before in self.outside.items())

    def analyze(
        self, model: Model, book: Rulebook, documents: DocumentStore, cancelled: Callable[[], bool]
    ) -> Session:
        """Analyze *model* and return the session to report, which may cover its open files alone.

        Raises `Cancelled` if that is asked for, `UsageError` if the settings name what is not.
        """
        part = None
        with suppress(TimeOver), thread_limit(_seconds(model)):
            part = self._preview(model, documents.snapshot, cancelled)
        if part is not None:
            return part
        self._examine(model, book, documents, cancelled)
        return self

    def _preview(
        self, model: Model, snapshot: FrozenState, cancelled: Callable[[], bool]
    ) -> Session | None:
        """Analyze the open files of a large model alone, once for each of its states.

        None where that is not worth its time: the model is small, or already analyzed.
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
            CancellablePhases(cancelled),
            overlay=overlay,
        )
        self._previewed = snapshot.generation
        return Session(part, self.book, made)

    def _examine(
        self, model: Model, book: Rulebook, documents: DocumentStore, cancelled: Callable[[], bool]
    ) -> None:
        if self.model.settings != model.settings or self.book is not book or self._moved():
            self._incremental, self._complete = None, False
        self.model, self.book, self.examination = model, book, None
        self._mending, self._tried, self.released = None, True, False
        self._overlay = documents.overlay
        self.fixes.clear()
        try:
            if self._incremental is None:
                Policies(model.settings, book.rules).check_selectors()
                self._incremental, self.fresh_cache = (
                    Analyzer(model.settings, book, repeated=True),
                    True,
                )
            with thread_limit(_seconds(model)):
                made = self._incremental.examine(
                    [*model.sources, *model.beside],
                    model.errors,
                    overlay=self._overlay,
                    cancelled=cancelled,
                )
        except TimeOver:
            self._incremental, self._complete = None, False
            why = f"not checked within {_seconds(model):g} s"
            late = (FileTimeout(each.name, why) for each in model.sources)
            self.model = replace(model, errors=(*model.errors, *late))
            return
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

    def release(self) -> None:
        """Drop the analysis; its diagnostics stay published."""
        self.released, self.examination = True, None
        self._incremental, self._mending, self._complete = None, None, False
        self.fixes.clear()

    def invalidate(self) -> None:
        """Force a new analysis on the next step."""
        self._tried = False

    @property
    def failed(self) -> bool:
        """Tell whether the analysis raised an error and would again unless something changes."""
        return self._tried and self.examination is None and not self.released

    def repairing(self, phases: Phases) -> tuple[Examination, Analyzer]:
        """The examination with all that repairs ask for, and what made it, for trials of them."""
        model = self.model
        self._mending = self._mending or Analyzer(model.settings, self.book, trying=True)
        made = self._mending.examine(
            self.texts.given, model.errors, phases, repairing=True, overlay=self._overlay
        )
        return made, self._mending

    @property
    def texts(self) -> Texts:
        """The texts that were examined, for those who change them."""
        return Texts([*self.model.sources, *self.model.beside], changed=self._overlay)


def _seconds(model: Model) -> float:
    """Return the time that the analysis of *model* may take, in seconds."""
    limit = model.settings.file_timeout
    return ANALYSIS if not limit else limit * len(model.sources)
