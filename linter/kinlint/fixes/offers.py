"""Offers fixes: for each finding of a run the repairs that can be written and hold."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import TypeAlias

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.finding import Finding, Fix
from kinlint.fixes.fix_circles import BARRED, FixCircles
from kinlint.fixes.generator import Candidate, Generator, Refusal
from kinlint.fixes.sparql_update import render_update
from kinlint.fixes.texts import Texts
from kinlint.fixes.trial import Group, Verdict, try_candidates
from kinlint.formats.dependencies.file_groups import group_sources
from kinlint.light_dataclasses import dataclass, replace
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import Analyzer, Examination
from kinlint.report import Report
from kinlint.rule import Applicability
from kinlint.terms import Term
from kinlint.text import SourceText

Sieve = Callable[[Sequence[Finding]], Sequence[Finding]]
"""Predicate that selects the findings of a run to fix."""


LastingKey: TypeAlias = tuple[str, str, str, str]
"""The rule, the file, the entity and the message of a finding, wherever it stands."""
NOTHING_SETTLED: Mapping[LastingKey, Verdict] = MappingProxyType({})


def lasting_key(candidate: Candidate) -> LastingKey:
    """Return what the finding of *candidate* is recognised by in a changed text."""
    finding = candidate.finding
    return finding.rule.code, finding.location.source.name, finding.iri, finding.message


def accept_all(findings: Sequence[Finding]) -> Sequence[Finding]:
    """Return all *findings*."""
    return findings


@dataclass(frozen=True)
class Offers:
    """The candidates that hold, for the findings of an examination."""

    generator: Generator
    """Generator of the candidates."""
    groups: Sequence[Group]
    """Groups of texts in which candidates were tried."""
    verdicts: Mapping[Candidate, Verdict]
    """The candidates that were tried, with what their trials showed."""
    refused: Sequence[Refusal]
    """The repairs that cannot be made, with the reasons."""

    def fix(self, candidate: Candidate) -> Fix | None:
        """Return *candidate* as far as it may be trusted; None if it may not be."""
        verdict, repair = self.verdicts[candidate], candidate.repair
        if verdict.applicability is None:
            return None
        applicability = min(verdict.applicability, repair.applicability)
        fix = Fix(
            title=candidate.title,
            applicability=applicability,
            edits=candidate.text_edits,
            update=render_update(candidate.meant),
            removed=candidate.meant.removed,
            added=candidate.meant.added,
            why="" if applicability is Applicability.SAFE else verdict.why or repair.why,
        )
        return self.generator.weighed(candidate.finding, fix)

    @property
    def report(self) -> Report:
        """The report of the examination, its findings with the fixes that are offered."""
        report = self.generator.examination.report
        by_finding: dict[int, list[Candidate]] = {}
        for each in self.verdicts:
            by_finding.setdefault(id(each.finding), []).append(each)
        findings = []
        for finding in report.findings:
            own = sorted(by_finding.get(id(finding), ()), key=lambda each: each.rank)
            fixes = tuple(fix for each in own if (fix := self.fix(each)) is not None)
            findings.append(replace(finding, fixes=fixes) if fixes else finding)
        unfixed = tuple(self.refused)
        return replace(report, findings=tuple(findings), unfixed=unfixed)


def offer_fixes(  # noqa: PLR0913, PLR0917
    generator: Generator,
    analyzer: Analyzer,
    least: Applicability = Applicability.DISPLAY,
    wanted: Sieve = accept_all,
    phases: Phases | None = None,
    circles: FixCircles | None = None,
    settled: Mapping[LastingKey, Verdict] = NOTHING_SETTLED,
    *,
    alone: bool = False,
) -> Offers:
    """Return which candidates of *generator* hold when they are tried by *analyzer*.

    That is the one of its examination, whose store then says what the texts tried last say.
    Candidates that the settings trust less than *least* are not tried, nor are those for findings
    that are not *wanted*, nor those that *circles* bar or that are *settled* by an earlier trial.
    If *alone*, texts without candidates are left aside, and the store then says nothing of them.
    The time of trials is added to *phases*.
    """
    found = generator.candidates(wanted(generator.examination.report.findings), least)
    barred = dict.fromkeys(each for each in found if circles is not None and circles.bars(each))
    found = [each for each in found if each not in barred]
    known = {each: settled[key] for each in found if (key := lasting_key(each)) in settled}
    found = [each for each in found if each not in known]
    groups = _groups(found, generator) if found else []
    # What cannot be read decides which suppressions of other texts are told to be unused.
    alone = alone and not generator.examination.report.errors

    def again(texts: Texts) -> Examination:
        return examine_with_fixes(texts, (), analyzer, phases, brief=True)

    tried = try_candidates(groups, generator, again, alone=alone) if groups else {}
    verdicts = {**tried, **known}
    refused = [*generator.refused, *((each.finding, each.repair, BARRED) for each in barred)]
    refused += [
        (each.finding, each.repair, verdict.why)
        for each, verdict in verdicts.items()
        if verdict.applicability is None
    ]
    return Offers(generator, groups, verdicts, refused)


def examine_with_fixes(
    texts: Texts,
    errors: Iterable[SourceError],
    analyzer: Analyzer,
    phases: Phases | None,
    *,
    brief: bool = False,
) -> Examination:
    """Lint *texts* by *analyzer*, with all that repairs ask for unless *brief*."""
    return analyzer.examine(
        texts.given, errors, phases, repairing=True, brief=brief, overlay=texts.changed
    )


def _groups(candidates: Iterable[Candidate], generator: Generator) -> list[Group]:
    """Return the models that *candidates* change, with these in batches."""
    documents = {each.source.name: each for each in generator.examination.documents}
    by_graph: dict[Term, list[Candidate]] = {}
    for each in candidates:
        for graph in each.deltas:
            by_graph.setdefault(graph, []).append(each)
    groups = []
    for sources in _apart(generator.texts, documents):
        said = [documents[each.name] for each in sources if each.name in documents]
        inside = [each for document in said for each in by_graph.get(document.graph, ())]
        if inside:
            batches = generator.batches([*dict.fromkeys(inside)])
            groups.append(Group(sources, said, list(batches)))
    return groups


def _apart(texts: Texts, documents: Mapping[str, Document]) -> Iterable[Sequence[SourceText]]:
    """The given *texts* in groups that neither say anything of each other nor share a file."""
    groups: dict[int, list[SourceText]] = {}
    users: dict[Path, int] = {}
    for number, model in enumerate(group_sources(texts.given)):
        said = [documents[each.name] for each in model if each.name in documents]
        paths = {path for document in said for path in texts.paths(document)}
        known = {users[path] for path in paths if path in users}
        joined = [source for each in sorted(known) for source in groups.pop(each)]
        groups[number] = [*joined, *model]
        users |= {path: number for path, user in users.items() if user in known} if known else {}
        users |= dict.fromkeys(paths, number)
    return groups.values()
