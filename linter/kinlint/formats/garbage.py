"""Has readers make many small objects, of which none is freed, without a search for garbage."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


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
            if not gc.get_freeze_count():
                gc.freeze()
                gc.unfreeze()
            gc.enable()
