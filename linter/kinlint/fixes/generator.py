"""Generates candidates: ways to change texts because of a finding, written down and not proven."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import ClassVar

from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document, homes
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.finding import Finding, Fix, TextEdit
from kinlint.fixes.texts import Texts
from kinlint.fixes.writable import WritableFiles
from kinlint.formats.registry import Editor, editor
from kinlint.light_dataclasses import dataclass, field
from kinlint.pipeline.analyzer import Examination
from kinlint.rule import Applicability, Repair
from kinlint.terms import Term
from kinlint.text import Location, SourceText

Refusal = tuple[Finding, Repair, str]
"""A finding, the repair that cannot be made, and why."""
FileKind = tuple[str, str]
"""The name of a text and the code of a rule: findings alike are counted by these."""


@dataclass(frozen=True, eq=False)
class Candidate:
    """A change of texts because of a finding, and the change of graphs that it stands for."""

    finding: Finding
    """Finding that the change is for."""
    repair: Repair
    """The title of the change, and how far it may be trusted."""
    title: str
    """The title of the repair, with the values of the finding."""
    rank: int
    """The place of the repair among those of the finding; the preferred has 0."""
    meant: Delta
    """The change of the graph as the rule states it."""
    lifted: Delta
    """The part of `meant` that no text says as such, since it is lifted."""
    deltas: Mapping[Term, Delta]
    """The change of each document, by its graph; empty where the text alone changes."""
    edits: Mapping[Path, tuple[Edit, ...]]
    """The edits of each text, by the real path of its file."""
    sources: Mapping[Path, SourceText]
    """The texts that are edited, by the real paths of their files."""

    @property
    def text_edits(self) -> tuple[TextEdit, ...]:
        """The edits, in the order of the texts' names and of their places."""
        edits = (
            TextEdit(Location(self.sources[path], edit.span), edit.text)
            for path, made in self.edits.items()
            for edit in made
        )
        return tuple(sorted(edits, key=lambda one: (one.location.source.name, one.location.span)))

    @property
    def kind(self) -> FileKind:
        """The text and rule of the finding."""
        return kind(self.finding)


@dataclass
class Generator(ABC):
    """Writes changes of *texts* because of what an examination found in them."""

    examination: Examination
    """Examination with the findings."""
    texts: Texts
    """Texts to change."""
    settings: Settings
    """Settings of the run."""
    rulebook: Rulebook
    """Rules of the run."""
    refused: list[Refusal] = field(default_factory=list)
    """The changes that could not be written, with the reasons."""
    _editors: dict[Term, Editor] = field(default_factory=dict)

    remains: ClassVar[str] = "the finding would stay"
    """The reason against a candidate that does not take its finding away."""
    lasting: ClassVar[bool] = False
    """True if candidates are the same at any trust, and what is refused once always is."""

    @abstractmethod
    def candidates(self, findings: Sequence[Finding], least: Applicability) -> list[Candidate]:
        """Return candidates for *findings*, of each the preferred first.

        Those that the settings trust less than *least* are left out. What cannot be written is
        noted in `refused`.
        """

    @abstractmethod
    def batches(self, candidates: Sequence[Candidate]) -> Iterator[list[Candidate]]:
        """Sort *candidates* into batches that can be written together, the preferred first."""

    @abstractmethod
    def combined(self, batch: Sequence[Candidate]) -> Sequence[Candidate]:
        """Return what writes all of *batch* together. Raises `NotExpressible` if nothing does."""

    @abstractmethod
    def weighed(self, finding: Finding, fix: Fix) -> Fix:
        """Return *fix* with the applicability that the settings give it."""

    def editor(self, document: Document) -> Editor:
        """Return the editor of *document*.

        Raises `NotExpressible` if its file is not to be written.
        """
        if document.source.misread or document.source.companion:
            raise NotExpressible("the file is not to be written")
        if document.graph not in self._editors:
            self._editors[document.graph] = editor(document, self.examination.options)
        return self._editors[document.graph]

    def writable_path(self, document: Document, source: SourceText) -> Path:
        """Return the real path of *source*, a text of *document*.

        Raises `NotExpressible` if it is not to be written.
        """
        if source.misread or source.companion or document.source.companion:
            raise NotExpressible("the file is not to be written")
        if source.name in self.texts.kept:
            raise NotExpressible(f"it is written in {source.name}, which was not named")
        path = self.texts.path(source)
        if source is not document.source:
            if document.source.name in self.texts.streamed:
                raise NotExpressible("it is written in a file that standard input includes")
            self._writable.check(path, source.name)
        return path

    @cached_property
    def policies(self) -> Policies:
        """The policies of the settings, by file."""
        return Policies(self.settings, self.rulebook.rules)

    @cached_property
    def _writable(self) -> WritableFiles:
        return WritableFiles.from_texts(self.texts, self.settings)

    @cached_property
    def documents(self) -> Mapping[Term, Document]:
        """The documents by their graphs."""
        return {each.graph: each for each in self.examination.documents}

    @cached_property
    def homes(self) -> Mapping[str, Document]:
        """The documents by the names of their texts."""
        return homes(self.examination.documents)


MakeGenerator = Callable[[Examination, Texts, Settings, Rulebook], Generator]


def kind(finding: Finding) -> FileKind:
    """Return the text and the rule of *finding*."""
    return finding.location.source.name, finding.rule.code


def counts(findings: Sequence[Finding]) -> Counter[FileKind]:
    """Count *findings* by text and rule."""
    return Counter(map(kind, findings))
