"""Keeps what is known of the workspace up to date: what changed last first, and nothing in vain."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from functools import partial
from pathlib import Path
from traceback import format_exc

from kinlint.light_dataclasses import dataclass, field
from kinlint.server.frozen_state import FrozenState
from kinlint.server.worker import Worker
from kinlint.server.workspace import Step, Workspace

BACKGROUND = 1
"""Urgency of background analyses, below that of requests (0)."""


@dataclass
class Scheduler:
    """Examines as long as something changed.

    A change interrupts the step that is being made: what it would find is of no interest any
    more.
    """

    library: Workspace
    """The models and their rules."""
    worker: Worker
    """The thread that examines."""
    snapshot: Callable[[frozenset[Path], bool], FrozenState]
    """Returns the state of now."""
    deliver: Callable[[Step], None]
    """Takes each step."""
    generation: int = 0
    """Number of the newest change."""
    _waiting: dict[asyncio.Future[None], Path | None] = field(default_factory=dict)
    _task: asyncio.Task[None] | None = None
    _stopped: bool = False

    def change(self, *, now: bool = True) -> None:
        """Something changed: what is under way is for nothing. Examine what is there *now*."""
        self.generation += 1
        if now or self._waiting:
            self._go()

    def stop(self) -> None:
        """Do nothing more."""
        self._stopped = True
        self.generation += 1
        for each in self._waiting:
            each.cancel()

    async def wait_until_settled(self, path: Path | None) -> None:
        """Come back when all that is to know of the file at *path* is known; None is of all files.

        What changes meanwhile is waited for, too.
        """
        future = asyncio.get_running_loop().create_future()
        self._waiting[future] = path
        try:
            self._go()
            await future
        finally:
            self._waiting.pop(future, None)

    def _go(self) -> None:
        if (self._task is None or self._task.done()) and not self._stopped:
            self._task = asyncio.ensure_future(self._examine())

    async def _examine(self) -> None:
        while not self._stopped:
            generation = self.generation
            asked = set(self._waiting.values())
            wanted = frozenset(path for path in asked if path is not None)
            snapshot = self.snapshot(wanted, None in asked)
            job = partial(self.library.step, snapshot, self.interruption())
            try:
                step = await self.worker.run(job, urgency=BACKGROUND)
                self.deliver(step)
            except Exception:  # noqa: BLE001  whatever it is, nobody shall wait for ever
                self.deliver(Step(generation, faults=[format_exc()]))
                step = Step(generation, done=True)
            if generation == self.generation:
                self._answer(step)
                if step.done and asked >= set(self._waiting.values()):
                    return

    def interruption(self) -> Callable[[], bool]:
        """Return a function that tells whether anything has changed since this call."""
        generation = self.generation
        return lambda: self.generation != generation

    def _answer(self, step: Step) -> None:
        known = frozenset[Path]().union(*step.models)
        for future, path in list(self._waiting.items()):
            done = step.done if path is None else path in step.fresh or path not in known
            if done and not future.done():
                future.set_result(None)
                del self._waiting[future]
