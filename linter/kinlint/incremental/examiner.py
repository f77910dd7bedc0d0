"""Examines one model again and again, each time only as far as something changed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

from kinlint.catalogue.applicability import possible
from kinlint.catalogue.rule_selection import Inquiry
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.compiler.names import SUBCLASS
from kinlint.engine.constraint import Constraint
from kinlint.engine.required_terms import made
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.formats.options import ReadOptions
from kinlint.formats.rereading import Rereader
from kinlint.incremental.inference import followable
from kinlint.incremental.model import Model
from kinlint.incremental.said import Outline, Said, outline, valued, vocabulary_of
from kinlint.lint import NOTHING, Examination, concluded, examine, gathered
from kinlint.missing_files import STATED
from kinlint.phases import Phases
from kinlint.terms import Term
from kinlint.text import SourceText

Key: TypeAlias = tuple[tuple[tuple[Term, Format], ...], int, bool, tuple[int, ...]]
"""The graphs and formats of documents, how many are no companions, whether to repair, and the
constraints that may be violated, by identity: those of one rulebook.
"""

KEPT = 3
"""So many models are kept: as it is, as it is while a file cannot be read, and one more."""


class Cancelled(Exception):
    """The examination was given up because somebody asked for that."""


class Incremental:
    """Examines one model whose texts change little by little.

    What it answers is what `kinlint.lint.examine` answers, but for the seconds. It serves one
    thread at a time. The store and the account of an examination are good until the next one.
    """

    def __init__(self, settings: Settings, rulebook: Rulebook) -> None:
        self._settings = settings
        self._rulebook = rulebook
        self._readers: dict[str, Rereader] = {}
        self._models: dict[Key, Model] = {}
        self._inquiries: dict[tuple[tuple[tuple[str, Format], ...], bool], Inquiry] = {}
        self._asked: Inquiry | None = None
        self._valued = frozenset[Term]()
        self._outlines: dict[Outline, list[Constraint]] = {}

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
        """What is found in *sources*, as `kinlint.lint.examine` says.

        Raises `Cancelled` soon after *cancelled* answers True, and is as good as before then.
        """
        if not self._can_follow:
            return self._from_the_beginning(sources, errors, phases, repairing, overlay)

        def ask() -> None:
            if cancelled is not None and cancelled():
                raise Cancelled

        spent = phases or Phases()
        before = sum(spent.seconds.values())
        failed = list(errors)
        ask()
        with spent.phase("reading"):
            options = replace(ReadOptions.of(self._settings), overlay=overlay)

            def reading(source: SourceText) -> Document:
                ask()
                return self._readers.setdefault(source.name, Rereader()).read(source, options)

            documents, joined = gathered(sources, failed, self._settings, reading)
        if len({document.graph for document in joined}) < len(joined):
            return self._from_the_beginning(sources, errors, phases, repairing, overlay)
        inquiry = self._inquiry(documents, repairing=repairing)
        with spent.phase("lifting"):
            constraints = self._possible(inquiry, joined)
        graphs = tuple((document.graph, document.format) for document in joined)
        key = graphs, len(documents), repairing, tuple(map(id, constraints))
        model = self._models.pop(key, None)
        if model is None:
            model = Model(joined, inquiry, constraints, self._settings, spent)
        try:
            account = model.examine(documents, joined, options, spent, ask)
        except Cancelled:
            self._keep(key, model)
            raise
        self._keep(key, model)
        with spent.phase("locating"):
            report = concluded(account, documents, joined, inquiry, failed)
        report = replace(report, seconds=sum(spent.seconds.values()) - before)
        return Examination(report, joined, model.store, account, options)

    def _from_the_beginning(
        self,
        sources: Sequence[SourceText],
        errors: Iterable[SourceError],
        phases: Phases | None,
        repairing: bool,  # noqa: FBT001
        overlay: Mapping[Path, SourceText],
    ) -> Examination:
        return examine(
            sources,
            errors,
            self._settings,
            self._rulebook,
            phases,
            repairing=repairing,
            overlay=overlay,
        )

    def _inquiry(self, documents: Sequence[Document], *, repairing: bool) -> Inquiry:
        """What is asked of *documents*, which names and formats decide."""
        named = tuple((document.source.name, document.format) for document in documents)
        if (named, repairing) not in self._inquiries:
            self._inquiries.clear()
            self._inquiries[named, repairing] = Inquiry.of(
                documents, self._settings, self._rulebook, repairing=repairing
            )
        return self._inquiries[named, repairing]

    def _possible(self, inquiry: Inquiry, documents: Sequence[Document]) -> list[Constraint]:
        """What of *inquiry* may be violated, which is the same for documents of one outline."""
        if self._asked is not inquiry:
            self._asked, self._outlines = inquiry, {}
            self._valued = valued(inquiry.constraints)
        key = outline(documents, self._valued)
        found = self._outlines.pop(key, None)
        if found is None:
            said = Said(documents, vocabulary_of(self._rulebook.vocabulary))
            found = possible(inquiry.constraints, documents, said, self._coming)
        if SUBCLASS not in key.properties:
            self._outlines[key] = found
        for stale in list(self._outlines)[:-KEPT]:
            del self._outlines[stale]
        return found

    @cached_property
    def _coming(self) -> frozenset[Term]:
        return STATED | made(self._rulebook.axioms)

    def _keep(self, key: Key, model: Model) -> None:
        self._models[key] = model
        for stale in list(self._models)[:-KEPT]:
            del self._models[stale]

    @cached_property
    def _can_follow(self) -> bool:
        """Whether all that judges can be told what changed."""
        settings, rulebook = self._settings, self._rulebook
        return (
            settings.engine == "oxigraph"
            and not settings.drawn
            and all(each.deferred is None for each in rulebook.constraints)
            and followable(rulebook.axioms)
        )
