"""The server: what it knows of the client, and how features ask what was found."""

from __future__ import annotations

import os
from asyncio import Future
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from kinlint import __version__
from kinlint.light_dataclasses import replace
from kinlint.pipeline.analyzer import Cancelled
from kinlint.project.layers import cache_directory
from kinlint.server.buffers import Buffer, Buffers, path_of
from kinlint.server.client_settings import ClientSettings
from kinlint.server.diagnostic_conversion import FileDiagnostics
from kinlint.server.frozen_state import FrozenState
from kinlint.server.protocol import Protocol
from kinlint.server.request_context import RequestContext
from kinlint.server.scheduler import Scheduler
from kinlint.server.worker import Worker
from kinlint.server.workspace import Outdated, Step, Workspace

T = TypeVar("T")
NAME = "kinlint"
_ATTEMPTS = 3
"""Number of outdated analyses that a request meets, while nothing changes, before it ends."""


class KinlintServer(LanguageServer):
    """A language server for robot descriptions.

    `told` has what was found in each file, by the models that say so. `listeners` are called with
    the files of which something else is to be told, and whether nothing more is to come.
    """

    protocol: Protocol

    def __init__(self) -> None:
        super().__init__(NAME, __version__, protocol_cls=Protocol)
        self.buffers = Buffers()
        self.preferences = ClientSettings()
        self.roots: tuple[Path, ...] = ()
        self.worker = Worker()
        self.told: dict[Path, dict[frozenset[Path], FileDiagnostics]] = {}
        self.listeners: list[Callable[[frozenset[Path], bool], None]] = []
        self.dismissed = False
        self.watch: Future[None] | None = None
        self._epoch = 0
        self._said: set[str] = set()
        self._examiner: Scheduler | None = None

    @property
    def encoding(self) -> str:
        """The units in which the client counts columns."""
        return types.PositionEncodingKind(self.workspace.position_encoding).value

    @property
    def scheduler(self) -> Scheduler:
        """Return the scheduler of analyses, created on first use."""
        if self._examiner is None:
            known = self.client_capabilities.text_document
            told = known.publish_diagnostics if known else None
            related = bool(told and told.related_information)
            library = Workspace(cache_directory(os.environ), self.encoding, related=related)
            self._examiner = Scheduler(library, self.worker, self._snapshot, self._deliver)
        return self._examiner

    @property
    def supports_versioned_edits(self) -> bool:
        """Tell whether the client takes edits that are bound to document versions."""
        known = self.client_capabilities.workspace
        edits = known.workspace_edit if known else None
        return bool(edits and edits.document_changes)

    @property
    def supports_resolve(self) -> bool:
        """Tell whether the client asks for the edit of a code action only when it is chosen."""
        known = self.client_capabilities.text_document
        actions = known.code_action if known else None
        resolve = actions.resolve_support if actions else None
        return bool(resolve and "edit" in resolve.properties)

    def changed(self, uri: str | None = None, *, disk: bool = False) -> None:
        """The text *uri* changed, or all may have; *disk* tells that files may have, too."""
        self._epoch += disk
        buffer = None if uri is None else self.buffers.get(uri)
        self.scheduler.change(now=disk or not self._postponed(buffer))

    def shut_down(self, *, asked: bool) -> None:
        """Examine nothing more; *asked* for it, or because the client is gone."""
        self.dismissed = self.dismissed or asked
        if self._examiner is not None:
            self._examiner.stop()

    def use_settings(self, preferences: ClientSettings) -> None:
        """Go by *preferences* from now on."""
        self.preferences = preferences
        for problem in preferences.problems:
            self._complain(problem)
        self.changed(disk=True)

    async def wait_until_settled(self, path: Path | None) -> None:
        """Wait until all is known of the file at *path*, or of all files."""
        if path is None or not self._postponed(self.buffers.at_path(path)):
            await self.scheduler.wait_until_settled(path)

    def _postponed(self, buffer: Buffer | None) -> bool:
        """Tell whether *buffer* is analyzed only when it is saved."""
        return self.preferences.on_save and buffer is not None and not buffer.saved

    async def consult(self, uri: str, ask: Callable[[RequestContext], T]) -> T | None:
        """Return the answer of *ask* for *uri*; None if that is in no model, or outdated.

        *ask* runs on the worker thread with the newest text and its complete analysis; it may query
        the store of the examination.
        """
        path = path_of(uri)
        library = self.scheduler.library
        outdated = 0
        while outdated < _ATTEMPTS:
            await self.scheduler.wait_until_settled(path)
            buffer = self.buffers.at_path(path)
            source = None if buffer is None else buffer.source
            cancelled = self.scheduler.interruption()
            try:
                job = partial(library.consult, path, source, ask, cancelled)
                return await self.worker.run(job)
            except Cancelled:
                pass
            except Outdated:
                outdated = 0 if cancelled() else outdated + 1
        return None

    async def request_context(self, uri: str) -> RequestContext | None:
        """Return the request context of *uri*, whose store must not be queried."""
        return await self.consult(uri, lambda view: view)

    def diagnostics(self, path: Path) -> FileDiagnostics:
        """Merge the diagnostics of all models that contain the file at *path*."""
        all_told = list(self.told.get(path, {}).values())
        if len(all_told) <= 1:
            return all_told[0] if all_told else FileDiagnostics()
        items = {repr(item): item for told in all_told for item in told.items}
        return replace(all_told[0], items=tuple(items.values()))

    def log(self, message: str, kind: types.MessageType = types.MessageType.Error) -> None:
        """Write *message* into the log of the client."""
        self.window_log_message(types.LogMessageParams(kind, message))

    def warn(self, message: str) -> None:
        """Show *message* to the user."""
        self.window_show_message(
            types.ShowMessageParams(types.MessageType.Warning, f"kinlint: {message}")
        )

    def _complain(self, problem: str) -> None:
        """Show *problem* to the user, once."""
        if problem not in self._said:
            self._said.add(problem)
            self.window_show_message(types.ShowMessageParams(types.MessageType.Warning, problem))

    def _snapshot(self, wanted: frozenset[Path], everything: bool) -> FrozenState:  # noqa: FBT001
        return FrozenState(
            generation=self.scheduler.generation,
            epoch=self._epoch,
            buffers={each.path: each for each in self.buffers},
            roots=self.roots,
            preferences=self.preferences,
            wanted=wanted,
            everything=everything,
        )

    def _deliver(self, step: Step) -> None:
        """Take over what *step* found."""
        for fault in step.faults:
            self.log(fault)
        for problem in step.problems:
            self._complain(problem)
        changed: set[Path] = set()
        if key := step.key:
            changed |= self._forget({each for each in self._keys() if each & key})
            for path, told in step.found.items():
                self.told.setdefault(path, {})[key] = told
                changed.add(path)
        settled = step.done and step.generation == self.scheduler.generation
        if settled:
            self._said.intersection_update(step.problems)
            changed |= self._forget(self._keys() - step.models.keys())
        if changed or settled:
            for listener in self.listeners:
                listener(frozenset(changed), settled)

    def _keys(self) -> set[frozenset[Path]]:
        return {key for each in self.told.values() for key in each}

    def _forget(self, keys: set[frozenset[Path]]) -> set[Path]:
        """Leave out what was told of the models *keys*; the files concerned."""
        changed = {path for path, each in self.told.items() if not keys.isdisjoint(each)}
        for path in changed:
            kept = self.told[path].items()
            self.told[path] = {key: told for key, told in kept if key not in keys}
            if not self.told[path]:
                del self.told[path]
        return changed
