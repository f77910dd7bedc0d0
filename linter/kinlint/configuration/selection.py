"""Selection and severity of rules by file."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from kinlint.configuration.fix_trust import Trust, combine_trust
from kinlint.configuration.selectors import Catalogue, select_codes
from kinlint.configuration.settings import Choice, Settings
from kinlint.finding import DEPARTURES, Finding
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.rule import Rule, Severity

if TYPE_CHECKING:
    from kinlint.targets.chosen_target import Target
    from kinlint.targets.portability import Portability


@dataclass(frozen=True, slots=True)
class Policy:
    """The outcome of selection in one file."""

    severities: Mapping[str, Severity | None]
    """Severities by code; None for a silent rule."""
    imposed: frozenset[str] = frozenset()
    """Codes whose severity a target or the configuration set."""
    configured: frozenset[str] = frozenset()
    """Codes whose severity the configuration set."""
    targets: Collection[str] = ()
    """Names of the consumers that the file is meant for, with those of which each is a part."""
    chosen: Sequence[Target] = ()
    """The consumers that the file is meant for, with their versions."""
    form: str = ""
    """Format of the file."""

    def severity(self, rule: Rule) -> Severity | None:
        """Return the severity of *rule* here; None if it is off. Unknown rules are on."""
        return self.severities.get(rule.code, rule.severity)

    def severity_of(self, finding: Finding) -> Severity | None:
        """Return the severity of *finding* here; None if it is not for the consumers named.

        That of the configuration comes first, then that of the constraint for a consumer, that of
        the rule for a consumer, that of the constraint, and that of the rule.
        """
        rule = finding.rule
        severity = self.severity(rule)
        missed = finding.targets and not self._means(finding)
        if severity is None or missed or rule.code in self.configured:
            return None if missed else severity
        special = [
            each.severity for each in finding.severity_for if each.applies(self.targets, self.form)
        ]
        departing = self.portability(finding) if self.chosen else None
        worst = None if departing is None else departing.severity
        own = finding.severity is not rule.severity and rule.code not in self.imposed
        usual = finding.severity if own else severity
        if worst is not None:
            # A defect stays as severe as it is, whoever puts up with it.
            special += [worst] if finding.speaks_of else [worst, usual]
        return max(special, default=usual)

    def _means(self, finding: Finding) -> bool:
        """Tell whether *finding* is about a consumer, in a version, that the file is meant for."""
        if set(finding.targets).isdisjoint(self.targets):
            return False
        if not any(finding.versions):
            return True
        from kinlint.targets.chosen_target import means_one  # noqa: PLC0415  few findings tell any
        from kinlint.targets.version_range import VersionRange  # noqa: PLC0415

        return means_one(self.chosen, finding.targets, VersionRange(*finding.versions))

    def portability(self, finding: Finding) -> Portability | None:
        """Return what the consumers that *finding* is about make of its feature; None without."""
        if not finding.feature or not (self.chosen or finding.speaks_of == "all"):
            return None
        from kinlint.targets.portability import Portability  # noqa: PLC0415  few runs have targets

        found = Portability.of(finding.feature, self.chosen)
        return found if self.form in found.formats else None

    def judge(self, finding: Finding) -> Finding | None:
        """Return *finding* as it counts here; None if its rule is off, or nobody departs."""
        severity = self.severity_of(finding)
        if severity is None:
            return None
        found = self.portability(finding)
        if found is None:
            return None if finding.speaks_of == "chosen" else replace(finding, severity=severity)
        if not (told := found.sentences):
            return None if finding.speaks_of else replace(finding, severity=severity)
        return replace(
            finding,
            severity=severity,
            message=f"{finding.message} {told}",
            template=f"{finding.template} {DEPARTURES}",
            arguments=(*finding.arguments, told),
            departures=told,
        )


@dataclass(frozen=True)
class Policies:
    """The policies of a run. Raises `UsageError` for selectors that name no rule."""

    settings: Settings
    """The settings of the run."""
    rules: Sequence[Rule]
    """All rules."""
    formats: Mapping[str, str] = field(default_factory=dict)
    """Formats of the sources, by name of the source."""

    @cached_property
    def catalogue(self) -> Catalogue:
        """The rules that selectors may name."""
        return Catalogue(self.rules)

    @cached_property
    def _by_settings(self) -> dict[tuple[tuple[Choice, ...], tuple[str, ...], str], Policy]:
        return {}

    def for_file(self, name: str) -> Policy:
        """The policy in the source called *name*."""
        settings = self.settings.for_file(name)
        key = settings.choices, settings.targets, self.formats.get(name, "")
        if key not in self._by_settings:
            self._by_settings[key] = combine_policy(key[0], self.catalogue, *key[1:])
        return self._by_settings[key]

    @cached_property
    def _trusts(self) -> dict[tuple[Choice, ...], Trust]:
        return {}

    def trust(self, name: str) -> Trust:
        """Return the fixes allowed in the source called *name*."""
        choices = self.settings.for_file(name).choices
        if choices not in self._trusts:
            self._trusts[choices] = combine_trust(choices, self.catalogue)
        return self._trusts[choices]

    def enabled(self, names: Iterable[str]) -> frozenset[str]:
        """The codes of the rules that speak in at least one of the sources called *names*."""
        each = [self.for_file(name) for name in names]
        return frozenset(
            rule.code for rule in self.rules if any(one.severity(rule) is not None for one in each)
        )

    def apply_severities(self, findings: Iterable[Finding]) -> list[Finding]:
        """Return the *findings* whose rule is on where they lie, with the severity it has there."""
        judged = (self.for_file(each.location.source.name).judge(each) for each in findings)
        return _narrowest([finding for finding in judged if finding is not None])

    def has_targets(self, names: Iterable[str]) -> bool:
        """Tell whether one of the sources called *names* is meant for certain consumers."""
        return any(self.settings.for_file(name).targets for name in names)

    @cached_property
    def _departed(self) -> dict[str, bool]:
        return {}

    def departs(self, feature: str) -> bool:
        """Tell whether a target of some file departs from *feature*."""
        if feature not in self._departed:
            from kinlint.targets.portability import Portability  # noqa: PLC0415  few runs have targets

            every = {self.for_file(name).chosen for name in self.formats}
            self._departed[feature] = any(
                Portability.of(feature, chosen).departures for chosen in every if chosen
            )
        return self._departed[feature]

    def check_selectors(self) -> None:
        """Resolve all that files name of the catalogue, so that mistakes show before work starts.

        Raises `UsageError` for unknown selectors and targets.
        """
        every = [self.settings.default, *self.settings.files.values()]
        for target in {target for settings in every for target in settings.targets}:
            self.catalogue.check_target(target)
        for choices in {settings.choices for settings in every}:
            combine_policy(choices, self.catalogue)
            combine_trust(choices, self.catalogue)
        for ignore in {ignore for settings in every for ignore in settings.ignores}:
            for selector in ignore.selectors:
                self.catalogue.find_from(f"{ignore.origin}: {ignore.key}", selector)


def _narrowest(findings: list[Finding]) -> list[Finding]:
    """Return *findings* without those whose feature has a special case at the same place.

    What only speaks of targets is left out where another rule reports the feature in the file.
    """
    if not any(each.departures for each in findings):
        return findings
    from kinlint.targets.consumer_files import consumer_table  # noqa: PLC0415  few runs have targets

    features = consumer_table().features
    narrowed = {
        (each.location, features[each.feature].narrows)
        for each in findings
        if each.departures and features[each.feature].narrows
    }
    defects = {_told(each): each.rule for each in findings if not each.speaks_of}
    return [
        each
        for each in findings
        if (each.location, each.feature) not in narrowed
        and not (each.speaks_of and defects.get(_told(each), each.rule) is not each.rule)
    ]


def _told(finding: Finding) -> tuple[str, str]:
    return finding.feature, finding.location.source.name


def combine_policy(
    choices: Iterable[Choice], catalogue: Catalogue, targets: Collection[str] = (), form: str = ""
) -> Policy:
    """Combine *choices*, the lowest layer first, for a file of format *form*, meant for *targets*.

    At first, all rules are on but optional ones that name none of the *targets*. A rule for other
    targets is off all the same, and a preview rule unless previews are on or it is named.
    """
    meant_for, targets = _resolved(targets)
    chosen = frozenset(
        rule.code
        for rule in catalogue.rules
        if not rule.optional or rule.concerns(targets) or _departed(rule, meant_for)
    )
    meant = {rule.code: rule.severity_for_targets(targets, form) for rule in catalogue.rules}
    severities = {rule.code: meant[rule.code] or rule.severity for rule in catalogue.rules}
    imposed = {
        rule.code
        for rule in catalogue.rules
        if any(each.targets and each.applies(targets, form) for each in rule.severity_for)
    }
    configured: set[str] = set()
    preview, named = False, set[str]()
    for choice in choices:
        preview = preview if choice.preview is None else choice.preview
        wanted = (*choice.extend_select, *(choice.select or ()))
        named.update(catalogue.exact[each].code for each in wanted if each in catalogue.exact)
        below = chosen if choice.select is None else frozenset[str]()
        chosen = select_codes(below, wanted, choice.ignore, choice.origin, catalogue)
        ranked = [(catalogue.find_from(choice.origin, sel), sev) for sel, sev in choice.severity]
        for (_, codes), severity in sorted(ranked, key=lambda entry: entry[0][0]):
            severities.update(dict.fromkeys(codes, severity))
            configured |= codes
    if not preview:
        chosen -= {rule.code for rule in catalogue.rules if rule.preview} - named
    speaking = {code for code, severity in meant.items() if severity is not None} & chosen
    spoken = {code: severities[code] if code in speaking else None for code in severities}
    return Policy(
        spoken,
        frozenset(imposed | configured),
        frozenset(configured),
        tuple(targets),
        meant_for,
        form,
    )


def _resolved(targets: Collection[str]) -> tuple[Sequence[Target], Collection[str]]:
    """Return the consumers that *targets* spell with their versions, and all their names."""
    if not targets:
        return (), ()
    from kinlint.targets.chosen_target import chosen_targets, names_of  # noqa: PLC0415  few have any

    return chosen_targets(targets), names_of(targets)


def _departed(rule: Rule, targets: Sequence[Target]) -> bool:
    """Tell whether one of *targets* departs from a feature that *rule* finds."""
    if not targets or not rule.features:
        return False
    from kinlint.targets.portability import Portability  # noqa: PLC0415  few runs have targets

    return any(Portability.of(each, targets).departures for each in rule.features)
