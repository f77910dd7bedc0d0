"""Which rules speak in a file, and how loud: selectors resolved against the catalogue.

A selector is a rule's code (`UNI002`) or name (`unit-quantity-mismatch`), the beginning of codes
(`UNI`, `UNI0`, `U`), the tag of an anti-pattern (`AP3`), or `ALL`. As in ruff, the more specific
selector wins over the less specific one, and of equals the ignoring one.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TypeAlias

from kinlint.configuration.keys import TARGETS
from kinlint.configuration.settings import Choice, Settings
from kinlint.errors import UsageError
from kinlint.model import Finding, Rule, Severity
from kinlint.suggestion import did_you_mean

ALL = "ALL"

Rank: TypeAlias = tuple[int, int]


@dataclass(frozen=True)
class Catalogue:
    """The rules that selectors may name."""

    rules: Sequence[Rule]

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

    def find(self, selector: str) -> tuple[Rank, frozenset[str]]:
        """How specific *selector* is, and the codes of the rules that it names.

        Raises `UsageError` with a suggestion if it names nothing known.
        """
        if selector == ALL:
            return (0, 0), frozenset(rule.code for rule in self.rules)
        if rule := self.exact.get(selector):
            return (4, 0), frozenset({rule.code})
        if selector in self.tags:
            tagged = (rule.code for rule in self.rules if selector in rule.antipatterns)
            return (2, 0), frozenset(tagged)
        codes = frozenset(rule.code for rule in self.rules if rule.code.startswith(selector))
        if not selector or not codes:
            message = f"unknown rule selector '{selector}'"
            meant = did_you_mean(selector, self.selectors)
            raise UsageError(message + (meant or "; kinlint rule --all shows what there is"))
        if selector in self.families:
            return (2, 0), codes
        return (1 if selector.isalpha() else 3, len(selector)), codes

    @property
    def selectors(self) -> Iterable[str]:
        """Every selector worth suggesting."""
        return (ALL, *self.tags, *self.families, *self.exact)

    def check_target(self, target: str) -> None:
        """Raise `UsageError` for a *target* that is no consumer known to kinlint or its rules."""
        known = {*TARGETS, *(one for rule in self.rules for one in rule.targets)}
        if target not in known:
            listed = ", ".join(sorted(known))
            meant = did_you_mean(target, known) or f"; there are {listed}"
            raise UsageError(f"unknown target '{target}'{meant}")

    def find_from(self, origin: str, selector: str) -> tuple[Rank, frozenset[str]]:
        """As `find`; a failure says that *origin* is to blame."""
        try:
            return self.find(selector)
        except UsageError as error:
            raise type(error)(f"{origin}: {error}") from None


@dataclass(frozen=True, slots=True)
class Policy:
    """The outcome of selection in one file: severities by code, None for a silent rule."""

    severities: Mapping[str, Severity | None]

    def severity(self, rule: Rule) -> Severity | None:
        """What *rule* counts as here; None if it does not speak. Rules unheard of speak."""
        return self.severities.get(rule.code, rule.severity)


@dataclass(frozen=True)
class Policies:
    """The policies of a run. Raises `UsageError` for selectors that name no rule.

    `formats` are those of the sources, by name.
    """

    settings: Settings
    rules: Sequence[Rule]
    formats: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def catalogue(self) -> Catalogue:
        """The rules that selectors may name."""
        return Catalogue(self.rules)

    @cached_property
    def _by_settings(self) -> dict[tuple[tuple[Choice, ...], tuple[str, ...], str], Policy]:
        return {}

    def of(self, name: str) -> Policy:
        """The policy in the source called *name*."""
        settings = self.settings.of(name)
        key = settings.choices, settings.targets, self.formats.get(name, "")
        if key not in self._by_settings:
            self._by_settings[key] = policy(key[0], self.catalogue, *key[1:])
        return self._by_settings[key]

    def enabled(self, names: Iterable[str]) -> frozenset[str]:
        """The codes of the rules that speak in at least one of the sources called *names*."""
        each = [self.of(name) for name in names]
        return frozenset(
            rule.code for rule in self.rules if any(one.severity(rule) is not None for one in each)
        )

    def judged(self, findings: Iterable[Finding]) -> list[Finding]:
        """Those *findings* whose rule speaks where they lie, with the severity it has there."""
        kept = []
        for finding in findings:
            severity = self.of(finding.location.source.name).severity(finding.rule)
            if severity is not None:
                kept.append(replace(finding, severity=severity))
        return kept

    def check(self) -> None:
        """Resolve all that files name of the catalogue, so that mistakes show before work starts.

        Raises `UsageError` for unknown selectors and targets.
        """
        every = [self.settings.default, *self.settings.files.values()]
        for target in {target for settings in every for target in settings.targets}:
            self.catalogue.check_target(target)
        for choices in {settings.choices for settings in every}:
            policy(choices, self.catalogue)
        for ignore in {ignore for settings in every for ignore in settings.ignores}:
            for selector in ignore.selectors:
                self.catalogue.find_from(f"{ignore.origin}: {ignore.key}", selector)


def policy(
    choices: Iterable[Choice], catalogue: Catalogue, targets: Collection[str] = (), form: str = ""
) -> Policy:
    """What *choices*, the lowest layer first, make of the rules in a file of format *form*.

    At first, all are chosen but optional ones that say nothing of the *targets* that are meant.
    A rule about other targets is silent all the same.
    """
    chosen = frozenset(
        rule.code for rule in catalogue.rules if not rule.optional or rule.speaks_for(targets)
    )
    meant = {rule.code: rule.counts_as(targets, form) for rule in catalogue.rules}
    severities = {rule.code: meant[rule.code] or rule.severity for rule in catalogue.rules}
    for choice in choices:
        chosen = _choose(choice, chosen, catalogue)
        ranked = [(catalogue.find_from(choice.origin, sel), sev) for sel, sev in choice.severity]
        for (_, codes), severity in sorted(ranked, key=lambda entry: entry[0][0]):
            severities.update(dict.fromkeys(codes, severity))
    speaking = {code for code, severity in meant.items() if severity is not None} & chosen
    return Policy({code: severities[code] if code in speaking else None for code in severities})


def _choose(choice: Choice, below: frozenset[str], catalogue: Catalogue) -> frozenset[str]:
    wanted = [(*choice.extend_select, *(choice.select or ())), choice.ignore]
    steps = []
    for ignoring, selectors in enumerate(wanted):
        for selector in selectors:
            rank, codes = catalogue.find_from(choice.origin, selector)
            steps.append((rank, ignoring, codes))
    chosen = set(below) if choice.select is None else set()
    for _, ignoring, codes in sorted(steps, key=lambda step: step[:2]):
        if ignoring:
            chosen -= codes
        else:
            chosen |= codes
    return frozenset(chosen)
