"""Encoding of an XML file.

By its byte order mark, or else by its declaration (XML 1.0, appendix F).
"""

from __future__ import annotations

import codecs
import re

from kinlint.light_dataclasses import replace
from kinlint.text import SourceText, Span

MARKS = (
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
UNMARKED = (
    (b"<\0\0\0", "utf-32-le"),
    (b"\0\0\0<", "utf-32-be"),
    (b"<\0", "utf-16-le"),
    (b"\0<", "utf-16-be"),
)
DECLARED = re.compile(rb"<\?xml\s[^>]*?encoding\s*=\s*[\"']([^\"'>]*)[\"']")
HEAD = 1024

FAMILIES = re.compile(
    r"(?:utf-8|utf-8-sig|ascii|iso8859-\d+|cp\d+|koi8-[rut]|mac-\w+|gb2312|gbk|gb18030|big5|big5hkscs"
    r"|euc_(?:jp|kr|jis_2004|jisx0213)|shift_jis\w*|johab|tis-620|hz)"
)
"""Encodings whose ASCII characters are the bytes of ASCII, as Python calls them."""

FAITHFUL = frozenset({"utf-8", "ascii", *(encoding for _, encoding in MARKS)})
"""Encodings that have one way only to write a text."""

ESCAPED = re.compile("[\udc80-\udcff]+")
REPLACED = re.compile("\ufffd+")


def decode(name: str, data: bytes) -> SourceText:
    """Return the text of the XML file *name*.

    Bytes that are none of its encoding are read as Latin-1.
    """
    source = _decoded(name, data)
    return source if source.encoding else replace(source, original=data)


def _decoded(name: str, data: bytes) -> SourceText:
    for mark, encoding in MARKS:
        if data.startswith(mark):
            return _text(name, data[len(mark) :], encoding, (), marked=True)
    for head, encoding in UNMARKED:
        if data.startswith(head):
            return _text(name, data, encoding)
    match = DECLARED.search(data, 0, HEAD)
    if match is None:
        return _text(name, data, "utf-8")
    written = match[1].decode("ascii", "replace")
    encoding, reason = _known(written)
    if not reason:
        return _text(name, data, encoding)
    start = len(data[: match.start(1)].decode("utf-8", "replace"))
    return _text(name, data, "utf-8", ((Span(start, start + len(written)), reason),))


def _known(written: str) -> tuple[str, str]:
    """Return Python's name of an encoding, or UTF-8 and why it is not the one that is *written*."""
    try:
        found = codecs.lookup(written).name
    except (LookupError, ValueError):
        return "utf-8", f"the unknown encoding {written}"
    if found.startswith(("utf-16", "utf-32")):
        return "utf-8", f"the encoding {written}, which the file is not in"
    if not FAMILIES.fullmatch(found):
        return "utf-8", f"the unknown encoding {written}"
    return found, ""


def _text(
    name: str,
    data: bytes,
    encoding: str,
    misread: tuple[tuple[Span, str], ...] = (),
    *,
    marked: bool = False,
) -> SourceText:
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        utf8 = encoding == "utf-8"
        text = data.decode(encoding, "surrogateescape" if utf8 else "replace")
        strange = (ESCAPED if utf8 else REPLACED).search(text)
        if strange is not None:
            misread += ((Span(*strange.span()), f"bytes that are not {encoding.upper()}"),)
        text = text.translate(LATIN) if utf8 else text
        return SourceText(name, text, marked, misread, encoding="")
    back = encoding if encoding in FAITHFUL or text.encode(encoding) == data else ""
    return SourceText(name, text, marked, misread, encoding=back)


LATIN = {code: bytes([code - 0xDC00]).decode("cp1252", "replace") for code in range(0xDC80, 0xDD00)}
"""Characters that bytes outside UTF-8 are taken for."""
