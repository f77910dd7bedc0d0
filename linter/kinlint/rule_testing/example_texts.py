"""The texts of examples of rules: what is read, and where a rule has to find something."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TypeAlias

from kinlint.formats import records
from kinlint.rule import Example
from kinlint.text import SourceText, Span

Texts: TypeAlias = tuple[SourceText, ...]
"""An example, and what is read with it."""
MARK = re.compile(r"\[\|(.*?)\|\]", re.DOTALL)
FORMATS = {each.name: each for each in records.FORMATS if each.fence != "text"}
"""The formats in which examples are written, by name."""


def unmarked(text: str) -> tuple[str, list[Span]]:
    """Return *text* without its `[|…|]` marks, and the spans they stood round."""
    spans, shift = [], 0
    for match in MARK.finditer(text):
        start = match.start() - shift
        spans.append(Span(start, start + len(match[1])))
        shift += 4
    return MARK.sub(lambda match: match[1], text), spans


def texts_of(example: Example) -> Iterator[Texts]:
    """Yield what is read of *example*: for its bad text, and for its good one."""
    with beside(example) as home:
        for text in (example.bad, example.good):
            if text is not None:
                yield source(example, unmarked(text)[0], home)


@contextmanager
def beside(example: Example) -> Iterator[str]:
    """Yield the name of a directory that has the files beside *example*; none if there are none."""
    if not example.beside:
        yield ""
        return
    with TemporaryDirectory() as home:
        for name, _, content in (each.partition("\n") for each in example.beside):
            path = Path(home, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, "utf-8")
        yield home


def source(example: Example, text: str, home: str) -> Texts:
    """Return an example, and what is read with it."""
    others = (
        SourceText(_path(home, f"companion{number}", form), other, companion=True)
        for number, (form, other) in enumerate(example.companions)
    )
    return SourceText(_path(home, "example", example.format), text), *others


def _path(home: str, name: str, form: str) -> str:
    return Path(home, name + FORMATS[form].suffixes[0]).as_posix()
