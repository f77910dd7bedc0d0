"""Parts of SPARQL expressions, which are sequences of tokens and groups."""

from __future__ import annotations

from kinlint.sparql.ast import Expression, Group


def unwrapped(words: Expression) -> Expression:
    """Return *words* without parentheses round all of them."""
    while words[0] == "(" and end(words, 0) == len(words):
        words = words[1:-1]
    return words


def end(words: Expression, at: int) -> int:
    """Return where the parenthesis that opens *at* is closed, plus one; *at* if none opens."""
    depth = 0
    for place in range(at, len(words)):
        depth += (words[place] == "(") - (words[place] == ")")
        if not depth:
            return place + (place > at)
    return len(words)


def arguments(words: Expression) -> list[Expression]:
    """Return the arguments of a call, between its commas."""
    found: list[list[str | Group]] = [[]]
    depth = 0
    for word in words:
        depth += (word == "(") - (word == ")")
        if word == "," and not depth:
            found.append([])
        else:
            found[-1].append(word)
    return [tuple(each) for each in found]
