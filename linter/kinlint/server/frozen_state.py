"""An immutable copy of the client's state, for the worker thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from kinlint.server.buffers import Buffer
from kinlint.server.client_settings import ClientSettings


@dataclass(frozen=True)
class FrozenState:
    """The state that the `generation`-th change led to.

    `epoch` counts the changes that files on disk may have something to do with. `buffers` are the
    open texts by their paths, the one that changed last first. `roots` are the folders of the
    workspace. `wanted` are files that somebody waits for, open or not; `everything` tells that all
    are.
    """

    generation: int
    epoch: int
    buffers: Mapping[Path, Buffer]
    roots: tuple[Path, ...]
    preferences: ClientSettings
    wanted: frozenset[Path] = frozenset()
    everything: bool = False

    def root_of(self, path: Path) -> Path | None:
        """The innermost folder of the workspace that *path* lies in."""
        within = [root for root in self.roots if path.is_relative_to(root)]
        return max(within, key=lambda root: len(root.parts), default=None)
