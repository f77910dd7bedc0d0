"""One input on its way through kinlint, and what is wrong with the answer."""

from __future__ import annotations

import io
import signal
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from random import Random
from typing import NamedTuple

from support.linting import book

from fuzzing.corpus import corpus
from fuzzing.mutation import mutated
from kinlint import lint
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.formats.registry import decode
from kinlint.reporters.reporter_registry import FORMATS, write

SECONDS = 20
"""CPU time after which an input is said to hang."""
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
    """Return the input with the number *seed* of the format called *form*."""
    random = Random(f"{form} {seed}")  # noqa: S311  nothing is secret
    files = corpus(form)
    (name, text), (_, other) = random.choice(files), random.choice(files)
    return Input(form, seed, name, mutated(text, other, random))


def fault(given: Input) -> str | None:
    """Return the traceback that *given* leads to, or "hang"; None if it is answered."""
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


def _answer(given: Input) -> None:
    try:
        source = decode(given.name, given.content)
    except SourceError:
        return
    report = lint.run([source], [], Settings(), book())
    name = REPORTERS[given.seed % len(REPORTERS)]
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
