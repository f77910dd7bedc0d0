"""Turns binary layers (crates) and packages of USD into the text of their root layer.

Crates are decoded by usd-core, in a process of its own: what is wrong with one ends that alone.
Packages are zip archives of files that are stored as they are; nothing is unpacked to disk.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import zipfile
from importlib.util import find_spec
from pathlib import Path

from kinlint.errors import SourceError
from kinlint.formats.archive_members import opened
from kinlint.formats.decoding import decode as decoded
from kinlint.formats.usd.format import CRATE, NEEDED, PACKAGE, USD
from kinlint.text import SourceText

LARGEST = 1 << 26
"""Most bytes of a crate, and of a member of a package."""
MOST_TEXT = 1 << 28
"""Most bytes of text that a crate may come to."""
SECONDS = 30
"""Time that decoding may take."""
_SCRIPT = """
import sys
from pxr import Sdf
layer = Sdf.Layer.OpenAsAnonymous(sys.argv[1])
with open(sys.argv[2], "w", encoding="utf-8", newline="") as out:
    out.write(layer.ExportToString())
"""


def decode(name: str, data: bytes) -> SourceText:
    """Return the text of the crate or package *name*; places count in this.

    Raises SourceError where it cannot be read, or usd-core is needed and not installed.
    """
    if not data.startswith(PACKAGE):
        return SourceText(name, _crate_text(name, data), encoding="", original=data, format=USD)
    with _archive(name, data) as archive:
        first = archive.infolist()[0].filename
        return _member(name, archive, first, data)


def member(name: str, data: bytes, path: str) -> SourceText | None:
    """Return the text of the layer at *path* in the package *name*; None if there is none.

    Raises SourceError where it cannot be read.
    """
    with _archive(name, data) as archive:
        return (
            _member(f"{name}[{path}]", archive, path, data) if path in archive.NameToInfo else None
        )


def _archive(name: str, data: bytes) -> zipfile.ZipFile:
    try:
        archive = opened(name, data)
    except (zipfile.BadZipFile, ValueError, NotImplementedError) as error:
        raise SourceError(name, f"not a package of USD: {error}", 1, 1) from None
    if not archive.infolist():
        raise SourceError(name, "a package of 0 files", 1, 1)
    return archive


def _member(name: str, archive: zipfile.ZipFile, path: str, original: bytes) -> SourceText:
    info = archive.NameToInfo[path]
    if info.compress_type != zipfile.ZIP_STORED or info.flag_bits & 1:
        raise SourceError(name, f"{path} is compressed, which packages of USD are not", 1, 1)
    if info.file_size > LARGEST:
        raise SourceError(name, f"{path} has more than {LARGEST} bytes", 1, 1)
    try:
        data = archive.read(info)
    except (zipfile.BadZipFile, ValueError, EOFError, OSError) as error:
        raise SourceError(name, f"{path} cannot be read: {error}", 1, 1) from None
    if data.startswith(CRATE):
        text = _crate_text(name, data)
    else:
        try:
            text = decoded("layer.usda", data).text
        except SourceError as error:
            cause = f"{path}: {error.cause}"
            raise SourceError(name, cause, error.line, error.column) from None
    return SourceText(name, text, encoding="", original=original, format=USD)


def _crate_text(name: str, data: bytes) -> str:
    if not data.startswith(CRATE):
        raise SourceError(name, "neither a text layer of USD nor a crate", 1, 1)
    if find_spec("pxr") is None:
        raise SourceError(name, NEEDED, 1, 1)
    if len(data) > LARGEST:
        raise SourceError(name, f"a crate of more than {LARGEST} bytes", 1, 1)
    with tempfile.TemporaryDirectory(prefix="kinlint-") as folder:
        source, target = Path(folder, "layer.usdc"), Path(folder, "layer.usda")
        source.write_bytes(data)
        words = [sys.executable, "-I", "-c", _SCRIPT, str(source), str(target)]
        try:
            subprocess.run(words, check=True, capture_output=True, timeout=SECONDS)  # noqa: S603  own words
        except subprocess.TimeoutExpired:
            raise SourceError(name, f"usd-core takes over {SECONDS} s to read it", 1, 1) from None
        except subprocess.CalledProcessError:
            raise SourceError(name, "usd-core cannot read this crate", 1, 1) from None
        if target.stat().st_size > MOST_TEXT:
            raise SourceError(name, f"it comes to more than {MOST_TEXT} bytes of text", 1, 1)
        return target.read_text("utf-8")
