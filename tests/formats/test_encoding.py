"""Files are written in the encoding that they were read in, byte by byte, or not at all."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.edits import NotExpressible
from kinlint.errors import SourceError
from kinlint.formats.decoding import decode, encode

ENCODINGS = ["utf-8", "utf-8-sig", "utf-16", "latin-1", "cp1252", "koi8-r", "gb18030"]


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_xml_is_written_in_its_encoding(encoding: str) -> None:
    letter = "ж" if encoding == "koi8-r" else "é"
    declared = encoding.removesuffix("-sig")
    data = f'<?xml version="1.0" encoding="{declared}"?><robot name="{letter}"/>'.encode(encoding)
    source = decode("arm.urdf", data)
    assert letter in source.text
    assert encode(source) == data


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
def test_xml_without_a_mark_gets_none(encoding: str) -> None:
    data = '<robot name="µ"/>'.encode(encoding)
    assert encode(decode("arm.urdf", data)) == data


def test_json_keeps_its_mark() -> None:
    data = "\ufeff{}\r\n".encode()
    assert encode(decode("arm.jsonld", data)) == data


def test_bytes_that_are_none_of_the_encoding_cannot_be_written_back() -> None:
    with pytest.raises(NotExpressible, match="some bytes of the file are not in its encoding"):
        encode(decode("arm.urdf", b'<robot name="\xe9"/>'))


def test_characters_that_the_encoding_lacks_cannot_be_written() -> None:
    source = decode("arm.urdf", b'<?xml version="1.0" encoding="ascii"?><robot name="a"/>')
    with pytest.raises(NotExpressible, match=r"ASCII has no U\+00B5"):
        encode(replace(source, text=source.text.replace('"a"', '"µ"')))


HEADS = st.sampled_from(
    [b"", b"<", *(f'<?xml version="1.0" encoding="{name}"?>'.encode() for name in ENCODINGS),
     b"\xef\xbb\xbf<", b"\xff\xfe<\0", b"<\0", b'<?xml encoding="shift_jis"?>',
     b'<?xml encoding="hz"?>']
)  # fmt: skip


@given(HEADS, st.binary(max_size=40), st.sampled_from(["arm.urdf", "arm.jsonld"]))
def test_any_bytes_are_written_back_or_not_at_all(head: bytes, rest: bytes, name: str) -> None:
    try:
        source = decode(name, head + rest)
        data = encode(source)
    except (SourceError, NotExpressible):
        return
    assert data == head + rest
