"""The exception by which the compiler leaves a constraint to the reference engine."""

from __future__ import annotations


class Deferred(Exception):
    """A constraint is valid, but cannot be compiled; the message says why."""
