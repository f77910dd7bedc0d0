"""Edits as people make them while they write, and worse: most leave a text half-finished."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator

CHARACTERS = ["", '"', "<", ">", " ", "\n", "{", "}", ",", "a", "7", "-", "&", "é", "/"]
NUMBERS = ["0", "1", "2", "7", "-3", "1e3", "10", "0.5", "x", ""]


def versions(text: str, others: list[str], seed: int, steps: int) -> Iterator[str]:
    """*text*, and what *steps* random edits make of it, one after the other.

    Now and then it is as at first, or one of *others*.
    """
    rng, now = random.Random(seed), text  # noqa: S311  no secret
    yield now
    for _ in range(steps):
        chance = rng.random()
        if chance < 0.08 or not now:
            now = rng.choice([text, *others])
        else:
            now = rng.choice(EDITS)(now, rng)
        yield now


def _number(text: str, rng: random.Random) -> str:
    return _replaced(text, r"\d+", rng, lambda _: rng.choice(NUMBERS))


def _word(text: str, rng: random.Random) -> str:
    words = re.findall(r"[A-Za-z]{3,}", text) or [""]

    def other(word: str) -> str:
        return rng.choice([rng.choice(words), word[:-1], word + "x", word[::-1]])

    return _replaced(text, r"[A-Za-z]{3,}", rng, other)


def _character(text: str, rng: random.Random) -> str:
    at = rng.randrange(len(text))
    return text[:at] + rng.choice(CHARACTERS) + text[at + rng.choice([0, 1, 1, 3]) :]


def _deletion(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    at = rng.randrange(len(lines))
    del lines[at : at + rng.choice([1, 1, 2, 5])]
    return "".join(lines)


def _move(text: str, rng: random.Random, *, copy: bool = False) -> str:
    lines = text.splitlines(keepends=True)
    at, size = rng.randrange(len(lines)), rng.choice([1, 3, 8, 20])
    block = lines[at : at + size]
    if not copy:
        del lines[at : at + size]
    to = rng.randrange(len(lines) + 1)
    lines[to:to] = block
    return "".join(lines)


def _copy(text: str, rng: random.Random) -> str:
    return _move(text, rng, copy=True)


def _string(text: str, rng: random.Random) -> str:
    strings = re.findall(r'"[^"\n]*"', text) or ['""']
    return _replaced(text, r'"[^"\n]*"', rng, lambda _: rng.choice(strings))


def _replaced(text: str, pattern: str, rng: random.Random, other: Callable[[str], str]) -> str:
    found = list(re.finditer(pattern, text))
    if not found:
        return text
    match = rng.choice(found)
    return text[: match.start()] + other(match[0]) + text[match.end() :]


EDITS = (_number, _word, _character, _character, _deletion, _move, _copy, _string)
