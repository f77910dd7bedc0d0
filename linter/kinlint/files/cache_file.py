"""Files that one run keeps for the next, which are whole or not there."""

from __future__ import annotations

import os
from pathlib import Path

UNDONE = ".tmp"
"""Suffix of a file that is being written; it begins like the file that it becomes."""


def write_cache_file(path: Path, data: bytes) -> None:
    """Write *data* to the file at *path*, and make its directory, for this user alone, if need be.

    Other processes find the file as it was before or as it is afterwards. Raises OSError.
    """
    import tempfile  # noqa: PLC0415  slow to import, and a run that finds all it needs writes nothing

    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    beginning = path.name.partition("-")[0].partition(".")[0]
    handle, name = tempfile.mkstemp(UNDONE, f"{beginning}-", path.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
