"""Message templates: text with variables, `'{?joint}'`, which words are filled into."""

from __future__ import annotations

import re
from collections.abc import Mapping

from kinlint.rule import PLACEHOLDER

VARIABLE = re.compile(rf"(?:(\w+) )?('?){PLACEHOLDER.pattern}('?)")
"""A variable of a template, with the word before it and the quotes around it."""


def filled(template: str, words: Mapping[str, str]) -> str:
    """Return *template* with *words* for its variables; its quotes go where a word has none."""

    def word(match: re.Match[str]) -> str:
        before, opening, name, closing = match.groups()
        text = words.get(name, "")
        if not (opening and closing):
            text = f"{opening}{bare(text)}{closing}"
        if before:
            return f"{before} {text}"
        return text if match.start() else f"{text[:1].upper()}{text[1:]}"

    return VARIABLE.sub(word, template)


def bare(word: str) -> str:
    """Return *word* without the quotes around it."""
    return word[1:-1] if len(word) > 1 and word[0] == word[-1] == "'" else word


def counted(message: str, count: int) -> str:
    """Return *message* with the number of places that it holds for, if they are several."""
    if count < 2:  # noqa: PLR2004  one is no number worth saying
        return message
    return f"{message.removesuffix('.')} ({count} such places)."
