"""Files in UTF-8 and in other encodings."""

from __future__ import annotations

import codecs

import pytest
from reading_xml import flaws, graph, model

TEXT = "<?xml version='1.0' encoding='{}'?>\n<robot name='Grün'><link name='b'/></robot>"


@pytest.mark.parametrize(
    ("declared", "encoding"),
    [
        ("UTF-8", "utf-8"),
        ("utf-8", "utf-8-sig"),
        ("UTF-16", "utf-16"),
        ("UTF-16LE", "utf-16-le"),
        ("UTF-16BE", "utf-16-be"),
        ("UTF-32", "utf-32"),
        ("ISO-8859-1", "latin-1"),
        ("iso-8859-15", "iso-8859-15"),
        ("windows-1252", "cp1252"),
        ("windows-1250", "cp1250"),
        ("GB18030", "gb18030"),
    ],
)
def test_a_file_is_read_in_the_encoding_that_it_declares(declared: str, encoding: str) -> None:
    text = TEXT.format(declared)
    arm = model(text.encode(encoding))
    assert arm.source.text == text
    assert arm.source.bom == (encoding in ("utf-8-sig", "utf-16", "utf-32"))
    assert ("#", "@name", "Grün") in graph(arm)
    assert flaws(arm) == []
    spans = [arm.source[arm.map.triples[t]] for t in arm.statements if t[2] in ('"Grün"', '"b"')]
    assert spans == ["Grün", "b"]


def test_a_mark_weighs_more_than_a_declaration() -> None:
    arm = model(codecs.BOM_UTF8 + TEXT.format("ISO-8859-1").encode())
    assert ("#", "@name", "Grün") in graph(arm)


@pytest.mark.parametrize("declared", ["utf8x", "UTF-16", "rot13", "unicode_escape", "zip"])
def test_an_encoding_that_cannot_be_is_told_and_utf_8_is_read(declared: str) -> None:
    arm = model(TEXT.format(declared).encode())
    assert ("#", "@name", "Grün") in graph(arm)
    place, reason = flaws(arm)[0]
    assert place == declared
    assert "encoding" in reason


def test_bytes_that_are_not_utf_8_are_told_and_read_as_latin_1() -> None:
    text = "<robot name='Grün \N{EN DASH} ü'><link name='b'/></robot>"
    arm = model(text.encode("cp1252"))
    assert arm.source.text == text
    assert flaws(arm) == [("ü", "bytes that are not UTF-8")]


def test_half_a_character_is_told() -> None:
    arm = model("<robot name='a'/>\n".encode("utf-16") + b"x")
    assert ("bytes that are not UTF-16-LE") in [reason for _, reason in flaws(arm)]
