"""A rule on one screen: its reason, one example as far as it shows the fault, and its fixes."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from difflib import SequenceMatcher

from kinlint.light_dataclasses import replace
from kinlint.rule import Example, Rule

MOST_LINES = 10
"""Most lines of an example that are shown."""
MOST_FIXES = 3
_LEFT_OUT = "..."


def summary(rule: Rule, examples: Sequence[Example]) -> Rule:
    """Return *rule* with the first pair in *examples*, without queries and facts."""
    pairs = [each for each in examples if each.bad is not None and each.good is not None]
    shown = [_excerpt(each) for each in (pairs or [*examples])[:1]]
    repairs = [replace(each, update="") for each in rule.repairs[:MOST_FIXES]]
    return replace(rule, examples=shown, repairs=repairs, facts=())


def _excerpt(example: Example) -> Example:
    """Return the blocks of *example* around what is marked, and around the same when it is good."""
    bad, good = _lines(example.bad), _lines(example.good)
    marked = next((line for line in bad if "[|" in line), "")
    return replace(
        example,
        bad=None if example.bad is None else _around(bad, marked),
        good=None if example.good is None else _around(good, marked),
    )


def _lines(text: str | None) -> list[str]:
    return textwrap.dedent(text or "").strip("\n").splitlines()


def _around(lines: Sequence[str], marked: str) -> str:
    """Return the widest block of few *lines*, by indentation, around the one most like *marked*."""
    if len(lines) <= MOST_LINES:
        return "\n".join(lines)
    plain = marked.replace("[|", "").replace("|]", "")
    alike = [SequenceMatcher(None, plain, each, autojunk=False).ratio() for each in lines]
    start = lines.index(marked) if marked in lines else alike.index(max(alike))
    end = start + 1
    while True:
        depth = _depth(lines[start])
        above = next((n for n in range(start - 1, -1, -1) if _depth(lines[n]) < depth), -1)
        outer = _depth(lines[above])
        below = next((n for n in range(end, len(lines)) if _depth(lines[n]) <= outer), -1)
        if min(above, below) < 0 or below + 1 - above > MOST_LINES:
            break
        start, end = above, below + 1
    if end - start == 1:
        start, end = max(start - MOST_LINES // 3, 0), end + MOST_LINES // 3
    kept = textwrap.dedent("\n".join(lines[start:end])).splitlines()
    return "\n".join([_LEFT_OUT] * (start > 0) + kept + [_LEFT_OUT] * (end < len(lines)))


def _depth(line: str) -> float:
    return len(line) - len(line.lstrip()) if line.strip() else float("inf")
