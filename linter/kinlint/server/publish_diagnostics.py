"""Diagnostics that the server sends by itself, to clients that do not ask for them."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types

from kinlint.light_dataclasses import dataclass, field
from kinlint.server.app import KinlintServer
from kinlint.server.diagnostic_conversion import FileDiagnostics


def register(server: KinlintServer) -> None:
    """Send what changed."""
    server.listeners.append(Publisher(server).publish)


@dataclass
class Publisher:
    """Publishes the diagnostics of all files of the models of which one is open.

    What no longer holds is taken back.
    """

    server: KinlintServer
    """The server."""
    sent: dict[Path, tuple[str, str, int | None]] = field(default_factory=dict)
    """The last diagnostics of each file, with the version that they were for."""

    def publish(self, changed: frozenset[Path], settled: bool) -> None:  # noqa: FBT001
        """Send what is new of the files that *changed*.

        Once all is *settled*, also of those that are open, or were told of before.
        """
        rest = {*self.sent, *(each.path for each in self.server.buffers)} if settled else ()
        for path in sorted({*changed, *rest}):
            self._publish(path)

    def _publish(self, path: Path) -> None:
        buffers = self.server.buffers
        uri, buffer, told = buffers.uri(path), buffers.at_path(path), self._told(path)
        if buffer and told.source and told.source.text != buffer.source.text:
            return  # There is a newer text, which is being examined.
        version = None if buffer is None else buffer.version
        new = uri, told.result_id, version
        if self.sent.get(path) == new or not (told.items or buffer or path in self.sent):
            return
        self.sent[path] = new
        if not told.items and buffer is None:
            del self.sent[path]
        self.server.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(uri, list(told.items), version)
        )

    def _told(self, path: Path) -> FileDiagnostics:
        """Return the diagnostics to publish of the file at *path*."""
        models = self.server.told.get(path, {})
        open_ = (each.path in key for key in models for each in self.server.buffers)
        return self.server.diagnostics(path) if any(open_) else FileDiagnostics()
