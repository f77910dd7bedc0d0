"""Suppressions of findings, proven: read again a text says the same, and they are silent."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.edits import Delta, Unsayable
from kinlint.errors import SourceError
from kinlint.fixes.offers import Sieve, every
from kinlint.fixes.proof import proven
from kinlint.fixes.texts import Texts
from kinlint.ignoring.proposal import Desk, Proposal
from kinlint.lint import Examination, examine
from kinlint.model import Finding
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.text import SourceText

UNREASONED = "the configuration requires a reason, as in --add-ignore='set at run time'"
Kind = tuple[str, str]
Refusal = tuple[Finding, str]


@dataclass(frozen=True)
class Ignored:
    """What is left to find, and what `changed`, each text with what it was before.

    `done` is silenced now; `refused` are findings that cannot be, with the reasons.
    """

    report: Report
    changed: Sequence[tuple[SourceText, SourceText]]
    done: Sequence[Finding]
    refused: Sequence[Refusal]


def ignored(  # noqa: PLR0913, PLR0917
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    reason: str | None = None,
    wanted: Sieve = every,
    phases: Phases | None = None,
    streamed: Collection[str] = (),
    kept: Collection[str] = (),
) -> Ignored:
    """*sources* with suppressions of those of their findings that are *wanted*.

    What the sources include is written, too, but not for those that are *streamed*, and not those
    that are *kept*.
    """
    spent, texts = phases or Phases(), Texts(sources, streamed, kept)
    before = examine(sources, errors, settings, rulebook, spent)
    with spent.phase("ignoring"):
        trial = _Trial(
            texts, errors, settings, rulebook, before, Desk(before, texts, settings, reason)
        )
        found = [one for one in wanted(before.report.findings) if trial.sayable(one)]
        trial.settle(found)
        return trial.outcome()


class _Trial:
    """Tries suppressions together, and in halves where they do not hold."""

    def __init__(  # noqa: PLR0913, PLR0917
        self,
        texts: Texts,
        errors: Sequence[SourceError],
        settings: Settings,
        rulebook: Rulebook,
        before: Examination,
        desk: Desk,
    ) -> None:
        self._texts, self._errors, self._desk = texts, errors, desk
        self._settings, self._rulebook, self._before = settings, rulebook, before
        self._after, self._made, self._done = before, texts, list[Finding]()
        self.refused: list[Refusal] = []

    def sayable(self, finding: Finding) -> bool:
        """Whether *finding* can be silenced at all, else the reason is noted."""
        try:
            self._desk.proposal([finding])
        except Unsayable as reason:
            self.refused.append((finding, str(reason)))
            return False
        own = self._settings.of(finding.location.source.name)
        if own.require_reason and not self._desk.reason:
            self.refused.append((finding, UNREASONED))
            return False
        return True

    def settle(self, findings: Sequence[Finding]) -> None:
        """Silence as many of *findings* as hold together with those that do already."""
        if not findings:
            return
        problem, blamed = self._problem([*self._done, *findings])
        if not problem:
            self._done += findings
        elif len(findings) == 1:
            self.refused.append((findings[0], problem))
        else:
            middle = len(findings) // 2
            parts = findings[:middle], findings[middle:]
            kinds = [each for each in findings if _kind(each) in blamed]
            if 0 < len(kinds) < len(findings):
                parts = [each for each in findings if _kind(each) not in blamed], kinds
            for part in parts:
                self.settle(part)

    def outcome(self) -> Ignored:
        """What came of it."""
        given = set(map(self._texts.path, self._texts.given))
        originals = {
            self._texts.path(text): text
            for document in self._before.documents
            for text in document.sources
        }
        pairs = [*zip(self._texts.given, self._made.given, strict=True)]
        pairs += [
            (originals[path], text)
            for path, text in self._made.changed.items()
            if path not in given
        ]
        changed = [(before, after) for before, after in pairs if before.text != after.text]
        refused = sorted(self.refused, key=lambda one: one[0].sort_key)
        return Ignored(self._after.report, changed, self._done, refused)

    def _problem(self, findings: Sequence[Finding]) -> tuple[str, Collection[Kind]]:
        """Why *findings* cannot be silenced together; if they can, they are, and it is empty.

        With it come the kinds of those that would stay.
        """
        try:
            proposal = self._desk.proposal(findings)
        except Unsayable as reason:
            return str(reason), ()
        made = self._texts.rewritten([proposal])
        after = examine(
            made.given, self._errors, self._settings, self._rulebook, overlay=made.changed
        )
        problem, blamed = self._objection(findings, proposal, after)
        if not problem:
            self._after, self._made = after, made
        return problem, blamed

    def _objection(
        self, findings: Sequence[Finding], proposal: Proposal, after: Examination
    ) -> tuple[str, Collection[Kind]]:
        if len(after.report.errors) > len(self._before.report.errors):
            return "the text could not be read then", ()
        paths = set(proposal.edits)
        for old in self._before.documents:
            if paths.isdisjoint(self._texts.paths(old)):
                continue
            new = after.store.documents.get(old.graph)
            if new is None or not proven(old, new, proposal.deltas.get(old.graph, Delta())):
                return "the text would say something else", ()
        left = _counts(self._before.report.findings) - _counts(findings)
        more = _counts(after.report.findings) - left
        if not more:
            return "", ()
        stay = {_kind(each) for each in findings} & more.keys()
        if stay:
            return "it would be found all the same", stay
        codes = ", ".join(sorted({code for _, code in more}))
        return f"it brings {codes} to light", ()


def _kind(finding: Finding) -> Kind:
    return finding.location.source.name, finding.rule.code


def _counts(findings: Iterable[Finding]) -> Counter[Kind]:
    return Counter(map(_kind, findings))
