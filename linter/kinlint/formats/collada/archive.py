"""Unpacks COLLADA archives: zip files with a manifest that names the document (COLLADA 1.5, ch. 2).

Nothing is written, and no more is unpacked than a document may have.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from posixpath import normpath
from urllib.parse import unquote

from kinlint.errors import SourceError
from kinlint.formats.archive_members import leads_out, opened
from kinlint.formats.recognition import with_format
from kinlint.formats.xml import encoding
from kinlint.light_dataclasses import replace
from kinlint.text import SourceText

MANIFEST = "manifest.xml"
LARGEST_MANIFEST = 1 << 16
LARGEST_DOCUMENT = 1 << 26
"""Most bytes of the document: archives may unpack to any size."""
_ROOT = re.compile(rb"<(?:[\w.-]+:)?dae_root\b[^<>]*>([^<]*)<")


def decode(name: str, data: bytes) -> SourceText:
    """Return the text of the document in the archive *name*, which cannot be written back.

    Raises SourceError that says why there is none, or why it is no text.
    """
    path, content = _unpacked(name, data)
    try:
        source = encoding.decode(name, content)
    except SourceError as error:
        raise SourceError(name, f"{path}: {error.cause}", error.line, error.column) from None
    return with_format(replace(source, encoding="", original=data))


def _unpacked(name: str, data: bytes) -> tuple[str, bytes]:
    """Return the path and the bytes of the document in the archive *data*, the file *name*.

    That is what the manifest names, or the only one that there is. Raises SourceError that says
    why there is none.
    """
    try:
        with opened(name, data) as archive:
            members = {each.filename: each for each in archive.infolist()}
            path = _document(name, archive, members)
            return path, _content(name, archive, members[path], LARGEST_DOCUMENT)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError) as error:
        raise SourceError(name, f"not a readable zip archive: {error}", 1, 1) from None
    except (RuntimeError, NotImplementedError) as error:
        raise SourceError(name, f"the archive cannot be unpacked: {error}", 1, 1) from None


def _document(name: str, archive: zipfile.ZipFile, members: dict[str, zipfile.ZipInfo]) -> str:
    """Return the path of the document in *archive*."""
    if MANIFEST in members:
        manifest = _content(name, archive, members[MANIFEST], LARGEST_MANIFEST)
        found = _ROOT.search(manifest)
        if found is None:
            raise SourceError(name, f"{MANIFEST} has no <dae_root>", 1, 1)
        written = found[1].decode("utf-8", "replace").strip()
        path = normpath(unquote(written.partition("#")[0]))
        if leads_out(path):
            raise SourceError(name, f"{MANIFEST} leads out of the archive: '{written}'", 1, 1)
        if path not in members:
            raise SourceError(name, f"{MANIFEST} names '{written}', which is not there", 1, 1)
        return path
    documents = [each for each in members if each.lower().endswith(".dae")]
    if len(documents) != 1:
        count = f"{len(documents)} documents" if documents else "no document"
        raise SourceError(name, f"the archive has no {MANIFEST}, and {count} (.dae)", 1, 1)
    return documents[0]


def _content(name: str, archive: zipfile.ZipFile, member: zipfile.ZipInfo, limit: int) -> bytes:
    """Return the bytes of *member*, whatever size the archive says that it has."""
    with archive.open(member) as stream:
        content = stream.read(limit + 1)
    if len(content) > limit:
        cause = f"'{member.filename}' unpacks to more than {limit >> 10} KiB"
        raise SourceError(name, cause, 1, 1)
    return content
