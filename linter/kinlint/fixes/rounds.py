"""Mends texts, round by round, until nothing is left that may be mended."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.fixes.candidate import Candidate
from kinlint.fixes.offers import Offers, offers
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group
from kinlint.lint import Examination, examine
from kinlint.model import Applicability, Finding
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.text import SourceText

ROUNDS = 10
"""How often mending may bring about something else to mend."""


@dataclass(frozen=True)
class Mended:
    """What is left to find in `texts`, and what `changed`, each with what it was before.

    These may also be texts that others include.
    """

    report: Report
    texts: Sequence[SourceText]
    changed: Sequence[tuple[SourceText, SourceText]]


def linted(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
) -> Offers:
    """What `kinlint.lint.run` finds in *sources*, with the fixes that prove right."""
    return _linted(Texts(sources), errors, settings, rulebook, phases)


def _linted(
    texts: Texts,
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None,
) -> Offers:
    spent = phases or Phases()
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
) -> Mended:
    """*sources* after all fixes that may be trusted at *least* so far, and what is left to find.

    Of several fixes of a finding the first that may be trusted is made. What the sources include
    is mended, too, but not what those do that are *streamed*.
    """
    texts, fixed = Texts(sources, streamed), list[Finding]()
    included: dict[Path, SourceText] = {}
    for _ in range(ROUNDS):
        examination = _examined(texts, errors, settings, rulebook, phases)
        found = offers(examination, texts, settings, rulebook, least)
        chosen = list(_chosen(found, least))
        if not chosen:
            break
        for each in chosen:
            included = {**each.sources, **included}
        texts = texts.rewritten(chosen)
        fixed += [
            replace(each.finding, fixes=(fix,)) for each in chosen if (fix := found.fix(each))
        ]
    left = _linted(texts, errors, settings, rulebook, phases)
    given = set(map(texts.path, sources))
    pairs = [*zip(sources, texts.given, strict=True)]
    pairs += [
        (source, texts.changed[path]) for path, source in included.items() if path not in given
    ]
    return Mended(
        replace(left.report, fixed=tuple(fixed)),
        texts.given,
        [(before, after) for before, after in pairs if before.text != after.text],
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
