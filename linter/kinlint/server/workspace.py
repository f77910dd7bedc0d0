"""The models of a workspace and their analyses, for use by one thread."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from pathlib import Path
from traceback import format_exc
from typing import TypeVar

from kinlint import garbage
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import KinlintError
from kinlint.files.pathname import has_working_directory
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.pipeline.analyzer import Cancelled
from kinlint.server.diagnostic_conversion import FileDiagnostics, diagnostics_by_file
from kinlint.server.document_store import DocumentStore, stamps
from kinlint.server.frozen_state import FrozenState
from kinlint.server.readable_documents import ReadableDocuments
from kinlint.server.request_context import Places, RequestContext
from kinlint.server.session import Session
from kinlint.server.thread_limit import answered
from kinlint.server.working_directory import work_in
from kinlint.server.workspace_folder import Model, WorkspaceFolder
from kinlint.text import SourceText

T = TypeVar("T")
BOOKS = 8
"""Number of rulebooks kept, besides one that is added: each change of a rule file makes another."""


class Outdated(Exception):
    """A request refers to a state of the text that is gone."""


@dataclass(frozen=True)
class Step:
    """The result of analyzing one model."""

    generation: int
    """The generation of the snapshot that was analyzed."""
    key: frozenset[Path] = frozenset()
    """The paths of the files of the model."""
    found: Mapping[Path, FileDiagnostics] = field(default_factory=dict)
    """The diagnostics by file."""
    done: bool = False
    """True if nothing is left to analyze."""
    fresh: frozenset[Path] = frozenset()
    """The files whose analysis is complete."""
    models: Mapping[frozenset[Path], Model] = field(default_factory=dict)
    """All models of the workspace by their keys."""
    problems: Sequence[str] = ()
    """Messages for the user."""
    faults: Sequence[str] = ()
    """Messages for maintainers of kinlint."""


class Workspace:
    """The models of a workspace with what was found in each."""

    def __init__(self, cache: Path, encoding: str, *, related: bool) -> None:
        self._cache, self._encoding, self._related = cache, encoding, related
        self._blamed: dict[frozenset[Path], str] = {}
        self._stock: DocumentStore | None = None
        self._projects: dict[tuple[Path, bool], WorkspaceFolder] = {}
        self._sessions: dict[frozenset[Path], Session] = {}
        self._books: dict[tuple[object, ...], Rulebook] = {}
        self._models: dict[frozenset[Path], Model] = {}
        self._problems: list[str] = []
        self._readable = ReadableDocuments()
        self._looked = -1

    def step(self, snapshot: FrozenState, cancelled: Callable[[], bool]) -> Step:
        """Examine the most urgent model that changed.

        Stops when *cancelled*, or the working directory is removed meanwhile, with a step that
        found nothing and is not done.
        """
        step = self._try(snapshot, cancelled)
        if step.faults and not has_working_directory():
            self._sessions[step.key].invalidate()
            return Step(snapshot.generation)
        return step

    def _try(self, snapshot: FrozenState, cancelled: Callable[[], bool]) -> Step:
        faults: list[str] = []
        looking = self._turn(snapshot)
        fresh: set[Path] = set()
        for urgency, model in sorted(self._ranked(snapshot), key=lambda each: each[0]):
            if urgency > _LAST:
                break
            try:
                book = self._book(model.settings)
                session = self._sessions.setdefault(model.key, Session(model, book))
                if session.is_current(model, book, self._documents, looking=looking):
                    fresh |= model.key | session.outside.keys()
                    continue
                shown = session.analyze(model, book, self._documents, cancelled)
                self._readable.remember(session.examination)
            except Cancelled:
                return Step(snapshot.generation)
            except KinlintError as error:
                self._blamed[model.key] = str(error)
                fresh |= model.key
                continue
            except Exception:  # noqa: BLE001  a fault in a rule or a reader ends no session
                faults.append(format_exc())
                shown = self._sessions[model.key]
            self._blamed.pop(model.key, None)
            found = diagnostics_by_file(shown, self._places(shown, snapshot), related=self._related)
            if urgency == _LAST:
                self._readable.forget(each.name for each in model.sources)
                shown.release()
            fresh |= shown.model.key | shown.outside.keys()
            return self._step(model.key, found, fresh, faults)
        self._looked = snapshot.epoch
        for urgency, model in self._ranked(snapshot):
            if urgency >= _LAST and model.key in self._sessions:
                self._sessions[model.key].release()
                self._readable.forget(each.name for each in model.sources)
        self._settle()
        return replace(self._step(frozenset(), {}, fresh, faults), done=True)

    def _settle(self) -> None:
        """Search what new models keep for garbage now, and not while somebody types."""
        fresh = [session for session in self._sessions.values() if session.fresh_cache]
        for session in fresh:
            session.fresh_cache = False
        if fresh:
            garbage.freeze()

    def _step(
        self,
        key: frozenset[Path],
        found: Mapping[Path, FileDiagnostics],
        fresh: Collection[Path],
        faults: Sequence[str],
    ) -> Step:
        return Step(
            self._documents.snapshot.generation,
            key,
            found,
            fresh=frozenset(fresh),
            models=self._models,
            problems=tuple(dict.fromkeys((*self._problems, *self._blamed.values()))),
            faults=faults,
        )

    def consult(
        self,
        path: Path,
        source: SourceText | None,
        ask: Callable[[RequestContext], T],
        cancelled: Callable[[], bool],
    ) -> T | None:
        """Return the answer of *ask* for the file at *path*; None if it is part of no model.

        *ask* may be *cancelled*. Raises `Outdated` if the analysis is not up to date, or the text
        is not *source*.
        """
        for session in self._sessions.values():
            for text in self._texts(session):
                if self._places(session, self._documents.snapshot).path(text.name) == path:
                    if session.examination is None:
                        if session.failed:
                            return None
                        session.invalidate()
                        raise Outdated
                    return answered(ask, self._view(session, text, source, cancelled))
        return None

    def _view(
        self,
        session: Session,
        text: SourceText,
        source: SourceText | None,
        cancelled: Callable[[], bool],
    ) -> RequestContext:
        assert session.examination is not None
        if source is not None and source.text != text.text:
            raise Outdated
        snapshot = self._documents.snapshot
        places = self._places(session, snapshot)
        buffer = places.buffer(text.name)
        return RequestContext(
            uri=places.uri(text.name),
            path=places.path(text.name),
            source=text,
            version=None if buffer is None else buffer.version,
            examination=session.examination,
            settings=session.model.settings,
            rulebook=session.book,
            places=places,
            session=session,
            cancelled=cancelled,
            readable=self._readable.of(text.name, session.examination),
        )

    def texts(self) -> dict[str, tuple[SourceText, Places]]:
        """Return all texts of models, and those that they include, by name, with their places."""
        if self._stock is None:
            return {}
        found: dict[str, tuple[SourceText, Places]] = {}
        for model in self._models.values():
            places = Places(self._stock.snapshot, self._encoding, dict(model.paths))
            found |= {each.name: (each, places) for each in model.sources}
        for session in self._sessions.values():
            places = self._places(session, self._stock.snapshot)
            for text in self._texts(session):
                found.setdefault(text.name, (text, places))
        return found

    def _texts(self, session: Session) -> Iterator[SourceText]:
        yield from session.model.sources
        if session.examination is not None:
            for document in session.examination.documents:
                yield from document.sources

    def _places(self, session: Session, snapshot: FrozenState) -> Places:
        return Places(snapshot, self._encoding, dict(session.model.paths))

    @property
    def _documents(self) -> DocumentStore:
        assert self._stock is not None
        return self._stock

    def _turn(self, snapshot: FrozenState) -> bool:
        """Go on to *snapshot*; whether files on disk may have changed since the last time."""
        before = self._stock
        before_generation = -1 if before is None else before.snapshot.generation
        astray = not has_working_directory()
        if before is None or before.snapshot.epoch != snapshot.epoch or astray:
            work_in(snapshot.roots)
            self._projects.clear()
        if before is None:
            self._stock = DocumentStore(snapshot)
        self._documents.advance(snapshot)
        if before is None or before_generation != snapshot.generation or astray:
            self._problems = []
            self._models = {model.key: model for model in self._found(snapshot)}
            self._sessions = {k: one for k, one in self._sessions.items() if k in self._models}
            self._blamed = {k: one for k, one in self._blamed.items() if k in self._models}
        return self._looked != snapshot.epoch

    def _ranked(self, snapshot: FrozenState) -> Iterator[tuple[int, Model]]:
        for key, model in self._models.items():
            session = self._sessions.get(key)
            yield (
                _urgency(key if session is None else key | session.outside.keys(), snapshot),
                model,
            )

    def _found(self, snapshot: FrozenState) -> Iterator[Model]:
        """All models; those of a project whose configuration is wrong are left out."""
        loose = (path.parent for path in snapshot.buffers if snapshot.root_of(path) is None)
        homes = [(root, False) for root in snapshot.roots] + [(folder, True) for folder in loose]
        for directory, apart in dict.fromkeys(homes):
            try:
                project = self._projects.get((directory, apart))
                if project is None:
                    project = WorkspaceFolder(directory, snapshot, self._cache, loose=apart)
                    self._projects[directory, apart] = project
                yield from list(project.models(self._documents))
                self._problems += project.untrusted()
            except KinlintError as error:
                self._problems.append(str(error))

    def _book(self, settings: Settings) -> Rulebook:
        """The rules for *settings*. Raises `KinlintError` if they cannot be had."""
        more = (*settings.extra_contexts.values(), *settings.context_directories)
        files = (*settings.rules, *settings.shapes, *more)
        key = settings.rules, settings.shapes, more, stamps(files) if files else ()
        if key not in self._books:
            for stale in list(self._books)[:-BOOKS]:
                del self._books[stale]
            self._books[key] = rulebook.load(settings.rules, settings.shapes, self._cache)
        return self._books[key]


_LAST = 3
"""Highest urgency number at which models are analyzed at all."""


def _urgency(paths: Collection[Path], snapshot: FrozenState) -> int:
    """Return the urgency of the model read from *paths*, 0 being the most urgent.

    0 is the buffer being typed in, then what is waited for, what is open, and the rest.
    """
    newest = next(iter(snapshot.buffers), None)
    if newest is not None and newest in paths:
        return 0
    if not snapshot.wanted.isdisjoint(paths):
        return 1
    if any(path in snapshot.buffers for path in paths):
        return 2
    return _LAST if snapshot.everything else _LAST + 1
