"""Writes small files without private names that make kinlint fail: `kinlint --report-bug`."""

from __future__ import annotations

import re
import sys
import traceback
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path, PurePath

from kinlint import __version__, resources
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.output_files import replacing
from kinlint.configuration.settings import Settings
from kinlint.errors import KinlintError, SourceError
from kinlint.fixes.rounds import lint_texts
from kinlint.light_dataclasses import replace
from kinlint.text import SourceText

WORD = re.compile(r"[^\W\d]\w*")
TRIALS = 200
"""Maximum number of attempts to make a reproducer smaller."""

Failure = tuple[str, str, int]
"""The type of an exception, and the function and line of kinlint that it came from."""


def write_reproducers(
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    directory: Path,
) -> None:
    """Write a reproducer to *directory* for each of *sources* that makes kinlint fail alone.

    Names that are in no vocabulary are replaced, numbers stay; what is not needed for the failure
    is left out. *errors* are of files that cannot be read, which fail nothing.
    """
    del errors

    def failure(source: SourceText) -> Failure | None:
        try:
            lint_texts([source], (), settings, rulebook)
        except (KinlintError, MemoryError):
            return None
        except Exception as error:  # noqa: BLE001  of any kind
            return _failure(error)
        return None

    written = 0
    for source in sources:
        wanted = failure(source)
        if wanted is None:
            continue
        written += 1
        name = f"bug-{written}{PurePath(source.name).suffix}"
        small = reduced(source, wanted, failure)
        kind, function, line = wanted
        directory.mkdir(parents=True, exist_ok=True)
        with replacing(directory / name) as stream:
            stream.write(small.text)
        with replacing(directory / f"{name}.txt") as stream:
            stream.write(f"kinlint {__version__}\n{kind} in {function}, line {line}\n")
        sys.stderr.write(f"kinlint: wrote {directory / name}: {kind} in {function}\n")
    if written:
        sys.stderr.write("kinlint: look at what was written, and attach it to an issue\n")
    else:
        sys.stderr.write("kinlint: no file makes kinlint fail by itself\n")


def reduced(
    source: SourceText, wanted: Failure, failure: Callable[[SourceText], Failure | None]
) -> SourceText:
    """Return *source* with fewer lines and without private names, as long as it fails as *wanted*.

    *failure* tells how a text fails.
    """
    left = TRIALS

    def holds(text: str) -> bool:
        nonlocal left
        left -= 1
        return left >= 0 and failure(replace(source, text=text)) == wanted

    text = source.text
    if holds(anonymised(text)):
        text = anonymised(text)
    else:
        sys.stderr.write(f"kinlint: warning: {source.name} fails with its own names only\n")
    lines = text.splitlines(keepends=True)
    size = len(lines) // 2
    while size and left > 0:
        at = 0
        while at < len(lines) and left > 0:
            shorter = [*lines[:at], *lines[at + size :]]
            if shorter and holds("".join(shorter)):
                lines = shorter
            else:
                at += size
        size //= 2
    return replace(source, text="".join(lines))


def anonymised(text: str) -> str:
    """Return *text* with each word that is in no vocabulary replaced, equal ones by equal ones."""
    names: dict[str, str] = {}

    def public(match: re.Match[str]) -> str:
        word = match[0]
        return word if word in vocabulary() else names.setdefault(word, f"n{len(names) + 1}")

    return WORD.sub(public, text)


@cache
def vocabulary() -> frozenset[str]:
    """Return the words of the formats and metamodels that kinlint knows."""
    shapes = resources.data("shapes")
    files = (path for path in shapes.rglob("*") if path.suffix in (".ttl", ".json", ".rq", ".tsv"))
    words = (WORD.findall(path.read_text("utf-8", "replace")) for path in files)
    return frozenset(word for found in words for word in found) | {"xml", "version", "encoding"}


def _failure(error: Exception) -> Failure:
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if "kinlint" in PurePath(frame.filename).parts] or frames
    place = PurePath(own[-1].filename).stem
    return type(error).__name__, f"{place}.{own[-1].name}", own[-1].lineno or 0
