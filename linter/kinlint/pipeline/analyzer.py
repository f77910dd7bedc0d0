"""Analyses models: texts to a report, through all stages."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

from kinlint.catalogue.applicability import applies, possible
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.required_terms import made
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.findings.finding_builder import FindingBuilder, Proofs
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.missing_files import STATED
from kinlint.phases import Phases
from kinlint.pipeline.conclusion import conclude, robot_structures
from kinlint.pipeline.read_models import read_documents
from kinlint.pipeline.single_run import SingleRun
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import Run, run_stages
from kinlint.report import Report
from kinlint.terms import Term
from kinlint.text import SourceText

NOTHING: Mapping[Path, SourceText] = MappingProxyType({})


class Cancelled(Exception):
    """The examination was given up because somebody asked for that."""


@dataclass(frozen=True)
class Examination:
    """A report with the documents, store and finding builder that it was made from, for fixes."""

    report: Report
    documents: Sequence[Document]
    """All documents that were read, companions too."""
    store: Store
    """The statements of the documents, with all that the stages made of them."""
    builder: FindingBuilder
    """The results that the findings were made from."""
    options: ReadOptions
    """The options that the documents were read with."""


class Analyzer:
    """Analyses models once: each analysis starts with nothing kept."""

    def __init__(self, settings: Settings, rulebook: Rulebook) -> None:
        self._settings = settings
        self._rulebook = rulebook

    def examine(  # noqa: PLR0913
        self,
        sources: Sequence[SourceText],
        errors: Iterable[SourceError] = (),
        phases: Phases | None = None,
        *,
        repairing: bool = False,
        overlay: Mapping[Path, SourceText] = NOTHING,
        cancelled: Callable[[], bool] | None = None,
    ) -> Examination:
        """Lint *sources* as one model. *errors* are of files that could not even be decoded.

        Nothing is reported of companions, not even that they cannot be read. Another source that
        cannot be read is reported in `Report.errors`; the rest is linted. The time that each phase
        takes is added to *phases*. The store holds what the rules look at, and if *repairing*, what
        their repairs do. *overlay* has texts of files that others include, by their real
        paths, which count in place of what the files hold. Raises `Cancelled` soon after
        *cancelled* answers True, and is as good as before then.
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
        inputs = Inputs(joined, documents, options.packages_of)
        run, because = self._run(inputs, selection, spent, ask)
        with spent.phase("locating"):
            results = applies(run.results, joined, selection.owners)
            builder = FindingBuilder(results, joined, run.store, self._rulebook, because)
            report = conclude(builder, documents, joined, selection, failed)
        structures = robot_structures(run.store, joined, report) if self._settings.drawn else ()
        seconds = sum(spent.seconds.values()) - before
        report = replace(report, structures=structures, seconds=seconds)
        return Examination(report, joined, run.store, builder, options)

    def _read(self, source: SourceText, options: ReadOptions) -> Document:
        """Read *source*."""
        return read(source, options)

    def _select_rules(self, documents: Sequence[Document], *, repairing: bool) -> RuleSelection:
        """Select what is asked of *documents*."""
        return RuleSelection.for_documents(
            documents, self._settings, self._rulebook, repairing=repairing
        )

    def _run(
        self, inputs: Inputs, selection: RuleSelection, spent: Phases, ask: Callable[[], None]
    ) -> tuple[Run, Proofs | None]:
        """Run the stages; return them, and what explains their results if that is kept."""
        run = SingleRun(self._rulebook.vocabulary)
        store = run_stages("loading", run, inputs, spent=spent, ask=ask)
        with spent.phase("lifting"):
            found = possible(selection.constraints, inputs.documents, store, self._coming)
            demand = Demand.from_selection(selection, found, inputs.documents, self._settings)
        run_stages("checking", run, inputs, demand, spent, ask, first="lifting")
        return run, None

    @cached_property
    def _coming(self) -> frozenset[Term]:
        """The terms that other stages than loading may yet state."""
        return STATED | made(self._rulebook.axioms)
