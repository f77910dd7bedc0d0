"""Selection of fixes by file, and the applicability they count as.

Selectors are those of the rules. As with these, a higher layer replaces or changes what a lower one
said, the more specific selector wins, and of equals the more careful one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from kinlint.configuration.selectors import ALL, Catalogue, Rank, select_codes
from kinlint.configuration.settings import Choice
from kinlint.finding import Fix
from kinlint.light_dataclasses import dataclass
from kinlint.light_dataclasses import replace as changed
from kinlint.rule import Applicability, Rule


@dataclass(frozen=True, slots=True)
class Trust:
    """The fixes that choices allow, and the applicability they count as."""

    fixable: frozenset[str]
    """Codes of the rules whose findings are fixed."""
    unsafe: Mapping[str, bool]
    """For some codes, True if all fixes count as unsafe, False if unsafe ones count as safe."""

    def allows_fixes(self, rule: Rule) -> bool:
        """Tell whether findings of *rule* are fixed at all."""
        return rule.code in self.fixable

    def applicability(self, rule: Rule, proven: Applicability) -> Applicability:
        """Return the applicability, here, of a fix of *rule* that is *proven* so far.

        Fixes for display only stay so.
        """
        said = self.unsafe.get(rule.code)
        if said is None or proven is Applicability.DISPLAY:
            return proven
        return Applicability.UNSAFE if said else Applicability.SAFE

    def weighed_fix(self, rule: Rule, fix: Fix) -> Fix:
        """Return *fix* of a finding of *rule* with the applicability it has here."""
        applicability = self.applicability(rule, fix.applicability)
        if applicability is fix.applicability:
            return fix
        why = "" if applicability is Applicability.SAFE else "the configuration calls it unsafe"
        return changed(fix, applicability=applicability, why=why)


def combine_trust(choices: Iterable[Choice], catalogue: Catalogue) -> Trust:
    """Combine *choices*, the lowest layer first; without any, all fixes are allowed.

    Raises `UsageError` for selectors that name no rule.
    """
    fixable = catalogue.find(ALL)[1]
    unsafe: dict[str, bool] = {}
    for choice in choices:
        below = fixable if choice.fixable is None else frozenset[str]()
        fixable = select_codes(
            below, choice.fixable or (), choice.unfixable, choice.origin, catalogue
        )
        for _, careful, codes in sorted(_trust_steps(choice, catalogue), key=lambda step: step[:2]):
            unsafe.update(dict.fromkeys(codes, careful))
    return Trust(fixable, unsafe)


def _trust_steps(
    choice: Choice, catalogue: Catalogue
) -> Iterator[tuple[Rank, bool, frozenset[str]]]:
    for careful, selectors in (
        (False, choice.extend_safe_fixes),
        (True, choice.extend_unsafe_fixes),
    ):
        for selector in selectors:
            rank, codes = catalogue.find_from(choice.origin, selector)
            yield rank, careful, codes
