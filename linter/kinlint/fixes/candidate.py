"""One way to mend one finding, written down as edits and not yet proven."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from pathlib import Path

from kinlint.catalogue.applicability import covers
from kinlint.configuration.settings import Settings
from kinlint.document import Document, homes
from kinlint.edits import Delta, Edit, Unsayable, overlap
from kinlint.fixes.change import change
from kinlint.fixes.placing import placed
from kinlint.fixes.reach import Reach
from kinlint.fixes.texts import Texts
from kinlint.formats.registry import Editor, editor
from kinlint.lint import Examination
from kinlint.model import Finding, Repair
from kinlint.terms import Term
from kinlint.text import SourceText


@dataclass(frozen=True, eq=False)
class Candidate:
    """A repair of a finding: the change of each document, by its graph, and the edits that say it.

    `rank` is its place among those of the finding. `meant` is the change of the graph as the rule
    states it, `lifted` what of it no text says as such. `edits` are those of each text, and
    `sources` the texts, by the real paths of their files.
    """

    finding: Finding
    repair: Repair
    rank: int
    meant: Delta
    lifted: Delta
    deltas: Mapping[Term, Delta]
    edits: Mapping[Path, tuple[Edit, ...]]
    sources: Mapping[Path, SourceText]


@dataclass
class Workshop:
    """Writes the repairs of what an examination found in texts, where the settings are such.

    Those it cannot write go to `unsaid`.
    """

    examination: Examination
    texts: Texts
    settings: Settings
    unsaid: list[tuple[Finding, Repair, str]] = field(default_factory=list)
    _editors: dict[Term, Editor] = field(default_factory=dict)

    def candidates(self, finding: Finding) -> Sequence[Candidate]:
        """The ways to mend *finding* that can be written, the preferred first."""
        found: list[Candidate] = []
        form = self._home(finding).format
        for rank, repair in enumerate(finding.rule.repairs):
            if not covers(repair.formats, form):
                continue
            try:
                candidate = self._written(finding, repair, rank)
            except Unsayable as reason:
                self.unsaid.append((finding, repair, str(reason)))
            else:
                again = any(candidate and candidate.edits == each.edits for each in found)
                found += [candidate] if candidate is not None and not again else []
        return found

    def _written(self, finding: Finding, repair: Repair, rank: int) -> Candidate | None:
        """*repair* of *finding* as edits; None where it changes nothing."""
        account, store = self.examination.account, self.examination.store
        members = finding.members or (finding,)
        results = [result for each in members for result in account.results(each)]
        meant = change(store, repair, results)
        if not meant:
            return None
        where = placed(store, meant, self._home(finding))
        edits: dict[Path, dict[Edit, None]] = {}
        sources: dict[Path, SourceText] = {}
        for graph, delta in where.deltas.items():
            document = store.documents[graph]
            made = self._editor(document).edits(delta)
            if not made:
                raise Unsayable("the text says it already")
            for span, text in made:
                place = document.location(span)
                path = self._writable(document, place.source)
                if sources.setdefault(path, place.source).text != place.source.text:
                    raise Unsayable("the file has changed since it was read")
                edits.setdefault(path, {})[Edit(place.span, text)] = None
        return Candidate(
            finding, repair, rank, meant, where.lifted, where.deltas,
            {path: _ordered(own) for path, own in edits.items()}, sources,
        )  # fmt: skip

    def _writable(self, document: Document, source: SourceText) -> Path:
        """The file of *source*, a text of *document*; raises Unsayable if it is to stay."""
        path = self.texts.path(source)
        if source.name in self.texts.kept:
            raise Unsayable(f"it is written in {source.name}, which was not named")
        if source is not document.source:
            if document.source.name in self.texts.streamed:
                raise Unsayable("it is written in a file that standard input includes")
            if source.misread:
                raise Unsayable("the file is not to be written")
            self._reach.check(path, source.name)
        return path

    @cached_property
    def _reach(self) -> Reach:
        return Reach.of(self.texts, self.settings)

    def _editor(self, document: Document) -> Editor:
        if document.source.misread or document.source.companion:
            raise Unsayable("the file is not to be written")
        if document.graph not in self._editors:
            self._editors[document.graph] = editor(document, self.examination.options)
        return self._editors[document.graph]

    def _home(self, finding: Finding) -> Document:
        """The document in whose texts *finding* lies."""
        return self._homes[finding.location.source.name]

    @cached_property
    def _homes(self) -> Mapping[str, Document]:
        return homes(self.examination.documents)


def _ordered(edits: Iterable[Edit]) -> tuple[Edit, ...]:
    """*edits* of one text; raises Unsayable if its uses are to say different things."""
    ordered = sorted(edits, key=lambda edit: edit.span)
    if any(overlap((one,), (other,)) for one, other in pairwise(ordered)):
        raise Unsayable("the text stands for several elements, which differ then")
    return tuple(ordered)
