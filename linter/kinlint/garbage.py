"""Keeps the garbage collector from many small objects of which none is garbage."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

_frozen = False
"""True if objects are frozen for good. To ask the interpreter means to count them."""


@contextmanager
def uncollected() -> Iterator[None]:
    """Suspend garbage collection.

    What was made meanwhile is not looked at afterwards, but counts as old: it is as good as never
    garbage. To freeze and unfreeze all objects does that, unless some are frozen for good.
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            if not _frozen:
                gc.freeze()
                gc.unfreeze()
            gc.enable()


def freeze() -> None:
    """Collect garbage now, and look at nothing that is left until `unfreeze`."""
    global _frozen  # noqa: PLW0603  a process has one heap
    gc.unfreeze()
    gc.collect()
    gc.freeze()
    _frozen = True


def pass_over() -> None:
    """Look at nothing that there is now until `unfreeze`: it stays, or is no large part of all."""
    global _frozen  # noqa: PLW0603  see above
    gc.freeze()
    _frozen = True


@contextmanager
def only_new() -> Iterator[None]:
    """Have collections look only at what is made meanwhile."""
    frozen = _frozen
    if not frozen:
        pass_over()
    try:
        yield
    finally:
        if not frozen:
            unfreeze()


def unfreeze() -> None:
    """Have the garbage collector look at all objects again."""
    global _frozen  # noqa: PLW0603  see above
    gc.unfreeze()
    _frozen = False
