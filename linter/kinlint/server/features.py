"""The features of the server; each is a module with a `register` function."""

from __future__ import annotations

from importlib import import_module

from kinlint.server.app import KinlintServer

FEATURES = (
    "kinlint.server.lifecycle",
    "kinlint.server.text_sync",
    "kinlint.server.code_actions",
    "kinlint.server.workspace_commands",
    "kinlint.server.hover_request",
    "kinlint.server.completion_request",
    "kinlint.server.rename_request",
    "kinlint.server.find_references",
    "kinlint.server.document_symbols",
    "kinlint.server.workspace_symbols",
    "kinlint.server.text_ranges",
    "kinlint.server.inlay_hint_request",
    "kinlint.server.document_links",
    "kinlint.server.code_lens",
)
"""Modules whose `register(server)` adds what they have."""


def create_server() -> KinlintServer:
    """A server with all features."""
    server = KinlintServer()
    for name in FEATURES:
        import_module(name).register(server)
    return server
