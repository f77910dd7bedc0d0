"""Tries candidates together: writes them, reads and lints again, and splits what did not hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from kinlint.document import Document
from kinlint.edits import Delta, NotExpressible
from kinlint.fixes.generator import Candidate, FileKind, Generator, counts
from kinlint.fixes.proof import is_exact_change
from kinlint.fixes.texts import Texts
from kinlint.light_dataclasses import dataclass, field
from kinlint.pipeline.analyzer import Examination
from kinlint.rule import Applicability
from kinlint.terms import Term
from kinlint.text import SourceText

STEPS = 24
"""Largest number of times a run is linted again; candidates undecided then are not offered."""

Examine = Callable[[Texts], Examination]


@dataclass(frozen=True)
class Verdict:
    """The result of a trial of candidates."""

    applicability: Applicability | None
    """Applicability that was proven; None if the candidates must not be applied."""
    why: str = ""
    """The reason for trusting them no further."""
    blamed: Mapping[FileKind, int] = field(default_factory=dict)
    """The kinds of findings that stay, with how many do."""


@dataclass(eq=False)
class Group:
    """Texts that say nothing of others, with the batches of candidates to try in them."""

    sources: Sequence[SourceText]
    """Texts of the group."""
    documents: Sequence[Document]
    """The documents parsed from the texts."""
    batches: list[list[Candidate]] = field(default_factory=list)
    """The batches that are still to be tried."""
    held: list[list[Candidate]] = field(default_factory=list)
    """The batches that proved as claimed, each as a whole."""
    doubted: tuple[list[Candidate], list[Candidate]] | None = None
    """The two parts of a batch that led to findings, which the second part may do."""

    @cached_property
    def names(self) -> frozenset[str]:
        """The names of the texts and of those that they include."""
        inside = (source.name for each in self.documents for source in each.sources)
        return frozenset((*inside, *(source.name for source in self.sources)))


def try_candidates(
    groups: Sequence[Group], generator: Generator, examine: Examine, *, alone: bool = False
) -> Mapping[Candidate, Verdict]:
    """Return the verdict on each candidate in the batches of *groups*; note there which hold.

    Groups are linted together; if *alone*, without the texts of other groups as far as that takes
    less time. A batch that does not hold is tried again in parts.
    """
    texts = generator.texts
    verdicts: dict[Candidate, Verdict] = {}
    for _ in range(STEPS):
        trial = list(_next_batches(groups, generator, verdicts))
        if not trial:
            break
        if alone:
            texts = _fewer(texts, [group for group, _, _ in trial], first=texts is generator.texts)
        after = examine(texts.rewritten(each for _, _, changes in trial for each in changes))
        for group, batch, changes in trial:
            _settle(group, batch, _verdict(generator, group, batch, changes, after), verdicts)
    for group in groups:
        for batch in group.batches:
            verdicts.update(dict.fromkeys(batch, Verdict(None, "it could not be tried in time")))
    return verdicts


def _next_batches(
    groups: Iterable[Group], generator: Generator, verdicts: dict[Candidate, Verdict]
) -> Iterator[tuple[Group, list[Candidate], Sequence[Candidate]]]:
    """Yield the next batch of each of *groups*, with what writes it; settle what nothing writes."""
    for group in groups:
        while group.batches:
            batch = group.batches.pop(0)
            try:
                changes = generator.combined(batch)
            except NotExpressible as reason:
                _settle(group, batch, Verdict(None, str(reason)), verdicts)
            else:
                yield group, batch, changes
                break


def _fewer(texts: Texts, groups: Iterable[Group], *, first: bool) -> Texts:
    """Return those of *texts* that belong to *groups*, or all if to lint them again takes less.

    Of texts that were linted together before, unless these are the *first*, only changes are
    linted, which is about twice as fast.
    """
    few = texts.only(source for group in groups for source in group.sources)
    return few if first or few.size * 2 < texts.size else texts


def _settle(
    group: Group,
    batch: list[Candidate],
    verdict: Verdict,
    verdicts: dict[Candidate, Verdict],
) -> None:
    """Note the *verdict* on *batch*, or which parts of it are to be tried next."""
    if verdict.applicability and _claim(batch) <= verdict.applicability:
        group.held.append(batch)
        verdicts.update((each, Verdict(each.repair.applicability)) for each in batch)
        _conclude(group, batch, verdicts)
        return
    useless = batch if len(batch) == 1 else list(_useless(batch, verdict))
    verdicts.update(dict.fromkeys(useless, verdict))
    left = [each for each in batch if each not in verdicts]
    if left:
        whole = len(left) == len(batch)
        parts = _parts(left, verdict) if whole else [left]
        if verdict.applicability and _claim(parts[-1]) <= verdict.applicability:
            group.doubted = parts[0], parts[-1]
        group.batches[:0] = parts


def _conclude(group: Group, batch: list[Candidate], verdicts: dict[Candidate, Verdict]) -> None:
    """Settle what was written with *batch*, if that holds alone: it is what led to findings."""
    if group.doubted is None or group.doubted[0] is not batch:
        return
    _, others = group.doubted
    group.batches.remove(others)
    group.held.append(others)
    verdicts.update((each, Verdict(each.repair.applicability)) for each in others)


def _claim(batch: Iterable[Candidate]) -> Applicability:
    """Return the most that one of *batch* claims."""
    return max(each.repair.applicability for each in batch)


def _useless(batch: Iterable[Candidate], verdict: Verdict) -> Iterator[Candidate]:
    """Yield those of *batch* whose findings are of a kind of which all stay."""
    kinds = Counter(each.kind for each in batch)
    for each in batch:
        if verdict.blamed.get(each.kind, 0) >= kinds[each.kind]:
            yield each


def _parts(batch: Sequence[Candidate], verdict: Verdict) -> list[list[Candidate]]:
    """Split *batch* in two: by who is blamed, or else by claims, by rules, or in halves."""
    blamed = [each for each in batch if each.kind in verdict.blamed]
    if 0 < len(blamed) < len(batch):
        return [[each for each in batch if each not in blamed], blamed]
    trusted = [each for each in batch if each.repair.applicability is Applicability.SAFE]
    if 0 < len(trusted) < len(batch):
        return [trusted, [each for each in batch if each not in trusted]]
    codes = list(dict.fromkeys(each.finding.rule.code for each in batch))
    few = set(codes[: len(codes) // 2])
    first = [each for each in batch if each.finding.rule.code in few] or batch[: len(batch) // 2]
    return [list(first), [each for each in batch if each not in first]]


def _verdict(
    generator: Generator,
    group: Group,
    batch: Sequence[Candidate],
    changes: Sequence[Candidate],
    after: Examination,
) -> Verdict:
    """Judge whether *batch*, written as *changes*, does what it promises.

    It is SAFE if so, and UNSAFE if it leads to findings. Texts that could not be read before need
    not be readable.
    """
    before = generator.examination.report
    lost = {error.name for error in before.errors}
    unread = {error.name for error in after.report.errors}.difference(lost)
    if any(source.name in unread for source in group.sources):
        return Verdict(None, "the text could not be read then")
    if not _all_say(group, changes, generator.texts, after):
        return Verdict(None, "the text would say something else")
    if not all(_means(each, after) for each in changes):
        return Verdict(None, "the text would mean something else")
    names = group.names
    mended = counts([*{id(each.finding): each.finding for each in batch}.values()])
    left = counts(before.findings) - mended
    now = counts([one for one in after.report.findings if one.location.source.name in names])
    more = {kind: number for kind, number in (now - left).items() if kind[0] in names}
    stay = {kind: number for kind, number in more.items() if kind in mended}
    if stay:
        return Verdict(None, generator.remains, stay)
    if more:
        codes = ", ".join(sorted({code for _, code in more}))
        return Verdict(Applicability.UNSAFE, f"it brings {codes} to light")
    return Verdict(Applicability.SAFE)


def _all_say(group: Group, changes: Sequence[Candidate], texts: Texts, after: Examination) -> bool:
    """Tell whether all documents with an edited text changed as *changes* promise, and no other."""
    graphs = {each.graph for each in group.documents}
    if not all(graphs.issuperset(each.deltas) for each in changes):
        return False
    edited = {path for each in changes for path in each.edits}
    for old in group.documents:
        if edited.isdisjoint(texts.paths(old)):
            continue
        new = after.store.documents.get(old.graph)
        if new is None or not _says(old, new, changes, [*texts.paths(old)]):
            return False
    return True


def _says(
    old: Document, new: Document, changes: Iterable[Candidate], paths: Sequence[Path]
) -> bool:
    """Tell whether *new* is *old*, read from *paths*, with what *changes* change in it."""
    apart = {tuple(map(each.edits.get, paths)): each for each in changes}.values()
    deltas = [each.deltas[old.graph] for each in apart if old.graph in each.deltas]
    removed = dict.fromkeys(triple for each in deltas for triple in each.removed)
    added = dict.fromkeys(
        tuple(_apart(term, number) for term in triple)
        for number, each in enumerate(deltas)
        for triple in each.added
    )
    return is_exact_change(old, new, Delta(tuple(removed), tuple(added)))  # type: ignore[arg-type]


def _apart(term: Term, number: int) -> Term:
    """Return *term*, told apart from new nodes of the same name in other changes."""
    return f"_:new{number}of{term[5:]}" if term.startswith("_:new") else term


def _means(candidate: Candidate, after: Examination) -> bool:
    """Tell whether what is lifted changed as *candidate* says."""
    lifted = candidate.lifted
    return all(map(after.store.says, lifted.added)) and not any(
        map(after.store.is_lifted, lifted.removed)
    )
