"""Small random changes to XML models: the slips that occur in files that people edit."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from random import Random

_TAG = re.compile(r"<!--.*?-->|<(?P<close>/?)(?P<name>[\w:.-]+)[^>]*?(?P<empty>/?)>", re.DOTALL)
_NUMBER = re.compile(r"(?<=[\"' >])-?\d+(?:\.\d*)?(?:e-?\d+)?(?=[\"' <])")
_NAME = re.compile(r"(?<=[ ])(name|link|joint|parent|child|type)=\"([^\"]*)\"")
NUMBERS = ("0", "-1", "1e9", "1e-12", "NaN", "one", "0,4", "3.15", "180", "", "+1", "1e400")


def elements(text: str) -> Iterator[tuple[int, int]]:
    """Where each element below the root begins and ends, inner ones first."""
    opened: list[int] = []
    for tag in _TAG.finditer(text):
        if tag["name"] is None:
            continue
        start = opened.pop() if tag["close"] else tag.start()
        if not tag["close"] and not tag["empty"]:
            opened.append(start)
        elif opened:
            yield start, tag.end()


def drop(text: str, random: Random) -> str:
    """An element is gone."""
    start, end = random.choice([*elements(text)] or [(0, 0)])
    return text[:start] + text[end:]


def duplicate(text: str, random: Random) -> str:
    """An element stands twice."""
    start, end = random.choice([*elements(text)] or [(0, 0)])
    return text[:end] + text[start:end] + text[end:]


def number(text: str, random: Random) -> str:
    """A number is another, or none."""
    return _replaced(text, [match.span() for match in _NUMBER.finditer(text)], random, NUMBERS)


def rename(text: str, random: Random) -> str:
    """A name is that of something else, misspelled or empty."""
    found = [match.span(2) for match in _NAME.finditer(text)]
    names = [text[start:end] for start, end in found]
    return _replaced(text, found, random, [*names, *(f"{each}_" for each in names), "", "a b"])


def _replaced(
    text: str, spans: list[tuple[int, int]], random: Random, by: tuple[str, ...] | list[str]
) -> str:
    if not spans:
        return text
    start, end = random.choice(spans)
    return text[:start] + random.choice(by) + text[end:]


MUTATIONS: tuple[Callable[[str, Random], str], ...] = (drop, duplicate, number, rename)


def mutant(text: str, seed: str) -> str:
    """*text* after one or two mutations, the same for the same *seed*."""
    random = Random(seed)  # noqa: S311
    for mutation in random.choices(MUTATIONS, k=random.choice((1, 1, 2))):
        text = mutation(text, random)
    return text
