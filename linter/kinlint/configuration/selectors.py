"""Names of rules in options and configurations: selectors, resolved against the catalogue.

A selector is a rule's code (`UNI002`) or name (`unit-quantity-mismatch`), the beginning of codes
(`UNI`, `UNI0`, `U`), the name of a family (`units`), the tag of an anti-pattern (`AP3`), or `ALL`.
As in ruff, the more specific selector wins over the less specific one, and of equals the ignoring
one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

from kinlint.configuration.keys import TARGETS
from kinlint.errors import UsageError
from kinlint.light_dataclasses import dataclass
from kinlint.rule import Rule
from kinlint.suggestion import did_you_mean

ALL = "ALL"

Rank: TypeAlias = tuple[int, int]


@dataclass(frozen=True)
class Catalogue:
    """The rules that selectors may name."""

    rules: Sequence[Rule]
    """All rules of the run."""

    @cached_property
    def exact(self) -> Mapping[str, Rule]:
        """Rules by code and by name."""
        return {key: rule for rule in self.rules for key in (rule.code, rule.name)}

    @cached_property
    def tags(self) -> frozenset[str]:
        """The anti-patterns that kinlint knows, and those that rules witness."""
        known = {f"AP{number}" for number in range(1, 7)}
        return frozenset(known.union(*(rule.antipatterns for rule in self.rules)))

    @cached_property
    def families(self) -> frozenset[str]:
        """The letters of the codes."""
        return frozenset(rule.family for rule in self.rules)

    @cached_property
    def topics(self) -> Mapping[str, frozenset[str]]:
        """The codes of the rules of each family, by the name of its folder: `topology`."""
        found: dict[str, set[str]] = {}
        for rule in self.rules:
            found.setdefault(Path(rule.path).parent.name, set()).add(rule.code)
        return {name: frozenset(codes) for name, codes in found.items() if name}

    def find(self, selector: str) -> tuple[Rank, frozenset[str]]:
        """Return how specific *selector* is, and the codes of the rules that it names.

        Raises `UsageError` with a suggestion if it names nothing known.
        """
        if selector == ALL:
            return (0, 0), frozenset(rule.code for rule in self.rules)
        if rule := self.exact.get(selector):
            return (4, 0), frozenset({rule.code})
        if selector in self.tags:
            tagged = (rule.code for rule in self.rules if selector in rule.antipatterns)
            return (2, 0), frozenset(tagged)
        if selector in self.topics:
            return (2, 0), self.topics[selector]
        codes = frozenset(rule.code for rule in self.rules if rule.code.startswith(selector))
        if not selector or not codes:
            message = f"unknown rule selector '{selector}'"
            meant = did_you_mean(selector, self.selectors)
            raise UsageError(message + (meant or "; kinlint rules lists them"))
        if selector in self.families:
            return (2, 0), codes
        return (1 if selector.isalpha() else 3, len(selector)), codes

    @property
    def selectors(self) -> Iterable[str]:
        """Every selector worth suggesting."""
        return (ALL, *self.tags, *self.families, *self.topics, *self.exact)

    def check_target(self, target: str) -> None:
        """Raise `UsageError` for a *target* that is no consumer known to kinlint or its rules."""
        from kinlint.targets.chosen_target import checked_target  # noqa: PLC0415  few runs name any

        checked_target(target, {*TARGETS, *(one for rule in self.rules for one in rule.targets)})

    def find_from(self, origin: str, selector: str) -> tuple[Rank, frozenset[str]]:
        """Call `find`, and name *origin* in its error."""
        try:
            return self.find(selector)
        except UsageError as error:
            raise type(error)(f"{origin}: {error}") from None


def select_codes(
    below: frozenset[str],
    wanted: Iterable[str],
    refused: Iterable[str],
    origin: str,
    catalogue: Catalogue,
) -> frozenset[str]:
    """The codes of *below* with those that *wanted* selects and without those of *refused*.

    The more specific selector wins, and of equals the refusing one.
    """
    steps = []
    for refusing, selectors in enumerate((wanted, refused)):
        for selector in selectors:
            rank, codes = catalogue.find_from(origin, selector)
            steps.append((rank, refusing, codes))
    chosen = set(below)
    for _, refusing, codes in sorted(steps, key=lambda step: step[:2]):
        if refusing:
            chosen -= codes
        else:
            chosen |= codes
    return frozenset(chosen)
