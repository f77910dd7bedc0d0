"""Starts the server on standard input and output, or on a port."""

from __future__ import annotations

import os
import sys

from kinlint.server.app import KinlintServer
from kinlint.server.features import create_server

HOST = "127.0.0.1"
PATIENCE = 5.0
"""Seconds that the running job may take to notice that it is cancelled."""


def on_standard_streams() -> int:
    """Serve one client until it leaves; nothing else is written to standard output."""
    sys.stdout.flush()
    protocol = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    server = create_server()
    server.start_io(sys.stdin.buffer, protocol)
    return _ended(server)


def on_port(port: int) -> int:
    """Serve one client at *port* of this machine, to look at what is said."""
    server = create_server()
    server.start_tcp(HOST, port)
    return _ended(server)


def _ended(server: KinlintServer) -> int:
    """The exit code: 0 if the client said that it was going to leave, else 1."""
    server.shut_down(asked=False)
    code = int(not server.dismissed)
    if not server.worker.stop(PATIENCE):
        os._exit(code)  # What is being done would break when the interpreter goes.
    return code
