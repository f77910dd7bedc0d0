"""Analyses one model again and again, each time only as far as something changed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import NamedTuple, TypeAlias

from kinlint.catalogue.applicability import possible
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import Constraint
from kinlint.file_format import Format
from kinlint.findings.finding_builder import Proofs
from kinlint.formats.incremental_reader import IncrementalReader
from kinlint.formats.options import ReadOptions
from kinlint.incremental.inference import can_follow
from kinlint.incremental.triple_index import (
    Signature,
    TripleIndex,
    signature,
    valued,
    vocabulary_of,
)
from kinlint.phases import Phases
from kinlint.pipeline.analyzer import Analyzer
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import Run, run_stages
from kinlint.pipeline.tracked_run import TrackedRun
from kinlint.terms import Term
from kinlint.text import SourceText

Key: TypeAlias = tuple[tuple[tuple[Term, Format], ...], int, bool, tuple[int, ...]]
"""The graphs and formats of documents, how many are no companions, whether to repair, and the
constraints that may be violated, by identity: those of one rulebook.
"""

KEPT = 3
"""Number of models kept: the current one, the one while a file cannot be read, and one more."""


class Kept(NamedTuple):
    """The stages of one model, with what was asked of them."""

    run: TrackedRun
    demand: Demand


class IncrementalAnalyzer(Analyzer):
    """Analyses one model whose texts change little by little.

    What it answers is what `Analyzer` answers, but for the seconds: its first analysis starts with
    nothing kept, and each further one makes anew what changed. It serves one thread at a time. The
    store and the builder of an analysis are good until the next one.
    """

    def __init__(self, settings: Settings, rulebook: Rulebook) -> None:
        super().__init__(settings, rulebook)
        self._readers: dict[str, IncrementalReader] = {}
        self._kept: dict[Key, Kept] = {}
        self._inquiries: dict[tuple[tuple[tuple[str, Format], ...], bool], RuleSelection] = {}
        self._asked: RuleSelection | None = None
        self._valued = frozenset[Term]()
        self._signatures: dict[Signature, list[Constraint]] = {}

    def _read(self, source: SourceText, options: ReadOptions) -> Document:
        """Read *source*, or what changed of it."""
        if not self._can_follow:
            return super()._read(source, options)
        return self._readers.setdefault(source.name, IncrementalReader()).read(source, options)

    def _run(
        self, inputs: Inputs, selection: RuleSelection, spent: Phases, ask: Callable[[], None]
    ) -> tuple[Run, Proofs | None]:
        """Run the stages that were kept of such documents, or else new ones, and keep them."""
        joined = inputs.documents
        graphs = tuple((document.graph, document.format) for document in joined)
        if not self._can_follow or len(dict(graphs)) < len(joined):
            return super()._run(inputs, selection, spent, ask)
        with spent.phase("lifting"):
            found = self._possible(selection, joined)
        key = graphs, len(inputs.own), bool(selection.repairs), tuple(map(id, found))
        kept = self._kept.pop(key, None)
        if kept is None:
            demand = Demand.from_selection(selection, found, joined, self._settings)
            kept = Kept(TrackedRun(self._rulebook.vocabulary, self._rulebook.axioms), demand)
        try:
            run_stages("checking", kept.run, inputs, kept.demand, spent, ask)
        finally:
            self._keep(key, kept)
        return kept.run, kept.run.because

    def _select_rules(self, documents: Sequence[Document], *, repairing: bool) -> RuleSelection:
        """Select what is asked of *documents*, which names and formats decide."""
        named = tuple((document.source.name, document.format) for document in documents)
        if (named, repairing) not in self._inquiries:
            self._inquiries.clear()
            self._inquiries[named, repairing] = RuleSelection.for_documents(
                documents, self._settings, self._rulebook, repairing=repairing
            )
        return self._inquiries[named, repairing]

    def _possible(
        self, selection: RuleSelection, documents: Sequence[Document]
    ) -> list[Constraint]:
        """Return the constraints that may be violated: those of one signature share them."""
        if self._asked is not selection:
            self._asked, self._signatures = selection, {}
            self._valued = valued(selection.constraints)
        key = signature(documents, self._valued)
        found = self._signatures.pop(key, None)
        if found is None:
            said = TripleIndex(documents, vocabulary_of(self._rulebook.vocabulary))
            found = possible(selection.constraints, documents, said, self._coming)
        if SUBCLASS not in key.properties:
            self._signatures[key] = found
        for stale in list(self._signatures)[:-KEPT]:
            del self._signatures[stale]
        return found

    def _keep(self, key: Key, kept: Kept) -> None:
        self._kept[key] = kept
        for stale in list(self._kept)[:-KEPT]:
            del self._kept[stale]

    @cached_property
    def _can_follow(self) -> bool:
        """Tell whether all stages can follow changes, by these settings and rules."""
        settings, rulebook = self._settings, self._rulebook
        return (
            settings.engine == "oxigraph"
            and not settings.drawn
            and all(each.deferred is None for each in rulebook.constraints)
            and can_follow(rulebook.axioms)
        )
