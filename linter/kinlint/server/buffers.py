"""The texts that are open in the client, as it has them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from urllib.parse import unquote

from lsprotocol.types import (
    TextDocumentContentChangePartial,
    TextDocumentContentChangeWholeDocument,
)

from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.formats.recognition import with_text
from kinlint.light_dataclasses import dataclass, replace
from kinlint.server.position_codec import MARK, PositionCodec
from kinlint.text import SourceText
from kinlint.uri_references import split_uri

Change = TextDocumentContentChangePartial | TextDocumentContentChangeWholeDocument


@dataclass(frozen=True)
class Buffer:
    """An open text, never changed: each change makes another."""

    uri: str
    """The URI that the client uses."""
    path: Path
    """The file; for a text that is no file, a path of the same name in the working directory."""
    version: int
    """The version that the client numbers."""
    source: SourceText
    """The text without a byte order mark."""
    marked: bool = False
    """True if the client has the byte order mark in the text."""
    saved: bool = True
    """True if the file holds the same text."""

    @classmethod
    def from_text(cls, uri: str, version: int, text: str) -> Buffer:
        """The text that a client opens as *uri*."""
        path = path_of(uri)
        return (
            cls(uri, path, version, SourceText(shown(path), "", named=False))
            .written(text, version)
            .as_saved()
        )

    def written(self, text: str, version: int) -> Buffer:
        """The same file with another *text*."""
        marked = text.startswith(MARK)
        source = with_text(self.source, text[marked:], bom=marked)
        return replace(self, version=version, source=source, marked=marked, saved=False)

    def as_saved(self) -> Buffer:
        """The same text, now that the file holds it."""
        return replace(self, saved=True)

    @property
    def text(self) -> str:
        """Return the text as the client has it, byte order mark included."""
        return MARK * self.marked + self.source.text

    def changed(self, changes: Iterable[Change], version: int, encoding: str) -> Buffer:
        """The buffer after *changes*, which are made one after the other."""
        buffer = self
        for change in changes:
            text = change.text
            if isinstance(change, TextDocumentContentChangePartial):
                whole = SourceText("", buffer.text) if buffer.marked else buffer.source
                start, end = PositionCodec(whole, encoding).span(change.range)
                text = whole.text[:start] + text + whole.text[end:]
            buffer = buffer.written(text, version)
        return buffer


class Buffers:
    """The open texts by the URIs of the client, which may spell one path in several ways."""

    def __init__(self) -> None:
        self._by_path: dict[Path, Buffer] = {}

    def __iter__(self) -> Iterator[Buffer]:
        return iter(self._by_path.values())

    def put(self, buffer: Buffer) -> None:
        """Take *buffer* for what its file holds; it comes first from now on."""
        self._by_path.pop(buffer.path, None)
        self._by_path = {buffer.path: buffer, **self._by_path}

    def close(self, uri: str) -> None:
        """The client no longer has *uri*: its file counts."""
        self._by_path.pop(path_of(uri), None)

    def get(self, uri: str) -> Buffer | None:
        """Return the buffer that is open as *uri*, or None."""
        return self._by_path.get(path_of(uri))

    def at_path(self, path: Path) -> Buffer | None:
        """Return the buffer that is open of the file at *path*, or None."""
        return self._by_path.get(path)

    def uri(self, path: Path) -> str:
        """Return the URI by which the client knows the file at *path*."""
        open_ = self._by_path.get(path)
        return uri_of(path) if open_ is None else open_.uri


def path_of(uri: str) -> Path:
    """The file of *uri*; of what is no file, such as a text without a name, one that is not."""
    parts = split_uri(uri)
    path = unquote(parts.path, errors="surrogateescape")
    if parts.scheme != "file":
        return absolute(path.strip("/").replace("/", "_") or "untitled")
    if os.name == "nt":
        path = path.removeprefix("/") if path[2:3] == ":" else path
    return absolute(f"//{parts.netloc}{path}" if parts.netloc else path)


def uri_of(path: Path) -> str:
    """The URI of the file at *path*."""
    return path.as_uri()
