"""Mends texts, round by round, until nothing is left that may be mended."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.fixes.candidate import Candidate
from kinlint.fixes.offers import Offers, Sieve, every, offers
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group
from kinlint.lint import NOTHING, Examination, examine
from kinlint.model import Applicability, Finding
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.text import SourceText

State: TypeAlias = frozenset[tuple[Path, str]]
"""The texts that differ from what they were at first, by their paths."""
ROUNDS = 10
"""How often mending may bring about something else to mend."""


@dataclass(frozen=True)
class Mended:
    """What is left to find in `texts`, and what `changed`, each with what it was before.

    These may also be texts that others include. `restless` are the rules, by their codes, whose
    fixes undo each other or find no end.
    """

    report: Report
    texts: Sequence[SourceText]
    changed: Sequence[tuple[SourceText, SourceText]]
    restless: Sequence[str] = ()


def linted(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
) -> Offers:
    """What `kinlint.lint.run` finds in *sources*, with the fixes that prove right."""
    spent, texts = phases or Phases(), Texts(sources)
    examination = _examined(texts, errors, settings, rulebook, spent)
    with spent.phase("fixing"):
        return offers(examination, texts, settings, rulebook)


def mended(  # noqa: PLR0913, PLR0917
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    least: Applicability,
    phases: Phases | None = None,
    streamed: Collection[str] = (),
    kept: Collection[str] = (),
    wanted: Sieve = every,
    overlay: Mapping[Path, SourceText] = NOTHING,
) -> Mended:
    """*sources* after all fixes that may be trusted at *least* so far, and what is left to find.

    Of several fixes of a finding the first that may be trusted is made. What the sources include
    is mended, too, but not what those do that are *streamed*; those called one of *kept* stay as
    they are. Fixes that lead back to texts as they were before are not made, nor those of findings
    that are not *wanted*.
    """
    texts, fixed = Texts(sources, streamed, kept, overlay), list[Finding]()
    originals: dict[Path, SourceText] = {}
    reached: dict[State, tuple[Texts, int]] = {frozenset(): (texts, 0)}
    restless: Sequence[Finding] = ()
    spent = phases or Phases()
    examination = _examined(texts, errors, settings, rulebook, spent)
    for _ in range(ROUNDS):
        with spent.phase("fixing"):
            found = offers(examination, texts, settings, rulebook, least, wanted)
        chosen = list(_chosen(found, least))
        if not chosen:
            restless = ()
            break
        for each in chosen:
            originals = {**each.sources, **originals}
        texts = texts.rewritten(chosen)
        fixed += [
            replace(each.finding, fixes=(fix,)) for each in chosen if (fix := found.fix(each))
        ]
        state = _state(texts, originals)
        if state in reached:
            texts, count = reached[state]
            fixed, restless = fixed[:count], fixed[count:]
            examination = _examined(texts, errors, settings, rulebook, spent)
            break
        reached[state] = texts, len(fixed)
        restless = fixed[-len(chosen) :]
        examination = _known(found, texts, errors) or _examined(
            texts, errors, settings, rulebook, spent
        )
    with spent.phase("fixing"):
        left = offers(examination, texts, settings, rulebook, wanted=wanted)
    if not any(fix.applicability >= least for one in left.report.findings for fix in one.fixes):
        restless = ()
    given = set(map(texts.path, sources))
    pairs = [*zip(sources, texts.given, strict=True)]
    others = originals.keys() - given
    pairs += [(originals[path], text) for path, text in texts.changed.items() if path in others]
    return Mended(
        replace(left.report, fixed=tuple(fixed)),
        texts.given,
        [(before, after) for before, after in pairs if before.text != after.text],
        sorted({one.rule.code for one in restless}),
    )


def _known(found: Offers, texts: Texts, errors: Collection[SourceError]) -> Examination | None:
    """What was found in *texts* when they were tried, which is all unless there were *errors*."""
    if errors or found.latest is None or not found.latest[0].same(texts):
        return None
    return found.latest[1]


def _state(texts: Texts, originals: Mapping[Path, SourceText]) -> State:
    return frozenset(
        (path, source.text)
        for path, source in texts.changed.items()
        if path in originals and source.text != originals[path].text
    )


def _examined(
    texts: Texts,
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None,
) -> Examination:
    return examine(
        texts.given, errors, settings, rulebook, phases, repairing=True, overlay=texts.changed
    )


def _chosen(found: Offers, least: Applicability) -> Iterable[Candidate]:
    """Candidates that were proven together, of each model those of one batch."""
    for group in found.groups:
        if group.held:
            yield from max(group.held, key=len)
            continue
        for each in (one for one in found.verdicts if _lies_in(one, group)):
            fix = found.fix(each)
            if fix is not None and fix.applicability >= least:
                yield each
                break


def _lies_in(candidate: Candidate, group: Group) -> bool:
    return candidate.finding.location.source.name in group.names
