"""Which fixes are wanted in a file, and how far they are trusted there.

Selectors are those of the rules. As with these, a higher layer replaces or changes what a lower
one said, the more specific selector wins, and of equals the more careful one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from dataclasses import replace as changed

from kinlint.configuration.selectors import ALL, Catalogue, Rank, narrowed
from kinlint.configuration.settings import Choice
from kinlint.model import Applicability, Fix, Rule


@dataclass(frozen=True, slots=True)
class Trust:
    """What choices say of fixes: the rules that may be mended, and what their fixes count as.

    `unsafe` has, by code, whether the fixes of a rule count as unsafe whatever they are; False
    is that unsafe ones count as safe.
    """

    fixable: frozenset[str]
    unsafe: Mapping[str, bool]

    def mends(self, rule: Rule) -> bool:
        """Whether fixes of what *rule* finds are wanted at all."""
        return rule.code in self.fixable

    def applicability(self, rule: Rule, proven: Applicability) -> Applicability:
        """What a fix of *rule* counts as that is *proven* so far.

        What is for display only stays so.
        """
        said = self.unsafe.get(rule.code)
        if said is None or proven is Applicability.DISPLAY:
            return proven
        return Applicability.UNSAFE if said else Applicability.SAFE

    def weighed_fix(self, rule: Rule, fix: Fix) -> Fix:
        """*fix* of what *rule* found, counting as what it counts as here."""
        applicability = self.applicability(rule, fix.applicability)
        if applicability is fix.applicability:
            return fix
        why = "" if applicability is Applicability.SAFE else "the configuration calls it unsafe"
        return changed(fix, applicability=applicability, why=why)


def trust(choices: Iterable[Choice], catalogue: Catalogue) -> Trust:
    """What *choices*, the lowest layer first, say of fixes; at first, all are wanted.

    Raises `UsageError` for selectors that name no rule.
    """
    fixable = catalogue.find(ALL)[1]
    unsafe: dict[str, bool] = {}
    for choice in choices:
        below = fixable if choice.fixable is None else frozenset[str]()
        fixable = narrowed(below, choice.fixable or (), choice.unfixable, choice.origin, catalogue)
        for _, careful, codes in sorted(_said(choice, catalogue), key=lambda step: step[:2]):
            unsafe.update(dict.fromkeys(codes, careful))
    return Trust(fixable, unsafe)


def _said(choice: Choice, catalogue: Catalogue) -> Iterator[tuple[Rank, bool, frozenset[str]]]:
    for careful, selectors in (
        (False, choice.extend_safe_fixes),
        (True, choice.extend_unsafe_fixes),
    ):
        for selector in selectors:
            rank, codes = catalogue.find_from(choice.origin, selector)
            yield rank, careful, codes
