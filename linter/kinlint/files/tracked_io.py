"""Tracked input: records what a run reads, so that a cache can tell whether it changed.

A report follows from the texts that were given, the rules and the settings, and from what was
looked up besides: files that others include, directories, packages, the environment, the date. Each
look-up is a `question`. While a `Record` is being kept, it notes the question and a digest of the
answer; as long as all these answers stay the same, so does the report.

A question must not remember anything that outlives a record.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import wraps
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from typing import Any, ParamSpec, TypeAlias, TypeVar

from kinlint.files import url_mirror
from kinlint.light_dataclasses import dataclass, field

P = ParamSpec("P")
R = TypeVar("R")
Asked: TypeAlias = tuple[str, tuple[Any, ...]]
"""The name of a question, and what it is about: paths, texts and numbers."""

HOME = "kinlint.files."
"""Package of all questions."""
READER = f"{HOME}bounded_read"
"""Module of the questions for what is in a file."""


@dataclass
class Record:
    """Questions to the file system, and the answers."""

    answers: dict[Asked, str] = field(default_factory=dict)
    """Digests of the answers, by question."""
    torn: bool = False
    """True if one question was answered in two ways."""

    def note(self, asked: Asked, answer: str) -> None:
        """Keep that *asked* has this answer."""
        if self.answers.setdefault(asked, answer) != answer:
            self.torn = True


_KEPT: ContextVar[Record | None] = ContextVar("record", default=None)


@contextmanager
def recorded() -> Iterator[Record]:
    """Record all that is asked within the block, in this thread."""
    record = Record()
    token = _KEPT.set(record)
    try:
        yield record
    finally:
        _KEPT.reset(token)


def question(look: Callable[P, R]) -> Callable[P, R]:
    """Wrap *look*, a function of a module of this package, to note its answer if a record is kept.

    What it asks on the way is part of its answer. It takes positional arguments; what it gives has
    a `repr` that tells all of it.
    """
    name = f"{look.__module__.removeprefix(HOME)}.{look.__qualname__}"

    @wraps(look)
    def asked(*args: P.args, **kwargs: P.kwargs) -> R:
        if url_mirror.in_use():
            _provide(args, content=look.__module__ == READER)
        record = _KEPT.get()
        if record is None:
            return look(*args, **kwargs)
        assert not kwargs, "a question is asked by position"
        token = _KEPT.set(None)
        try:
            answer = look(*args, **kwargs)
        except Exception as error:
            record.note((name, args), _failure(error))
            raise
        finally:
            _KEPT.reset(token)
        record.note((name, args), _digest(answer))
        return answer

    return asked


def _provide(about: tuple[object, ...], *, content: bool) -> None:
    for each in about:
        if isinstance(each, Path):
            url_mirror.provide(each, content=content)


def answer(asked: Asked) -> str:
    """Return the digest of what is answered to *asked* now.

    Raises ValueError if it is no question.
    """
    module, _, name = asked[0].partition(".")
    if not module.isidentifier() or not name.isidentifier():
        raise ValueError(asked[0])
    look = getattr(import_module(HOME + module), name, None)
    look = getattr(look, "__wrapped__", None)
    if look is None:
        raise ValueError(asked[0])
    try:
        return _digest(look(*asked[1]))
    except Exception as error:  # noqa: BLE001  whatever went wrong is the answer
        return _failure(error)


def _digest(answer: object) -> str:
    data = answer if isinstance(answer, bytes) else repr(answer).encode("utf-8", "surrogatepass")
    return sha256(type(answer).__name__.encode() + b"\0" + data).hexdigest()[:32]


def _failure(error: Exception) -> str:
    return _digest(f"{type(error).__name__}: {error}")
