"""The documents of the project, and the examples in them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from textwrap import dedent

ROOT = Path(__file__).parents[2]
GENERATED = ("rules/*/README.md", "shapes/lifting/README.md", "tests/real_models.md")
"""Pages that are made, and held to what they are made from."""

_FENCE = re.compile(
    r"^(?P<indent> *)```(?P<language>\w*)\n(?P<text>.*?)^(?P=indent)```", re.MULTILINE | re.DOTALL
)
_INLINE = re.compile(r"`(?:\.venv/bin/)?(kinlint [^`\n]+)`")
_PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")
_COMMENT = re.compile(r"\s+# .*$")


@dataclass(frozen=True)
class Block:
    """A fenced example: where it stands, its language, its text, and what stands before it."""

    page: str
    line: int
    language: str
    text: str
    before: Block | None = None

    def __str__(self) -> str:
        return f"{self.page}:{self.line}"

    @property
    def commands(self) -> list[str]:
        """The commands of a shell's block: lines, joined where they go on, without comments."""
        joined = self.text.replace("\\\n", " ")
        told = (_COMMENT.sub("", line).strip() for line in joined.splitlines())
        return [" ".join(line.split()) for line in told if line and not line.startswith("#")]


def pages() -> Iterator[str]:
    """The documents that people write, by their paths in the project."""
    made = {path for pattern in GENERATED for path in ROOT.glob(pattern)}
    places = (
        "*.md",
        "linter/*.md",
        "linter/kinlint/**/*.md",
        "rules/*.md",
        "samples/**/*.md",
        "shapes/**/*.md",
        "tests/**/*.md",
    )
    for path in sorted({path for place in places for path in ROOT.glob(place)} - made):
        yield path.relative_to(ROOT).as_posix()


def blocks(*names: str, language: str | None = None) -> list[Block]:
    """The examples in the documents called *names*, all by default, in one *language* or in any."""
    found = [block for name in names or pages() for block in _blocks(name)]
    return [block for block in found if language is None or block.language == language]


def _blocks(name: str) -> Iterator[Block]:
    text, before = (ROOT / name).read_text("utf-8"), None
    for match in _FENCE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        before = Block(name, line, match["language"], dedent(match["text"]), before)
        yield before


def mentioned() -> list[str]:
    """The commands within the text of documents, but for those with words to be filled in."""
    found = {line for name in pages() for line in _INLINE.findall((ROOT / name).read_text("utf-8"))}
    return sorted(line for line in found if not _PLACEHOLDER.search(line))
