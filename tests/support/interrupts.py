"""Interrupts of processes that tests begin."""

from __future__ import annotations

import signal


def accept_interrupts() -> None:
    """Let SIGINT end the process that calls this as it begins.

    A shell that runs the tests in the background has them, and what they begin, ignore it.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
