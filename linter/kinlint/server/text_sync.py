"""Keeps the texts of the client as it changes them."""

from __future__ import annotations

from lsprotocol import types

from kinlint.server.app import KinlintServer
from kinlint.server.buffers import Buffer


def register(server: KinlintServer) -> None:
    """Follow what the client opens, writes, saves and closes."""

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(params: types.DidOpenTextDocumentParams) -> None:
        text = params.text_document
        server.buffers.put(Buffer.from_text(text.uri, text.version, text.text))
        server.changed(text.uri, disk=True)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(params: types.DidChangeTextDocumentParams) -> None:
        text = params.text_document
        if (buffer := server.buffers.get(text.uri)) is not None:
            changes = params.content_changes
            server.buffers.put(buffer.changed(changes, text.version, server.encoding))
            server.changed(text.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(params: types.DidSaveTextDocumentParams) -> None:
        if (buffer := server.buffers.get(params.text_document.uri)) is not None:
            server.buffers.put(buffer.as_saved())
        server.changed(params.text_document.uri, disk=True)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: types.DidCloseTextDocumentParams) -> None:
        server.buffers.close(params.text_document.uri)
        server.changed(disk=True)
