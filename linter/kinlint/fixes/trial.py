"""Tries candidates together: writes them, reads and lints again, and splits what did not hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from kinlint.document import Document
from kinlint.edits import Delta, Edit, overlap
from kinlint.fixes.candidate import Candidate
from kinlint.fixes.proof import proven
from kinlint.fixes.texts import Texts
from kinlint.lint import Examination
from kinlint.model import Applicability, Finding
from kinlint.terms import Term
from kinlint.text import SourceText

STEPS = 24
"""How often a run is linted again at most; what is undecided then is not offered."""

Examine = Callable[[Texts], Examination]
Kind = tuple[str, str]


@dataclass(frozen=True)
class Verdict:
    """What a trial showed of candidates: how far they may be trusted, None if they may not be.

    `blamed` are the kinds of findings that stay, with how many do.
    """

    applicability: Applicability | None
    why: str = ""
    blamed: Mapping[Kind, int] = field(default_factory=dict)


@dataclass(eq=False)
class Group:
    """Texts that say nothing of others, with the batches of candidates to try in them.

    `documents` are what they say. `held` are those batches that proved as claimed, each as a whole.
    """

    sources: Sequence[SourceText]
    documents: Sequence[Document]
    batches: list[list[Candidate]] = field(default_factory=list)
    held: list[list[Candidate]] = field(default_factory=list)

    @cached_property
    def names(self) -> frozenset[str]:
        """What the texts are called, with those that they include."""
        inside = (source.name for each in self.documents for source in each.sources)
        return frozenset((*inside, *(source.name for source in self.sources)))


def batches(candidates: Iterable[Candidate]) -> Iterator[list[Candidate]]:
    """*candidates* in batches that can be written together: the preferred of each finding first.

    Findings that the same edits mend are mended together.
    """
    left = sorted(candidates, key=lambda each: (each.rank, each.finding.sort_key))
    while left:
        batch, later = list[Candidate](), list[Candidate]()
        taken: dict[Path, list[Edit]] = {}
        mended = set[int]()
        for each in left:
            clash = id(each.finding) in mended or any(
                overlap(edits, taken.get(path, ())) and not set(edits) <= set(taken.get(path, ()))
                for path, edits in each.edits.items()
            )
            (later if clash else batch).append(each)
            if not clash:
                mended.add(id(each.finding))
                for path, edits in each.edits.items():
                    taken.setdefault(path, []).extend(edits)
        yield batch
        left = later


def tried(
    groups: Sequence[Group], texts: Texts, before: Examination, examine: Examine
) -> Mapping[Candidate, Verdict]:
    """The verdict on each candidate in the batches of *groups*; those that hold are noted there.

    *texts* are those that were examined *before*.

    Groups are linted together. A batch that does not hold is tried again in halves.
    """
    counts = _counts(before.report.findings)
    lost = frozenset(error.name for error in before.report.errors)
    verdicts: dict[Candidate, Verdict] = {}
    for _ in range(STEPS):
        trial = [(group, group.batches.pop(0)) for group in groups if group.batches]
        if not trial:
            break
        given = replace(texts, given=[text for group, _ in trial for text in group.sources])
        after = examine(given.rewritten(each for _, batch in trial for each in batch))
        for group, batch in trial:
            verdict = _verdict(group, batch, texts, after, counts, lost)
            if verdict.applicability and _claim(batch) <= verdict.applicability:
                group.held.append(batch)
                verdicts.update((each, Verdict(each.repair.applicability)) for each in batch)
            else:
                useless = batch if len(batch) == 1 else list(_useless(batch, verdict))
                verdicts.update(dict.fromkeys(useless, verdict))
                left = [each for each in batch if each not in verdicts]
                if left:
                    whole = len(left) == len(batch)
                    group.batches[:0] = _parts(left, verdict) if whole else [left]
    for group in groups:
        for batch in group.batches:
            verdicts.update(dict.fromkeys(batch, Verdict(None, "it could not be tried in time")))
    return verdicts


def _claim(batch: Iterable[Candidate]) -> Applicability:
    """The most that one of *batch* claims."""
    return max(each.repair.applicability for each in batch)


def _useless(batch: Iterable[Candidate], verdict: Verdict) -> Iterator[Candidate]:
    """Those of *batch* that mend findings of a kind of which all stay."""
    kinds = Counter(_kind(each.finding) for each in batch)
    for each in batch:
        kind = _kind(each.finding)
        if verdict.blamed.get(kind, 0) >= kinds[kind]:
            yield each


def _parts(batch: Sequence[Candidate], verdict: Verdict) -> list[list[Candidate]]:
    """*batch* in two: by who is blamed, or else by what they claim, by rules, or in halves."""
    blamed = [each for each in batch if _kind(each.finding) in verdict.blamed]
    if 0 < len(blamed) < len(batch):
        return [[each for each in batch if each not in blamed], blamed]
    trusted = [each for each in batch if each.repair.applicability is Applicability.SAFE]
    if 0 < len(trusted) < len(batch):
        return [trusted, [each for each in batch if each not in trusted]]
    codes = list(dict.fromkeys(each.finding.rule.code for each in batch))
    few = set(codes[: len(codes) // 2])
    first = [each for each in batch if each.finding.rule.code in few] or batch[: len(batch) // 2]
    return [list(first), [each for each in batch if each not in first]]


def _verdict(  # noqa: PLR0913, PLR0917
    group: Group,
    batch: Sequence[Candidate],
    texts: Texts,
    after: Examination,
    counts: Counter[Kind],
    lost: Collection[str],
) -> Verdict:
    """Whether *batch* does what it promises, SAFE if so, and UNSAFE if it leads to findings.

    Texts that were *lost* before need not be readable.
    """
    unread = {error.name for error in after.report.errors}.difference(lost)
    if any(source.name in unread for source in group.sources):
        return Verdict(None, "the text could not be read then")
    if not _all_say(group, batch, texts, after):
        return Verdict(None, "the text would say something else")
    if not all(_means(each, after) for each in batch):
        return Verdict(None, "the text would mean something else")
    names = group.names
    left = counts - _counts({id(each.finding): each.finding for each in batch}.values())
    now = _counts(one for one in after.report.findings if one.location.source.name in names)
    more = {kind: number for kind, number in (now - left).items() if kind[0] in names}
    mended = {_kind(each.finding) for each in batch}
    stay = {kind: number for kind, number in more.items() if kind in mended}
    if stay:
        return Verdict(None, "the finding would stay", stay)
    if more:
        codes = ", ".join(sorted({code for _, code in more}))
        return Verdict(Applicability.UNSAFE, f"it brings {codes} to light")
    return Verdict(Applicability.SAFE)


def _all_say(group: Group, batch: Sequence[Candidate], texts: Texts, after: Examination) -> bool:
    """Whether all documents with a text that *batch* edits changed as it promises, and no other."""
    graphs = {each.graph for each in group.documents}
    if not all(graphs.issuperset(each.deltas) for each in batch):
        return False
    edited = {path for each in batch for path in each.edits}
    for old in group.documents:
        if edited.isdisjoint(texts.paths(old)):
            continue
        new = after.store.documents.get(old.graph)
        if new is None or not _says(old, new, batch, [*texts.paths(old)]):
            return False
    return True


def _says(old: Document, new: Document, batch: Iterable[Candidate], paths: Sequence[Path]) -> bool:
    """Whether *new* is *old*, which is read from *paths*, with what *batch* changes in it."""
    apart = {tuple(map(each.edits.get, paths)): each for each in batch}.values()
    deltas = [each.deltas[old.graph] for each in apart if old.graph in each.deltas]
    removed = dict.fromkeys(triple for each in deltas for triple in each.removed)
    added = dict.fromkeys(
        tuple(_apart(term, number) for term in triple)
        for number, each in enumerate(deltas)
        for triple in each.added
    )
    return proven(old, new, Delta(tuple(removed), tuple(added)))  # type: ignore[arg-type]


def _apart(term: Term, number: int) -> Term:
    """*term*, told apart from new nodes of the same name in other changes."""
    return f"_:new{number}of{term[5:]}" if term.startswith("_:new") else term


def _means(candidate: Candidate, after: Examination) -> bool:
    """Whether what is lifted changed as *candidate* says."""
    lifted = candidate.lifted
    return all(map(after.store.says, lifted.added)) and not any(
        map(after.store.is_lifted, lifted.removed)
    )


def _kind(finding: Finding) -> Kind:
    return finding.location.source.name, finding.rule.code


def _counts(findings: Iterable[Finding]) -> Counter[Kind]:
    return Counter(map(_kind, findings))
