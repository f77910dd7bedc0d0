"""All that is known of the files of a workspace. One thread works with it."""

from __future__ import annotations

import gc
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from traceback import format_exc
from typing import TypeVar

from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import KinlintError
from kinlint.incremental.examiner import Cancelled
from kinlint.server.diagnostics import Told, told
from kinlint.server.document_store import Stock, stamps
from kinlint.server.frozen_state import Snapshot
from kinlint.server.request_context import Places, View
from kinlint.server.session import Bench
from kinlint.server.workspace_folder import Model, Project
from kinlint.text import SourceText

T = TypeVar("T")


class Outdated(Exception):
    """What was asked for is about a state that is no more."""


@dataclass(frozen=True)
class Step:
    """What a step came to: what was `found` in the files of the model `key`, if it examined one.

    It is `done` if nothing is left to examine. `fresh` are the files of which all is known, and
    `models` all that there are. `problems` are for the user, `faults` for those who mend kinlint.
    """

    generation: int
    key: frozenset[Path] = frozenset()
    found: Mapping[Path, Told] = field(default_factory=dict)
    done: bool = False
    fresh: frozenset[Path] = frozenset()
    models: Mapping[frozenset[Path], Model] = field(default_factory=dict)
    problems: Sequence[str] = ()
    faults: Sequence[str] = ()


