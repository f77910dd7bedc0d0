"""Paths in archives: those that lead out of an archive are refused, though nothing is unpacked."""

from __future__ import annotations

from posixpath import normpath
from zipfile import ZipFile

from kinlint.errors import SourceError


def leads_out(path: str) -> bool:
    """Tell whether what unpacks *path* in a folder may write beside the folder."""
    plain = normpath(path.replace("\\", "/"))
    return plain.startswith(("/", "../")) or plain == ".." or ":" in plain


def refuse_members_outside(name: str, archive: ZipFile) -> None:
    """Raise SourceError if a member of the *archive*, the file *name*, leads out of it."""
    for each in archive.namelist():
        if leads_out(each):
            raise SourceError(name, f"the member {each!r} leads out of the archive", 1, 1)
