"""Turns the bytes of a file into text and back: UTF-8, or what an XML file says that it is."""

from __future__ import annotations

import codecs
from importlib import import_module

from kinlint.edits import NotExpressible
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.formats.recognition import with_format
from kinlint.formats.records import FORMATS, JSON, by_suffix
from kinlint.text import SourceText

_MARKS = (
    (codecs.BOM_UTF32_LE, "UTF-32"),
    (codecs.BOM_UTF32_BE, "UTF-32"),
    (codecs.BOM_UTF16_LE, "UTF-16"),
    (codecs.BOM_UTF16_BE, "UTF-16"),
)
BOM = "\ufeff"
_NO_XML = (JSON, *(suffix for each in FORMATS if each.fence != "xml" for suffix in each.suffixes))
_HEAD = 1024


def decode(name: str, data: bytes) -> SourceText:
    """Return the text of the file *name*, with its format if that is known.

    Raises SourceError that says what was found, and where, if *data* is no text: XML in the
    encoding that it declares, anything else in UTF-8.
    """
    form = by_suffix(name)
    if form is not None and form.decoder is not None and _is_packed(form, name, data):
        made: SourceText = import_module(form.decoder).decode(name, data)
        return made
    if not name.lower().endswith(_NO_XML) and _looks_like_xml(data[:_HEAD]):
        from kinlint.formats.xml import encoding  # noqa: PLC0415  few files are XML

        return with_format(encoding.decode(name, data))
    for mark, named in _MARKS:
        if data.startswith(mark):
            raise SourceError(name, f"the file is {named}; kinlint reads UTF-8", 1, 1)
    marked = data.startswith(codecs.BOM_UTF8)
    content = data[len(codecs.BOM_UTF8) :] if marked else data
    if marked and content.startswith(codecs.BOM_UTF8):
        raise SourceError(name, "the file begins with two byte order marks", 1, 1)
    zero = content.find(b"\0")
    if zero >= 0:
        guess = _guess(content)
        cause = f"the file seems to be {guess}" if guess else "a NUL byte: this is not a text file"
        raise SourceError(name, cause, *_place(content, zero))
    try:
        return with_format(SourceText(name, content.decode("utf-8"), marked))
    except UnicodeDecodeError as error:
        byte = content[error.start]
        cause = f"not UTF-8: byte 0x{byte:02X} ({error.reason}); is it Latin-1?"
        raise SourceError(name, cause, *_place(content, error.start)) from None


def encode(source: SourceText) -> bytes:
    """Return the bytes of a file that is read as *source*.

    Raises Unsayable where there are none: a character is not in its encoding, or the text was put
    together from bytes that were not.
    """
    if not source.encoding:
        raise NotExpressible("some bytes of the file are not in its encoding")
    text = f"{BOM}{source.text}" if source.bom else source.text
    try:
        return text.encode(source.encoding)
    except UnicodeEncodeError as error:
        strange = f"U+{ord(text[error.start]):04X}"
        raise NotExpressible(f"{source.encoding.upper()} has no {strange}") from None


def _is_packed(form: Format, name: str, data: bytes) -> bool:
    """Tell whether *data* of the file *name* is no text, by what files of *form* are like."""
    return name.lower().endswith(form.archive_suffixes) or data.startswith(form.signatures)


def _looks_like_xml(head: bytes) -> bool:
    """Tell whether a text in any encoding begins with a tag."""
    while head.startswith(codecs.BOM_UTF8):
        head = head.removeprefix(codecs.BOM_UTF8)
    plain = head.replace(b"\0", b"")
    for mark, _ in _MARKS:
        plain = plain.removeprefix(mark.replace(b"\0", b""))
    return plain.lstrip()[:1] == b"<"


def _guess(content: bytes) -> str | None:
    """Return the likely encoding of *content* with zeros.

    UTF-16 without a mark has a zero in nearly every other byte of plain text.
    """
    head = content[:64]
    for parity, order in ((1, "little"), (0, "big")):
        if len(head) > 1 and all(byte == 0 for byte in head[parity::2]) and any(head):
            return f"UTF-16 ({order} endian); kinlint reads UTF-8"
    return None


def _place(content: bytes, at: int) -> tuple[int, int]:
    """Return line and column of a byte, all before which is UTF-8."""
    before = content[:at].decode("utf-8", "replace")
    position = SourceText("", before).position(len(before))
    return position.line, position.column