class Library:
    """The models of a workspace with what was found in each."""

    def __init__(self, cache: Path, encoding: str, *, related: bool) -> None:
        self._cache, self._encoding, self._related = cache, encoding, related
        self._blamed: dict[frozenset[Path], str] = {}
        self._stock: Stock | None = None
        self._projects: dict[tuple[Path, bool], Project] = {}
        self._benches: dict[frozenset[Path], Bench] = {}
        self._books: dict[tuple[object, ...], Rulebook] = {}
        self._models: dict[frozenset[Path], Model] = {}
        self._problems: list[str] = []
        self._looked = -1

    def step(self, snapshot: Snapshot, cancelled: Callable[[], bool]) -> Step:
        """Examine the most urgent model that changed.

        Stops when *cancelled*, with a step that found nothing and is not done.
        """
        faults: list[str] = []
        looking = self._turn(snapshot)
        fresh: set[Path] = set()
        for urgency, model in sorted(self._ranked(snapshot), key=lambda each: each[0]):
            if urgency > _LAST:
                break
            try:
                book = self._book(model.settings)
                bench = self._benches.setdefault(model.key, Bench(model, book))
                if bench.holds(model, book, self._stocked, looking=looking):
                    fresh |= model.key | bench.outside.keys()
                    continue
                shown = bench.look(model, book, self._stocked, cancelled)
            except Cancelled:
                return Step(snapshot.generation)
            except KinlintError as error:
                self._blamed[model.key] = str(error)
                fresh |= model.key
                continue
            except Exception:  # noqa: BLE001  a fault in a rule or a reader ends no session
                faults.append(format_exc())
                shown = self._benches[model.key]
            self._blamed.pop(model.key, None)
            found = told(shown, self._places(shown, snapshot), related=self._related)
            if urgency == _LAST:
                shown.rest()
            fresh |= shown.model.key | shown.outside.keys()
            return self._step(model.key, found, fresh, faults)
        self._looked = snapshot.epoch
        for urgency, model in self._ranked(snapshot):
            if urgency >= _LAST and model.key in self._benches:
                self._benches[model.key].rest()
        self._settle()
        return replace(self._step(frozenset(), {}, fresh, faults), done=True)

    def _settle(self) -> None:
        """Search what new models keep for garbage now, and not while somebody types."""
        young = [bench for bench in self._benches.values() if bench.young]
        for bench in young:
            bench.young = False
        if young:
            gc.unfreeze()
            gc.collect()
            gc.freeze()

    def _step(
        self,
        key: frozenset[Path],
        found: Mapping[Path, Told],
        fresh: Collection[Path],
        faults: Sequence[str],
    ) -> Step:
        return Step(
            self._stocked.snapshot.generation,
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
        ask: Callable[[View], T],
        cancelled: Callable[[], bool],
    ) -> T | None:
        """What *ask* gives for the file at *path*; None if it is part of no model.

        *ask* may be told that it is *cancelled*. Raises `Outdated` if it is not known what is to
        be said of it, or its text is not *source*.
        """
        for bench in self._benches.values():
            for text in self._texts(bench):
                if self._places(bench, self._stocked.snapshot).path(text.name) == path:
                    if bench.examination is None:
                        if bench.failed:
                            return None
                        bench.wake()
                        raise Outdated
                    return ask(self._view(bench, text, source, cancelled))
        return None

    def _view(
        self,
        bench: Bench,
        text: SourceText,
        source: SourceText | None,
        cancelled: Callable[[], bool],
    ) -> View:
        assert bench.examination is not None
        if source is not None and source != text:
            raise Outdated
        snapshot = self._stocked.snapshot
        places = self._places(bench, snapshot)
        buffer = places.buffer(text.name)
        return View(
            uri=places.uri(text.name),
            path=places.path(text.name),
            source=text,
            version=None if buffer is None else buffer.version,
            examination=bench.examination,
            settings=bench.model.settings,
            rulebook=bench.book,
            places=places,
            bench=bench,
            cancelled=cancelled,
        )

    def _texts(self, bench: Bench) -> Iterator[SourceText]:
        yield from bench.model.sources
        if bench.examination is not None:
            for document in bench.examination.documents:
                yield from document.sources

    def _places(self, bench: Bench, snapshot: Snapshot) -> Places:
        return Places(snapshot, self._encoding, dict(bench.model.paths))

    @property
    def _stocked(self) -> Stock:
        assert self._stock is not None
        return self._stock

    def _turn(self, snapshot: Snapshot) -> bool:
        """Go on to *snapshot*; whether files on disk may have changed since the last time."""
        before = self._stock
        before_generation = -1 if before is None else before.snapshot.generation
        if before is None or before.snapshot.epoch != snapshot.epoch:
            self._projects.clear()
        if before is None:
            self._stock = Stock(snapshot)
        self._stocked.turn(snapshot)
        if before is None or before_generation != snapshot.generation:
            self._problems = []
            self._models = {model.key: model for model in self._found(snapshot)}
            self._benches = {k: one for k, one in self._benches.items() if k in self._models}
            self._blamed = {k: one for k, one in self._blamed.items() if k in self._models}
        return self._looked != snapshot.epoch

    def _ranked(self, snapshot: Snapshot) -> Iterator[tuple[int, Model]]:
        for key, model in self._models.items():
            bench = self._benches.get(key)
            yield _urgency(key if bench is None else key | bench.outside.keys(), snapshot), model

    def _found(self, snapshot: Snapshot) -> Iterator[Model]:
        """All models; those of a project whose configuration is wrong are left out."""
        loose = (path.parent for path in snapshot.buffers if snapshot.root_of(path) is None)
        homes = [(root, False) for root in snapshot.roots] + [(folder, True) for folder in loose]
        for directory, apart in dict.fromkeys(homes):
            try:
                project = self._projects.get((directory, apart))
                if project is None:
                    project = Project(directory, snapshot, self._cache, loose=apart)
                    self._projects[directory, apart] = project
                yield from list(project.models(self._stocked))
            except KinlintError as error:
                self._problems.append(str(error))

    def _book(self, settings: Settings) -> Rulebook:
        """The rules for *settings*. Raises `KinlintError` if they cannot be had."""
        more = (*settings.extra_contexts.values(), *settings.context_directories)
        files = (*settings.rules, *settings.shapes, *more)
        key = settings.rules, settings.shapes, more, stamps(files) if files else ()
        if key not in self._books:
            self._books[key] = rulebook.load(settings.rules, settings.shapes, self._cache)
        return self._books[key]


_LAST = 3
"""How urgent at least is what is examined at all."""


def _urgency(paths: Collection[Path], snapshot: Snapshot) -> int:
    """How urgent a model is that is read from *paths*.

    0 for what is typed at, then what is waited for, what is open, and what nobody asked for.
    """
    newest = next(iter(snapshot.buffers), None)
    if newest is not None and newest in paths:
        return 0
    if not snapshot.wanted.isdisjoint(paths):
        return 1
    if any(path in snapshot.buffers for path in paths):
        return 2
    return _LAST if snapshot.everything else _LAST + 1
