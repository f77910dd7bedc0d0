"""Inputs on their way through kinlint, and what is wrong with the answer."""

from __future__ import annotations

import io
import signal
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from random import Random
from typing import NamedTuple

from support.linting import book

from fuzzing.corpus import corpus, small
from fuzzing.mutation import mutated
from kinlint import lint
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.formats.registry import decode
from kinlint.reporters.reporter_registry import FORMATS, write

SECONDS = 20
"""CPU time after which inputs are said to hang."""
REPORTERS = tuple(FORMATS)


class Hang(Exception):
    """The time of one input is over."""


class Input(NamedTuple):
    """A mutated file; its format and seed say how to make it again."""

    form: str
    seed: int
    name: str
    content: bytes


def made(form: str, seed: int) -> Input:
    """Return the input with the number *seed* of the format called *form*; most are small."""
    random = Random(f"{form} {seed}")  # noqa: S311  nothing is secret
    files = small(form) if random.randrange(8) else corpus(form)
    (name, text), (_, other) = random.choice(files), random.choice(files)
    return Input(form, seed, name, mutated(text, other, random))


def fault(*given: Input) -> str | None:
    """Return the traceback that *given* lead to as one model, or "hang"; None if it is answered."""
    try:
        with _limited():
            _answer(given)
    except Hang:
        return f"hang: more than {SECONDS} s of CPU"
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException:  # noqa: BLE001  whatever escapes is a fault
        return traceback.format_exc()
    return None


def reduced(given: Sequence[Input]) -> tuple[Input, ...]:
    """Return as few of *given*, which fail as one model, as still fail."""
    parts = 2
    left = tuple(given)
    while len(left) > 1:
        size = -(-len(left) // parts)
        chunks = [left[start : start + size] for start in range(0, len(left), size)]
        rests = (tuple(one for one in left if one not in chunk) for chunk in chunks)
        found = next(
            (some for some in (*chunks, *rests) if len(some) < len(left) and fault(*some)), None
        )
        if found is not None:
            left, parts = found, 2
        elif parts >= len(left):
            break
        else:
            parts = min(len(left), 2 * parts)
    return left


def _answer(given: Sequence[Input]) -> None:
    sources = []
    for number, (_, _, name, content) in enumerate(given):
        with suppress(SourceError):
            sources.append(decode(f"{number}-{name}" if number else name, content))
    if not sources:
        return
    report = lint.run(sources, [], Settings(), book())
    name = REPORTERS[given[0].seed % len(REPORTERS)]
    write(report, name, io.StringIO())


@contextmanager
def _limited() -> Iterator[None]:
    if not hasattr(signal, "setitimer"):
        yield
        return

    def over(*_: object) -> None:
        raise Hang

    before = signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
