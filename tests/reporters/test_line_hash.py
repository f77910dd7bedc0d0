from __future__ import annotations

import pytest
from hypothesis import given
from reported import texts

from kinlint.reporters.sarif.line_hash import LineHashes
from kinlint.text import SourceText


def rolled(text: str) -> dict[int, str]:
    """The hashes of all lines by the rolling window that codeql-action describes.

    Units are read one by one; a line's hash is told when the window has come round to the place
    where the line began, or when the text is over.
    """
    window, begun = [0] * 100, [0] * 100
    at = value = line = 0
    counts: dict[str, int] = {}
    hashes: dict[int, str] = {}
    first = pow(37, 100, 2**64)

    def tell() -> None:
        if begun[at]:
            text = f"{value:x}"
            counts[text] = counts.get(text, 0) + 1
            hashes[begun[at]] = f"{text}:{counts[text]}"
            begun[at] = 0

    encoded = text.encode("utf-16-le", "surrogatepass")
    units = [int.from_bytes(encoded[i : i + 2], "little") for i in range(0, len(encoded), 2)]
    starting, after_return = True, False
    for number, unit in enumerate([*units, 65535, *[0] * 100]):
        over = number > len(units)
        if not over:
            skipped = unit in (9, 32) or (after_return and unit == 10)
            after_return = unit == 13
            if skipped:
                continue
            unit = 10 if unit == 13 else unit  # noqa: PLW2901
        tell()
        if starting and not over:
            line += 1
            begun[at] = line
        starting = unit == 10
        value = (value * 37 + unit - first * window[at]) % 2**64
        window[at] = unit
        at = (at + 1) % 100
    return hashes


def ours(text: str, *, bom: bool = False) -> dict[int, str]:
    source = SourceText("x", text, bom=bom)
    hashes = LineHashes(source)
    return {line: hashes.line_hash(line) for line in range(1, len(source.line_starts) + 1)}


@given(texts)
def test_the_closed_form_is_the_rolling_hash(text: str) -> None:
    for written in (text, text * 9, "same line\n" * 30 + text):
        assert ours(written) == rolled(written)


@given(texts)
def test_a_byte_order_mark_is_hashed_as_node_reads_it(text: str) -> None:
    assert ours(text, bom=True) == rolled("\ufeff" + text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "c129715d7a2bc9a3:1"),
        ("  \t", "c129715d7a2bc9a3:1"),
        ('{ "unit": "M" }', "a8b7d3cfb63b373e:1"),
    ],
)
def test_the_hash_of_a_text_never_changes(text: str, expected: str) -> None:
    assert ours(text)[1] == expected


def test_blanks_and_kinds_of_line_ends_do_not_matter() -> None:
    lines = ["{", '  "a": 1,', "}", ""]
    assert ours("\n".join(lines)) == ours("\r\n".join(lines)) == ours("\r".join(lines))
    assert ours("\n".join(lines)) == ours("\n".join(line.replace(" ", "\t") for line in lines))
