"""Keeps the garbage collector from many small objects of which none is garbage."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
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


@contextmanager
def collected_often() -> Iterator[Callable[[], None]]:
    """Give a function that collects garbage.

    What its first call leaves, such as rules and modules, is not looked at again within the block.
    """
    frozen = _frozen

    def collect() -> None:
        if _frozen:
            gc.collect()
        else:
            freeze()

    try:
        yield collect
    finally:
        if not frozen:
            unfreeze()


def freeze() -> None:
    """Collect garbage now, and look at nothing that is left until `unfreeze`."""
    global _frozen  # noqa: PLW0603  a process has one heap
    gc.unfreeze()
    gc.collect()
    gc.freeze()
    _frozen = True


def unfreeze() -> None:
    """Have the garbage collector look at all objects again."""
    global _frozen  # noqa: PLW0603  see above
    gc.unfreeze()
    _frozen = False
