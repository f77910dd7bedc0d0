"""Fix texts, round by round, until nothing is left that may be fixed."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.fixes.fix_generator import FixGenerator
from kinlint.fixes.generator import Candidate, MakeGenerator
from kinlint.fixes.offers import Offers, Sieve, accept_all, examine_with_fixes, offer_fixes
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import NOTHING, Analyzer
from kinlint.report import Report
from kinlint.rule import Applicability
from kinlint.text import SourceText

State: TypeAlias = frozenset[tuple[Path, str]]
"""The texts that differ from what they were at first, by their paths."""
ROUNDS = 10
"""Largest number of rounds of changes."""


@dataclass(frozen=True)
class RoundsResult:
    """The outcome of changing texts until nothing is left to change."""

    report: Report
    """The report on the changed texts."""
    texts: Sequence[SourceText]
    changed: Sequence[tuple[SourceText, SourceText]]
    """The texts that changed, before and after; these may be such that others include."""
    restless: Sequence[str]
    """The rules, by their codes, whose fixes undo each other or find no end."""
    left: Offers
    """The trial of what is left."""


def lint_texts(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
) -> Offers:
    """Return what `kinlint.lint.run` finds in *sources*, with the fixes that prove right."""
    spent, texts = phases or Phases(), Texts(sources)
    analyzer = Analyzer(settings, rulebook, trying=True)
    examination = examine_with_fixes(texts, errors, analyzer, spent)
    with spent.phase("fixing"):
        return offer_fixes(FixGenerator(examination, texts, settings, rulebook), analyzer)


def fix_in_rounds(  # noqa: PLR0913, PLR0917
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    least: Applicability,
    phases: Phases | None = None,
    streamed: Collection[str] = (),
    kept: Collection[str] = (),
    wanted: Sieve = accept_all,
    overlay: Mapping[Path, SourceText] = NOTHING,
    generator: MakeGenerator = FixGenerator,
) -> RoundsResult:
    """Make all changes of *generator* in *sources* that may be trusted at *least* so far.

    Of several fixes of a finding the first that may be trusted is made. What the sources include
    is fixed, too, but not what those do that are *streamed*; those called one of *kept* stay as
    they are. Fixes that lead back to texts as they were before are not made, nor those of findings
    that are not *wanted*.
    """
    texts, fixed = Texts(sources, streamed, kept, overlay), list[Finding]()
    originals: dict[Path, SourceText] = {}
    reached: dict[State, tuple[Texts, int]] = {frozenset(): (texts, 0)}
    restless: Sequence[Finding] = ()
    spent, analyzer = phases or Phases(), Analyzer(settings, rulebook, trying=True)
    examination = examine_with_fixes(texts, errors, analyzer, spent)
    for _ in range(ROUNDS):
        with spent.phase("fixing"):
            made = generator(examination, texts, settings, rulebook)
            found = offer_fixes(made, analyzer, least, wanted)
        chosen = list(_chosen(found, least))
        if not chosen:
            restless = ()
            break
        changes = [change for batch in chosen for change in made.combined(batch)]
        for each in changes:
            originals = {**each.sources, **originals}
        texts = texts.rewritten(changes)
        before = len(fixed)
        fixed += [
            replace(each.finding, fixes=(fix,))
            for batch in chosen
            for each in batch
            if (fix := found.fix(each))
        ]
        state = _state(texts, originals)
        if state in reached:
            texts, count = reached[state]
            fixed, restless = fixed[:count], fixed[count:]
            examination = examine_with_fixes(texts, errors, analyzer, spent)
            break
        reached[state] = texts, len(fixed)
        restless = fixed[before:]
        examination = examine_with_fixes(texts, errors, analyzer, spent)
    with spent.phase("fixing"):
        made = generator(examination, texts, settings, rulebook)
        left = offer_fixes(made, analyzer, wanted=wanted)
    if not any(fix.applicability >= least for one in left.report.findings for fix in one.fixes):
        restless = ()
    given = set(map(texts.path, sources))
    pairs = [*zip(sources, texts.given, strict=True)]
    others = originals.keys() - given
    pairs += [(originals[path], text) for path, text in texts.changed.items() if path in others]
    return RoundsResult(
        replace(left.report, fixed=tuple(fixed)),
        texts.given,
        [(before, after) for before, after in pairs if before.text != after.text],
        sorted({one.rule.code for one in restless}),
        left,
    )


def _state(texts: Texts, originals: Mapping[Path, SourceText]) -> State:
    return frozenset(
        (path, source.text)
        for path, source in texts.changed.items()
        if path in originals and source.text != originals[path].text
    )


def _chosen(found: Offers, least: Applicability) -> Iterator[Sequence[Candidate]]:
    """Yield of each model those candidates that were proven together."""
    for group in found.groups:
        if group.held:
            yield max(group.held, key=len)
            continue
        for each in (one for one in found.verdicts if _lies_in(one, group)):
            fix = found.fix(each)
            if fix is not None and fix.applicability >= least:
                yield [each]
                break


def _lies_in(candidate: Candidate, group: Group) -> bool:
    return candidate.kind[0] in group.names
