"""An immutable copy of the client's state, for the worker thread."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from kinlint.light_dataclasses import dataclass
from kinlint.server.buffers import Buffer
from kinlint.server.client_settings import ClientSettings


@dataclass(frozen=True)
class FrozenState:
    """An immutable snapshot of open texts, folders and settings."""

    generation: int
    """Number of changes so far."""
    epoch: int
    """Number of changes that may concern files on disk."""
    buffers: Mapping[Path, Buffer]
    """The open texts by their paths, the one that changed last first."""
    roots: tuple[Path, ...]
    """The folders of the workspace."""
    preferences: ClientSettings
    """The settings of the client."""
    wanted: frozenset[Path] = frozenset()
    """Files that a request waits for, open or not."""
    everything: bool = False
    """True if a request waits for all files."""

    def root_of(self, path: Path) -> Path | None:
        """The innermost folder of the workspace that *path* lies in."""
        within = [root for root in self.roots if path.is_relative_to(root)]
        return max(within, key=lambda root: len(root.parts), default=None)
