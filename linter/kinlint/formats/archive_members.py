"""Opens archives of which nothing is unpacked to disk; what no robot's archive is, is refused."""

from __future__ import annotations

import io
from posixpath import normpath
from zipfile import ZipFile

from kinlint.errors import SourceError

MOST_MEMBERS = 10_000
_LISTED = b"PK\x01\x02"
"""Beginning of what the directory of an archive says of one member."""


def opened(name: str, data: bytes) -> ZipFile:
    """Return the archive *data*, the file *name*.

    Raises SourceError for one with more members than `MOST_MEMBERS`, or with one that leads out of
    it, and what zipfile raises for one that is broken.
    """
    if data.count(_LISTED) > MOST_MEMBERS:
        raise SourceError(name, f"the archive has more than {MOST_MEMBERS} files", 1, 1)
    archive = ZipFile(io.BytesIO(data))
    for each in archive.namelist():
        if leads_out(each):
            raise SourceError(name, f"the member {each!r} leads out of the archive", 1, 1)
    return archive


def leads_out(path: str) -> bool:
    """Tell whether what unpacks *path* in a folder may write beside the folder."""
    plain = normpath(path.replace("\\", "/"))
    return plain.startswith(("/", "../")) or plain == ".." or ":" in plain
