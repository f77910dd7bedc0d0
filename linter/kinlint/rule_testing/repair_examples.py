"""Holds the repairs of a rule to its examples: what they make of the bad text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import unified_diff

from kinlint.catalogue.applicability import covers
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.fixes.offers import Offers
from kinlint.fixes.rounds import fix_in_rounds, lint_texts
from kinlint.formats.records import BY_NAME
from kinlint.rule import Applicability, Example, Repair, Rule
from kinlint.text import SourceText

Shown = tuple[int, Example, Sequence[SourceText]]
"""A bad example: its number, and the texts that are read."""


def shown(
    rule: Rule, rulebook: Rulebook, settings: Settings, bad: Sequence[Shown]
) -> Iterator[str]:
    """Yield faults of the repairs of *rule* that its *bad* examples show.

    The preferred repair makes the good text of the bad one, to the character, or the one that the
    example says; each repair is offered somewhere, as safe as it claims to be.
    """
    offered = set[Repair]()
    for number, example, texts in bad:
        if not any(covers(each.formats, BY_NAME[example.format]) for each in rule.repairs):
            continue
        offers = lint_texts(texts, (), settings, rulebook)
        held = {each.repair for each, verdict in offers.verdicts.items() if verdict.applicability}
        offered |= held
        for problem in _problems(example, texts, offers, settings, rulebook):
            yield f"bad example {number} {problem}"
    for repair in rule.repairs:
        if repair not in offered:
            yield f"no example shows the repair '{repair.title}'"


def fixed(texts: Sequence[SourceText], settings: Settings, rulebook: Rulebook) -> str:
    """Return what the preferred repairs make of the first of *texts*."""
    return fix_in_rounds(texts, (), settings, rulebook, Applicability.DISPLAY).texts[0].text


def _problems(
    example: Example,
    texts: Sequence[SourceText],
    offers: Offers,
    settings: Settings,
    rulebook: Rulebook,
) -> Iterator[str]:
    verdicts = offers.verdicts
    if example.unfixable or not any(each.applicability for each in verdicts.values()):
        if any(each.applicability for each in verdicts.values()):
            yield "can be fixed after all"
        elif not example.unfixable:
            yield f"is not fixed: {_reason(offers)}"
        return
    made = fixed(texts, settings, rulebook)
    expected = example.fixed if example.fixed is not None else example.good
    if made != expected:
        yield f"is fixed to something else:\n{_diff(expected, made)}"
    for each, verdict in verdicts.items():
        if verdict.applicability is Applicability.UNSAFE < each.repair.applicability:
            yield f"has a fix that is not safe, '{each.repair.title}': {verdict.why}"


def _reason(offers: Offers) -> str:
    reasons = dict.fromkeys(f"'{repair.title}': {why}" for _, repair, why in offers.refused)
    return "; ".join(reasons) or "no repair changes anything"


def _diff(expected: str | None, made: str) -> str:
    lines = unified_diff((expected or "").splitlines(), made.splitlines(), "expected", "made", n=0)
    return "\n".join(lines)
