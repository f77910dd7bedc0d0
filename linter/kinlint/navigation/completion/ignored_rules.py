"""Codes of rules where they are ignored: in comments, and as values of `kl:ignore`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.situation import Situation
from kinlint.text import Span

_LIST = re.compile(r"\s*kinlint:\s*(?:file-)?ignore\s*\[([^\]]*)\Z")
_WORD = re.compile(r"\s*((?:kinlint:\s*)?[\w-]*)\Z")
_REST = re.compile(r"[\w-]*")
DIRECTIVES = (
    ("kinlint: ignore[$1]", "kinlint: ignore[]", "ignore rules in the next element"),
    ("kinlint: file-ignore[$1]", "kinlint: file-ignore[]", "ignore rules in the file"),
)


def in_comment(situation: Situation, comment: Span) -> Completions:
    """Return what can be written in a *comment* that tells kinlint to ignore rules."""
    text, offset = situation.source.text, situation.offset
    before = text[comment.start : offset]
    if named := _LIST.match(before):
        start = offset - len(re.split(r"[\s,]", named[1])[-1])
        rest = _REST.match(text, offset)
        return Completions.from_candidates(
            codes(situation), Span(start, rest.end() if rest else offset)
        )
    if word := _WORD.match(before):
        found = (
            Candidate(plain, Kind.WORD, detail, 1, plain, snippet, again=True)
            for snippet, plain, detail in DIRECTIVES
            if plain.startswith(word[1])
        )
        return Completions.from_candidates(found, Span(comment.start + word.start(1), offset))
    return NOTHING


def codes(situation: Situation) -> Iterator[Candidate]:
    """Yield the codes of the rules for the format, first those of which something was found."""
    found = {each.rule.code for each in situation.findings}
    forms = {situation.format.name, situation.format.lifted_as}
    for rule in situation.rulebook.rules:
        if rule.code in found or not forms.isdisjoint(rule.formats):
            rank = 0 if rule.code in found else 1
            yield Candidate(rule.code, Kind.RULE, rule.title, rank, documentation=rule.name)
