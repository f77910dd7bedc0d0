"""The protocol, but that it leaves the texts of the client to the server, and answers all requests.

The documents of pygls end lines at characters that the protocol does not take for line ends, such
as U+2028, and walk a line character by character; so texts are kept in `Buffers` instead.
Requests that make no sense, or come after the last one, get no answer from pygls, so that a client
would wait for ever.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException, JsonRpcInvalidRequest
from pygls.protocol import LanguageServerProtocol, lsp_method

Steps = Generator[Any, Any, None]


class Protocol(LanguageServerProtocol):
    """Hands what happens to texts to the features of that name, and keeps nothing itself."""

    def structure_message(self, data: dict[str, Any]) -> Any:
        """Parse *data*. Raises `JsonRpcException`, after answering a request with that error."""
        try:
            return super().structure_message(data)
        except JsonRpcException as error:
            if "id" in data and "method" in data:
                self._send_response(data["id"], error=error.to_response_error())
            raise

    def handle_message(self, message: Any) -> None:
        """Do what *message* says, unless it asks for something after it asked for the end."""
        if self._shutdown and hasattr(message, "id") and hasattr(message, "method"):
            late = JsonRpcInvalidRequest("the server was told to shut down")
            self._send_response(message.id, error=late.to_response_error())
        else:
            super().handle_message(message)

    @lsp_method(types.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: types.DidOpenTextDocumentParams) -> Steps:
        """A text was opened."""
        yield self.fm.features[types.TEXT_DOCUMENT_DID_OPEN], (params,), None

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> Steps:
        """A text was changed."""
        yield self.fm.features[types.TEXT_DOCUMENT_DID_CHANGE], (params,), None

    @lsp_method(types.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: types.DidCloseTextDocumentParams) -> Steps:
        """A text was closed."""
        yield self.fm.features[types.TEXT_DOCUMENT_DID_CLOSE], (params,), None
