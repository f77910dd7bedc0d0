"""What the server can do, each in a module with a `register`."""

from __future__ import annotations

from importlib import import_module

from kinlint.server.app import KinlintServer

FEATURES = (
    "kinlint.server.lifecycle",
    "kinlint.server.synchronisation",
    "kinlint.server.actions",
    "kinlint.server.commands",
    "kinlint.server.hover",
    "kinlint.server.references",
    "kinlint.server.outline",
    "kinlint.server.links",
    "kinlint.server.lenses",
)
"""Modules whose `register(server)` adds what they have."""


def made() -> KinlintServer:
    """A server with all features."""
    server = KinlintServer()
    for name in FEATURES:
        import_module(name).register(server)
    return server
