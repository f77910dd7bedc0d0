"""Fix texts, round by round, until nothing is left that may be fixed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.fixes.fix_circles import FixCircles, Round
from kinlint.fixes.fix_generator import FixGenerator
from kinlint.fixes.generator import Candidate, Generator, MakeGenerator
from kinlint.fixes.offers import (
    LastingKey,
    Offers,
    Sieve,
    accept_all,
    examine_with_fixes,
    lasting_key,
    offer_fixes,
)
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group, Verdict
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import NOTHING, Analyzer, Examination
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
    """The given texts, changed."""
    changed: Sequence[tuple[SourceText, SourceText]]
    """The texts that changed, before and after; these may be such that others include."""
    restless: Sequence[str]
    """The rules, by their codes, whose fixes undo or feed each other, and are not made."""
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
    analyzer = Analyzer(settings, rulebook, trying=True)
    examination = examine_with_fixes(Texts(sources), errors, analyzer, phases)
    return offers(examination, analyzer, sources, settings, rulebook, phases)


def offers(  # noqa: PLR0913, PLR0917
    examination: Examination,
    analyzer: Analyzer,
    sources: Sequence[SourceText],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
    wanted: Sieve = accept_all,
) -> Offers:
    """Return the fixes that prove right of what *analyzer* found in *sources*, an *examination*.

    Only of findings that are *wanted*.
    """
    with (phases or Phases()).phase("fixing"):
        generator = FixGenerator(examination, Texts(sources), settings, rulebook)
        return offer_fixes(generator, analyzer, wanted=wanted, alone=True)


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
    they are. Fixes that undo or feed each other are not made, nor those of findings that are not
    *wanted*.
    """
    start = Texts(sources, streamed, kept, overlay)
    spent, circles = phases or Phases(), FixCircles()
    analyzer = Analyzer(settings, rulebook, trying=True)

    def made(examination: Examination, texts: Texts) -> Generator:
        return generator(examination, texts, settings, rulebook)

    rounds = Rounds(start, errors, analyzer, made, least, wanted, circles, spent)
    while not rounds.come_to_rest():
        rounds = replace(rounds)
    report = replace(rounds.left.report, fixed=tuple(rounds.fixed))
    return RoundsResult(
        report, rounds.texts.given, rounds.changed(), sorted(circles.codes), rounds.left
    )


@dataclass
class Rounds:
    """Rounds of changes, from texts as they are at the *start* until nothing is left to change."""

    start: Texts
    """Texts before the first round."""
    errors: Sequence[SourceError]
    """Errors of files that could not be read."""
    analyzer: Analyzer
    """Analyzer of all texts of the rounds."""
    generator: Callable[[Examination, Texts], Generator]
    """Maker of a generator of changes from an examination and its texts."""
    least: Applicability
    """Lowest applicability of the changes to make."""
    wanted: Sieve
    """Filter of the findings to treat."""
    circles: FixCircles
    """The fixes that are not to be made, as they undo or feed each other."""
    phases: Phases
    """Times of the phases of the run."""
    texts: Texts = field(init=False)
    """The texts after the rounds so far."""
    fixed: list[Finding] = field(init=False)
    """The findings that were fixed, each with its fix."""
    left: Offers = field(init=False)
    """The trial of what is left."""

    def __post_init__(self) -> None:
        self.texts, self.fixed = self.start, []
        self._made: list[Round] = []
        self._originals: dict[Path, SourceText] = {}
        self._settled: dict[LastingKey, Verdict] = {}
        self._untouched: Generator | None = None

    def come_to_rest(self) -> bool:
        """Make rounds until nothing is left to change; False once *circles* has learned why not."""
        reached = [self._state()]
        for _ in range(ROUNDS):
            if not self._turn():
                break
            state = self._state()
            if state in reached:
                self.circles.learn_cycle(self._made[reached.index(state) :])
                return False
            reached.append(state)
        if not self.left.generator.lasting:
            self.left = self._offers(Applicability.DISPLAY)
        fixable = any(one.fix(self.least) for one in self.left.report.findings)
        if len(self._made) < ROUNDS or not fixable:
            return True
        self.circles.learn_growth(self._made)
        return False

    def _turn(self) -> bool:
        """Make what may be made at once; tell whether that was anything."""
        found = self.left = self._offers(self.least)
        chosen = list(_chosen(found, self.least))
        changes = [change for batch in chosen for change in found.generator.combined(batch)]
        for each in changes:
            self._originals = {**each.sources, **self._originals}
        if chosen:
            self.texts, self._untouched = self.texts.rewritten(changes), None
        made = [(each, fix) for batch in chosen for each in batch if (fix := found.fix(each))]
        self.fixed += [replace(each.finding, fixes=(fix,)) for each, fix in made]
        self._made += [[each for each, _ in made]] if chosen else []
        return bool(chosen)

    def _offers(self, least: Applicability) -> Offers:
        made = self._untouched or self.generator(
            examine_with_fixes(self.texts, self.errors, self.analyzer, self.phases), self.texts
        )
        made.refused.clear()
        with self.phases.phase("fixing"):
            found = offer_fixes(
                made,
                self.analyzer,
                least,
                self.wanted,
                circles=self.circles,
                settled=self._settled,
            )
        self._untouched = None if found.verdicts else made
        if made.lasting:
            self._settled |= {
                lasting_key(each): verdict
                for each, verdict in found.verdicts.items()
                if verdict.applicability is not Applicability.SAFE
            }
        return found

    def _state(self) -> State:
        return frozenset(
            (path, source.text)
            for path, source in self.texts.changed.items()
            if path in self._originals and source.text != self._originals[path].text
        )

    def changed(self) -> Sequence[tuple[SourceText, SourceText]]:
        """Return the texts that changed, before and after, with such as others include."""
        given = set(map(self.texts.path, self.start.given))
        pairs = [*zip(self.start.given, self.texts.given, strict=True)]
        others = self._originals.keys() - given
        pairs += [
            (self._originals[path], text)
            for path, text in self.texts.changed.items()
            if path in others
        ]
        return [(before, after) for before, after in pairs if before.text != after.text]


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
