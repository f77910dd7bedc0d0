"""Judges the models of a store: each is streamed down and judged as if it had come as files."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from itertools import islice
from typing import TYPE_CHECKING, TypeAlias

from kinlint import garbage
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.endpoint import source_record
from kinlint.endpoint.connection import Endpoint, EndpointError
from kinlint.endpoint.source_record import StoredDocument
from kinlint.endpoint.stored_graphs import PAGE, RECORD, StoredGraph, statements
from kinlint.errors import SourceError
from kinlint.formats.dependencies.file_groups import group_sources
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import read
from kinlint.light_dataclasses import dataclass, replace
from kinlint.parallel.merge_reports import merge_reports
from kinlint.parallel.partition import MOST
from kinlint.parallel.processes import depend_on_parent
from kinlint.parallel.shard import Job, lint_shard
from kinlint.pipeline.given_documents import GivenDocuments
from kinlint.report import Report
from kinlint.terms import Term, Triple, iri_value, is_blank, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import STORE

if TYPE_CHECKING:
    from concurrent.futures import Future, ProcessPoolExecutor

StoredModel: TypeAlias = Sequence[StoredGraph]
OWN = 7
"""Number of statements that loading adds to a graph."""
TURTLE = BY_NAME["turtle"]
LABEL = re.compile(r"\W")
"""Characters of the labels of stores that those of N-Triples may not have."""


def batches(models: Iterable[StoredModel]) -> Iterator[list[StoredModel]]:
    """Yield *models* in batches that one answer of a store can hold, and that are judged at once.

    A model whose size is unknown, or that is larger, is a batch by itself.
    """
    batch: list[StoredModel] = []
    size = 0
    for model in models:
        known = all(each.size for each in model)
        more = sum(each.size + OWN for each in model) if known else PAGE
        if batch and (size + more >= PAGE or len(batch) >= MOST):
            yield batch
            batch, size = [], 0
        batch.append(model)
        size += more
    if batch:
        yield batch


@dataclass(frozen=True)
class Judge:
    """A judge of the models of a store."""

    endpoint: Endpoint
    """The store."""
    settings: Settings
    """Settings of the run."""
    book: Rulebook
    """Its rules."""
    named: frozenset[Term] = frozenset()
    """The graphs that findings are told of, with none all; others of their models are read."""

    def reports(self, batch: Sequence[StoredModel]) -> list[Report]:
        """Return a report for each model of *batch*."""
        try:
            said = statements(self.endpoint, (graph for model in batch for graph in model))
        except EndpointError as error:
            if len(batch) > 1:
                return [report for model in batch for report in self.reports([model])]
            names = (each.file or iri_value(each.name) for each in batch[0])
            return [Report(errors=tuple(SourceError(name, str(error)) for name in names))]
        found: list[list[StoredDocument]] = []
        errors: list[list[SourceError]] = []
        for model in batch:
            errors.append([])
            found.append(list(self._documents(model, said, errors[-1])))
        reports = dict[int, Report]()
        for share in _shares(found):
            reports |= zip(share, self._judged([found[each] for each in share]), strict=True)
        return [
            replace(report, errors=(*failed, *report.errors))
            for failed, (_, report) in zip(errors, sorted(reports.items()), strict=True)
        ]

    def _judged(self, models: Sequence[Sequence[StoredDocument]]) -> list[Report]:
        """Return the reports on *models*, which are judged together."""
        every = [each for one in models for each in one]
        given = GivenDocuments(
            {each.document.source.name: each.document for each in every},
            {each.document.graph: each.looked_up for each in every},
        )
        job = Job(self.settings, self.book, given=given)
        sources = [[each.document.source for each in one] for one in models]
        return [each.report for each in lint_shard(sources, (), job)] if every else [Report()]

    def _documents(
        self, model: StoredModel, said: dict[Term, list[Triple]], failed: list[SourceError]
    ) -> Iterator[StoredDocument]:
        """Yield the documents of *model*; why one cannot be read goes to *failed*."""
        for each in model:
            try:
                stored = _document(each, said[each.name])
            except SourceError as error:
                failed.append(error)
                continue
            document = stored.document
            aside = each.companion or bool(self.named and each.name not in self.named)
            if aside != document.source.companion:
                source = replace(document.source, companion=aside)
                stored = replace(stored, document=replace(document, source=source))
            yield stored


def _shares(models: Sequence[Sequence[StoredDocument]]) -> list[list[int]]:
    """Return the numbers of *models*, together as far as nothing in them may be taken for one.

    Those are single trees of elements, whose names are their own, in one format and of robots that
    have different names.
    """
    shares: list[list[int]] = []
    trees: dict[str, dict[str, int]] = {}
    texts: dict[str, list[SourceText]] = {}
    for number, model in enumerate(models):
        document = model[0].document if len(model) == 1 else None
        if document is None or not document.format.is_tree:
            shares.append([number])
        else:
            kind = document.format.name
            trees.setdefault(kind, {})[document.source.name] = number
            texts.setdefault(kind, []).append(document.source)
    for kind, numbers in trees.items():
        groups = list(group_sources(texts[kind]))
        alike = [numbers[each.name] for group in groups if len(group) > 1 for each in group]
        shares += ([number] for number in alike)
        if together := sorted(set(numbers.values()).difference(alike)):
            shares.append(together)
    return shares


def _document(graph: StoredGraph, said: Sequence[Triple]) -> StoredDocument:
    """Return the document in *graph*, which states what is *said*. Raises `SourceError`."""
    own = {p: o for s, p, o in said if s == graph.name and p.startswith(f"<{STORE}")}
    if RECORD not in own:
        name = iri_value(graph.name)
        text = "".join(sorted(f"{_labelled(s)} {p} {_labelled(o)} .\n" for s, p, o in said))
        return StoredDocument(read(SourceText(name, text, format=TURTLE), ReadOptions()))
    name = graph.file or iri_value(graph.name)
    stored = source_record.read(name, literal_value(own[RECORD]))
    if stored.document.graph != graph.name:
        raise SourceError(name, f"the record in {graph.name} is of another graph; load it again")
    return stored.holding(each for each in said if each[0] != graph.name or each[1] not in own)


def _labelled(term: Term) -> Term:
    return f"_:n{LABEL.sub('_', term[2:])}" if is_blank(term) else term


def judge_all(
    judge: Judge,
    models: Sequence[StoredModel],
    jobs: int,
    done: Callable[[int], None],
) -> Iterator[Report]:
    """Yield the reports on *models*, in their order, by so many processes.

    No more of them are kept than one batch for each process and another one. *done* is called with
    the number of models done.
    """
    planned = list(batches(models))
    for batch, reports in zip(planned, _reports(judge, planned, jobs), strict=True):
        yield from reports
        done(len(batch))


def _reports(
    judge: Judge, planned: Sequence[list[StoredModel]], jobs: int
) -> Iterator[list[Report]]:
    if jobs < 2 or len(planned) < 2:  # noqa: PLR2004  nothing to share
        yield from map(judge.reports, planned)
        return
    from concurrent.futures import ProcessPoolExecutor  # noqa: PLC0415  slow to import
    from concurrent.futures.process import BrokenProcessPool  # noqa: PLC0415

    with ExitStack() as ending:
        try:
            pool: ProcessPoolExecutor = ending.enter_context(
                ProcessPoolExecutor(min(jobs, len(planned)), initializer=_begin, initargs=(judge,))
            )
        except (NotImplementedError, OSError, ValueError):
            yield from map(judge.reports, planned)
            return
        ending.callback(pool.shutdown, wait=False, cancel_futures=True)
        waiting: deque[tuple[list[StoredModel], Future[list[Report]]]] = deque()
        left = iter(planned)
        for batch in islice(left, 2 * jobs):
            waiting.append((batch, pool.submit(_one, batch)))
        while waiting:
            batch, future = waiting.popleft()
            try:
                reports = future.result()
                for more in islice(left, 1):
                    waiting.append((more, pool.submit(_one, more)))
            except BrokenProcessPool:
                reports = judge.reports(batch)
                waiting.extend((more, future) for more in islice(left, 1))
            yield reports


_judges: list[Judge] = []
"""The judge of this worker process."""


def _begin(judge: Judge) -> None:
    depend_on_parent()
    garbage.pass_over()
    _judges.append(judge)


def _one(batch: list[StoredModel]) -> list[Report]:
    return _judges[0].reports(batch)


def together(reports: Sequence[Report], seconds: float) -> Report:
    """Return one report of *reports*."""
    errors = [error for report in reports for error in report.errors]
    names = [name for report in reports for name in report.files]
    return merge_reports(reports, names, errors, seconds)
