"""Analyses models: texts to a report, through all stages, and again as far as texts changed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, cached_property, partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kinlint.catalogue.applicability import CHOSEN_TARGETS, applies, possible
from kinlint.catalogue.deferred import heads
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.axioms import names_its_terms
from kinlint.engine.constraint import Constraint
from kinlint.engine.required_terms import made
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.formats.incremental_reader import IncrementalReader
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.incremental.tracked_facts import TrackedFacts
from kinlint.light_dataclasses import dataclass, replace
from kinlint.missing_files import STATED
from kinlint.phases import Phases
from kinlint.pipeline.conclusion import conclude, robot_structures
from kinlint.pipeline.read_models import read_documents
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.report import Report
from kinlint.terms import Term, iri_value
from kinlint.text import SourceText
from kinlint.vocabulary import FEATURE

if TYPE_CHECKING:
    from kinlint.findings.finding_builder import FindingBuilder
    from kinlint.pipeline.given_documents import GivenDocuments

NOTHING: Mapping[Path, SourceText] = MappingProxyType({})

Key: TypeAlias = tuple[tuple[tuple[Term, Format], ...], int, bool]
"""The graphs and formats of documents, how many are no companions, and whether to repair."""

KEPT = 3
"""Number of models kept: the current one, the one while a file cannot be read, and one more."""


class Cancelled(Exception):
    """The examination was given up because somebody asked for that."""


class Kept(NamedTuple):
    """The stages of one model, with what was asked of them."""

    run: Run
    """Stages of the model."""
    demand: Demand
    """Rules, facts and terms that were asked for."""

    def checks(self, constraints: Iterable[Constraint]) -> bool:
        """Tell whether all *constraints*, of the same rulebook, are among those that are asked."""
        known = set(map(id, self.demand.constraints))
        return all(id(each) in known for each in constraints)


@dataclass(frozen=True)
class Examination:
    """A report with the documents, store and finding builder that it was made from, for fixes.

    Store, builder and facts are good until their analyzer is asked again.
    """

    report: Report
    """The report."""
    documents: Sequence[Document]
    """All documents that were read, companions too."""
    store: Store
    """The statements of the documents, with all that the stages made of them."""
    make_builder: Callable[[], FindingBuilder]
    """Function that returns `builder`, made when it is first called."""
    options: ReadOptions
    """The options that the documents were read with."""
    computed: TrackedFacts
    """The computation of facts of the store."""

    @property
    def builder(self) -> FindingBuilder:
        """The results that the findings were made from."""
        return self.make_builder()


class Analyzer:
    """Analyses one model, whose texts may change little by little.

    The first analysis starts with nothing kept; each further one makes anew what changed, and
    answers what another analyzer would, but for the seconds. With *repeated*, the first reads texts
    such that they are read again sooner, and stores hold all that can be lifted and inferred, for
    those who ask about the model. With *trying*, too, and later answers differ in the labels
    of blank nodes. Texts of *given* documents are not read. It serves one thread at a time.
    """

    def __init__(
        self,
        settings: Settings,
        rulebook: Rulebook,
        *,
        repeated: bool = False,
        trying: bool = False,
        given: GivenDocuments | None = None,
    ) -> None:
        self._settings = settings
        self._rulebook = rulebook
        self._browsed = repeated
        self._given = given
        self._reading = partial(IncrementalReader, divided=repeated or trying, lasting=trying)
        self._readers: dict[str, IncrementalReader] = {}
        self._kept: dict[Key, Kept] = {}
        self._selections: dict[tuple[tuple[tuple[str, Format], ...], bool], RuleSelection] = {}

    def examine(  # noqa: PLR0913
        self,
        sources: Sequence[SourceText],
        errors: Iterable[SourceError] = (),
        phases: Phases | None = None,
        *,
        repairing: bool = False,
        brief: bool = False,
        overlay: Mapping[Path, SourceText] = NOTHING,
        cancelled: Callable[[], bool] | None = None,
    ) -> Examination:
        """Lint *sources* as one model. *errors* are of files that could not even be decoded.

        Nothing is reported of companions, not even that they cannot be read. Another source that
        cannot be read is reported in `Report.errors`; the rest is linted. The time that each phase
        takes is added to *phases*. The store holds what the rules look at, and if *repairing*, what
        their repairs do. If *brief*, it may lack that, and so do findings what they rest on; no
        structures are drawn. *overlay* has texts of files that others include, by their real paths,
        which count in place of what the files hold. Raises `Cancelled` soon after *cancelled*
        answers True, and is as good as before then.
        """

        def ask() -> None:
            if cancelled is not None and cancelled():
                raise Cancelled

        spent = phases or Phases()
        before = sum(spent.seconds.values())
        failed = list(errors)
        ask()
        with spent.phase("reading"):
            options = replace(ReadOptions.from_settings(self._settings), overlay=overlay)

            def reading(source: SourceText) -> Document:
                ask()
                return self._read(source, options)

            documents, joined = read_documents(sources, failed, self._settings, reading)
        selection = self._select_rules(documents, repairing=repairing)
        known = None if self._given is None else list(self._given.about_files(documents))
        inputs = Inputs(joined, documents, options.packages_of, known, repairing=not brief)
        run = self._run(inputs, selection, spent, ask)
        with spent.phase("locating"):
            found = applies(run.results, joined, selection.owners)
            results = list(_of_targets(found, selection))
            builder = cache(partial(_finding_builder, results, joined, run, self._rulebook))
            report = conclude(results, builder, documents, joined, selection, failed, brief=brief)
        drawn = self._settings.drawn and not brief
        structures = robot_structures(run.store, joined, report) if drawn else ()
        seconds = sum(spent.seconds.values()) - before
        report = replace(report, structures=structures, seconds=seconds)
        assert run.computed is not None
        return Examination(report, joined, run.store, builder, options, run.computed)

    def _read(self, source: SourceText, options: ReadOptions) -> Document:
        """Read *source*, or what changed of it."""
        if self._given is not None:
            return self._given.documents[source.name]
        if not self._can_follow:
            return read(source, options)
        reader = self._readers.setdefault(source.name, self._reading())
        return reader.read(source, options)

    def _select_rules(self, documents: Sequence[Document], *, repairing: bool) -> RuleSelection:
        """Select what is asked of *documents*, which names and formats decide."""
        named = tuple((document.source.name, document.format) for document in documents)
        if (named, repairing) not in self._selections:
            self._selections.clear()
            self._selections[named, repairing] = RuleSelection.for_documents(
                documents, self._settings, self._rulebook, repairing=repairing
            )
        return self._selections[named, repairing]

    def _run(
        self, inputs: Inputs, selection: RuleSelection, spent: Phases, ask: Callable[[], None]
    ) -> Run:
        """Run the stages that were kept of such documents, or else new ones, and keep them."""
        joined = inputs.documents
        graphs = tuple((document.graph, document.format) for document in joined)
        key = graphs, len(inputs.own), bool(selection.repairs)
        kept = self._kept.pop(key, None)
        try:
            run = self._new_run() if kept is None else kept.run
            run_stages("loading", run, inputs, spent=spent, ask=ask)
            with spent.phase("lifting"):
                found = possible(selection.constraints, joined, run.store, self._coming)
            if kept is None or not kept.checks(found):
                if kept is not None:
                    found = _together(selection, found, kept.demand.constraints)
                demand = Demand.from_selection(
                    selection, found, joined, self._settings, browsed=self._browsed
                )
                formats = {document.format for document in joined}
                if kept is not None and not demand.makes_as(kept.demand, formats):
                    run = self._new_run()  # What was not asked for was not lifted either.
                    run_stages("loading", run, inputs, spent=spent, ask=ask)
                kept = Kept(run, demand)
            run_stages("checking", run, inputs, kept.demand, spent, ask, first="lifting")
        finally:
            if kept is not None and self._can_follow and len(dict(graphs)) == len(joined):
                self._keep(key, kept)
        return run

    def _new_run(self) -> Run:
        return Run(self._rulebook.vocabulary, self._rulebook.axioms)

    def _keep(self, key: Key, kept: Kept) -> None:
        self._kept[key] = kept
        for stale in list(self._kept)[:-KEPT]:
            del self._kept[stale]

    @cached_property
    def _can_follow(self) -> bool:
        """Tell whether all stages can follow changes, by these settings and rules."""
        rulebook = self._rulebook
        return (
            self._settings.engine == "oxigraph"
            and not any(each.deferred for each in heads(rulebook.constraints))
            and names_its_terms(rulebook.axioms)
        )

    @cached_property
    def _coming(self) -> frozenset[Term]:
        """The terms that other stages than loading may yet state."""
        return STATED | made(self._rulebook.axioms)


def _finding_builder(
    results: Sequence[Result], documents: Sequence[Document], run: Run, rulebook: Rulebook
) -> FindingBuilder:
    """Return the builder of findings from *results* of *run*."""
    from kinlint.findings.finding_builder import FindingBuilder  # noqa: PLC0415  many files are clean

    return FindingBuilder(results, documents, run.store, rulebook, run.because)


def _of_targets(found: Iterable[Result], selection: RuleSelection) -> Iterator[Result]:
    """Yield those of *found* that are no features which the targets of the run read as written."""
    for result in found:
        feature = result.bindings.get("feature", "")
        plain = not feature or result.constraint.speaks_of != CHOSEN_TARGETS
        if plain or selection.policies.departs(iri_value(feature).removeprefix(FEATURE)):
            yield result


def _together(
    selection: RuleSelection, found: Iterable[Constraint], more: Iterable[Constraint]
) -> list[Constraint]:
    """Return the constraints *found* and *more*, in the order of *selection*."""
    wanted = {id(each) for each in (*found, *more)}
    return [each for each in selection.constraints if id(each) in wanted]
