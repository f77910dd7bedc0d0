"""Offers fixes: for each finding of a run the repairs that can be written and hold."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.file_groups import models
from kinlint.fixes.candidate import Candidate, Workshop
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group, Verdict, batches, tried
from kinlint.fixes.wording import update
from kinlint.lint import Examination, examine
from kinlint.model import Applicability, Finding, Fix, Repair, TextEdit
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.terms import Term
from kinlint.text import Location, SourceText

Refusal = tuple[Finding, Repair, str]
Sieve = Callable[[Sequence[Finding]], Sequence[Finding]]
"""What tells which of the findings of a run are to be mended."""


def every(findings: Sequence[Finding]) -> Sequence[Finding]:
    """All *findings*."""
    return findings


@dataclass(frozen=True)
class Offers:
    """What can be mended: verdicts on candidates, and `refused` repairs with the reasons.

    `latest` are the texts that were tried last, with what was found in them.
    """

    examination: Examination
    policies: Policies
    groups: Sequence[Group]
    verdicts: Mapping[Candidate, Verdict]
    refused: Sequence[Refusal]
    latest: tuple[Texts, Examination] | None = None

    def fix(self, candidate: Candidate) -> Fix | None:
        """*candidate* as far as it may be trusted; None if it may not be."""
        verdict, repair = self.verdicts[candidate], candidate.repair
        if verdict.applicability is None:
            return None
        applicability = min(verdict.applicability, repair.applicability)
        edits = [
            TextEdit(Location(candidate.sources[path], edit.span), edit.text)
            for path, made in candidate.edits.items()
            for edit in made
        ]
        fix = Fix(
            title=self.examination.account.filled(repair.title, candidate.finding),
            applicability=applicability,
            edits=tuple(
                sorted(edits, key=lambda one: (one.location.source.name, one.location.span))
            ),
            update=update(candidate.meant),
            removed=candidate.meant.removed,
            added=candidate.meant.added,
            why="" if applicability is Applicability.SAFE else verdict.why or repair.why,
        )
        name, rule = candidate.finding.location.source.name, candidate.finding.rule
        return self.policies.trust(name).weighed_fix(rule, fix)

    @property
    def report(self) -> Report:
        """The report of the examination, its findings with the fixes that are offered."""
        by_finding: dict[int, list[Candidate]] = {}
        for each in self.verdicts:
            by_finding.setdefault(id(each.finding), []).append(each)
        findings = []
        for finding in self.examination.report.findings:
            own = sorted(by_finding.get(id(finding), ()), key=lambda each: each.rank)
            fixes = tuple(fix for each in own if (fix := self.fix(each)) is not None)
            findings.append(replace(finding, fixes=fixes) if fixes else finding)
        unfixed = tuple(self.refused)
        return replace(self.examination.report, findings=tuple(findings), unfixed=unfixed)


def offers(  # noqa: PLR0913, PLR0917
    examination: Examination,
    texts: Texts,
    settings: Settings,
    rulebook: Rulebook,
    least: Applicability = Applicability.DISPLAY,
    wanted: Sieve = every,
    phases: Phases | None = None,
) -> Offers:
    """What can be mended of what *examination* found in *texts*, where the settings want it.

    Candidates that the settings trust less than *least* are not tried, nor are those for findings
    that are not *wanted*. The phases of the trials are told to *phases*.
    """
    policies, workshop = Policies(settings, rulebook.rules), Workshop(examination, texts, settings)
    found = []
    for finding in wanted(examination.report.findings):
        trust = policies.trust(finding.location.source.name)
        if finding.rule.repairs and trust.mends(finding.rule):
            found += [
                each
                for each in workshop.candidates(finding)
                if trust.applicability(finding.rule, each.repair.applicability) >= least
            ]
    groups = _groups(found, examination, texts) if found else []

    latest = None

    def again(tried: Texts) -> Examination:
        nonlocal latest
        found = examine(
            tried.given, (), settings, rulebook, phases, repairing=True, overlay=tried.changed
        )
        latest = tried, found
        return found

    verdicts = tried(groups, texts, examination, again) if groups else {}
    refused = [*workshop.unsaid]
    refused += [
        (each.finding, each.repair, verdict.why)
        for each, verdict in verdicts.items()
        if verdict.applicability is None
    ]
    return Offers(examination, policies, groups, verdicts, refused, latest)


def _groups(candidates: Iterable[Candidate], examination: Examination, texts: Texts) -> list[Group]:
    """The models that *candidates* change, with these in batches."""
    documents = {each.source.name: each for each in examination.documents}
    by_graph: dict[Term, list[Candidate]] = {}
    for each in candidates:
        for graph in each.deltas:
            by_graph.setdefault(graph, []).append(each)
    groups = []
    for sources in _apart(texts, documents):
        said = [documents[each.name] for each in sources if each.name in documents]
        inside = [each for document in said for each in by_graph.get(document.graph, ())]
        if inside:
            groups.append(Group(sources, said, list(batches(dict.fromkeys(inside)))))
    return groups


def _apart(texts: Texts, documents: Mapping[str, Document]) -> Iterable[Sequence[SourceText]]:
    """The given *texts* in groups that neither say anything of each other nor share a file."""
    groups: dict[int, list[SourceText]] = {}
    users: dict[Path, int] = {}
    for number, model in enumerate(models(texts.given)):
        said = [documents[each.name] for each in model if each.name in documents]
        paths = {path for document in said for path in texts.paths(document)}
        known = {users[path] for path in paths if path in users}
        joined = [source for each in sorted(known) for source in groups.pop(each)]
        groups[number] = [*joined, *model]
        users |= {path: number for path, user in users.items() if user in known} if known else {}
        users |= dict.fromkeys(paths, number)
    return groups.values()
