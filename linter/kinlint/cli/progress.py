"""A bar for people who wait for a run at a terminal: it comes late, and goes before the report."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Self, TypeVar

from kinlint.reporters.terminal_style import When, detect_style

if TYPE_CHECKING:
    from rich.progress import Progress

T = TypeVar("T")
PATIENCE = 1.0
"""After how many seconds somebody may wonder how long it takes."""


class ProgressBar:
    """Counts the files that are read and linted; shown, if at all, on standard error."""

    def __init__(
        self, files: int, *, wanted: bool, color: When = "auto", title: str = "Linting"
    ) -> None:
        self._steps = 2 * files
        self._title = title
        self._color = color
        self._wanted = wanted and sys.stderr.isatty()
        self._done = 0
        self._began = time.monotonic()
        self._shown: Progress | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._shown is not None:
            self._shown.stop()

    def reading(self, inputs: Iterable[T]) -> Iterator[T]:
        """*inputs*, each counted as read when the next is asked for."""
        for one in inputs:
            yield one
            self.advance(1)

    def advance(self, files: int, title: str = "") -> None:
        """Count *files* as read, or linted; from now on with *title*, if any."""
        if not self._wanted:
            return
        self._done += files
        self._title = title or self._title
        if self._shown is None and time.monotonic() - self._began >= PATIENCE:
            self._show()
        if self._shown is not None:
            task = self._shown.task_ids[0]
            self._shown.update(task, completed=self._done, description=self._title)

    def step_aside(self, tell: Callable[[T], None], findings: T) -> None:
        """Tell *findings* while nothing is shown."""
        shown = self._shown
        if shown is not None:
            shown.stop()
        tell(findings)
        if shown is not None:
            shown.start()

    def _show(self) -> None:
        from rich.console import Console  # noqa: PLC0415  slow to import, and most runs are short
        from rich.progress import (  # noqa: PLC0415
            BarColumn,
            Progress,
            TaskProgressColumn,
            TextColumn,
            TimeRemainingColumn,
        )

        colored = detect_style(sys.stderr, self._color).color
        console = Console(
            stderr=True, color_system="auto" if colored else None, no_color=not colored
        )
        if console.is_dumb_terminal:
            self._wanted = False
            return
        columns = (
            TextColumn("{task.description}"),
            BarColumn(),
            TaskProgressColumn(),
            TimeRemainingColumn(),
        )
        self._shown = Progress(*columns, console=console, transient=True)
        self._shown.add_task(self._title, total=self._steps, completed=self._done)
        self._shown.start()
