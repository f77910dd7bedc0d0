"""Diffs are patches."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlint.reporters.diff import unified_diff
from kinlint.reporters.terminal_style import Style

texts = st.text("ab \n\r\t\u2028é😀\x0c", max_size=60)


def test_a_diff_shows_what_changed_with_its_neighbours() -> None:
    assert "".join(unified_diff("m.jsonld", "a\nb\nc\n", "a\nB\nc\n")) == (
        "--- m.jsonld\n+++ m.jsonld\n@@ -1,3 +1,3 @@\n a\n-b\n+B\n c\n"
    )


def test_equal_texts_have_no_diff() -> None:
    assert list(unified_diff("m.jsonld", "a\n", "a\n")) == []


def test_a_last_line_without_an_end_is_told() -> None:
    """As `diff` does, so that `patch` gives the file back to the byte."""
    assert list(unified_diff("m", "a", "a\n"))[3:] == [
        "-a\n",
        "\\ No newline at end of file\n",
        "+a\n",
    ]


def test_colour_goes_with_the_sign_and_control_characters_are_escaped() -> None:
    told = list(unified_diff("m", "a\r\n", "\x1b[31mb\r\n", Style(color=True)))
    assert told[3:] == ["\x1b[31m-a\x1b[0m\n", "\x1b[32m+\\u001b[31mb\x1b[0m\n"]


@pytest.mark.skipif(shutil.which("patch") is None, reason="there is no patch")
@pytest.mark.parametrize("name", ["m.jsonld", "a b.jsonld"])
def test_patch_makes_the_one_text_of_the_other(name: str, tmp_path: Path) -> None:
    """CR LF, no last line end, and what Python alone takes for the end of a line."""
    file = tmp_path / name

    @given(texts, texts)
    def same(before: str, after: str) -> None:
        diff = "".join(unified_diff(name, before, after))
        if not before or not after or not diff:
            return  # patch takes an empty text for a file that is not there
        file.write_bytes(before.encode())
        command = ["patch", "--binary", "--quiet", "--posix", "-p0"]
        subprocess.run(command, input=diff.encode(), cwd=tmp_path, check=True)
        assert file.read_bytes() == after.encode()

    same()
