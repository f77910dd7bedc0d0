"""Where suppressions of findings are to be written, and how; nothing of it is proven yet."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from kinlint.addresses import is_address
from kinlint.configuration.settings import Settings
from kinlint.document import TREES, Document, homes
from kinlint.edits import Delta, Edit, Unsayable
from kinlint.fixes.reach import Reach
from kinlint.fixes.texts import Texts
from kinlint.formats.registry import Editor, editor
from kinlint.ignoring.comments import ELEMENT, comment
from kinlint.ignoring.statements import APPENDED, appended, delta
from kinlint.lint import Examination
from kinlint.model import Finding, TextEdit
from kinlint.suppression.diagnostics import FAULTS
from kinlint.suppression.interval_index import IntervalIndex
from kinlint.terms import Term, is_blank, is_iri
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import SRC


@dataclass(frozen=True, slots=True)
class Site:
    """Where findings are silenced: at a node that a document describes, or at an element.

    `place` is where the element is written.
    """

    document: Document
    node: Term
    place: Location | None = None


@dataclass(frozen=True)
class Proposal:
    """Edits of texts, by the real paths of their files, and what the documents say more then."""

    sources: Mapping[Path, SourceText]
    edits: Mapping[Path, tuple[Edit, ...]]
    deltas: Mapping[Term, Delta] = field(default_factory=dict)


Key = tuple[Term, Term, Location | None]


@dataclass
class Desk:
    """Writes suppressions of what an examination found in texts, with a reason if there is one."""

    examination: Examination
    texts: Texts
    settings: Settings
    reason: str | None = None
    _editors: dict[Term, Editor] = field(default_factory=dict)
    _nests: dict[Term, Mapping[str, IntervalIndex[Location]]] = field(default_factory=dict)

    def edits(self, finding: Finding) -> tuple[TextEdit, ...]:
        """What to write so that *finding* is silenced.

        Raises Unsayable with the reason if that cannot be.
        """
        made = self.proposal([finding])
        return tuple(
            TextEdit(Location(made.sources[path], edit.span), edit.text)
            for path, own in made.edits.items()
            for edit in own
        )

    def proposal(self, findings: Iterable[Finding]) -> Proposal:
        """What to write so that all *findings* are silenced.

        Raises Unsayable with the reason if that cannot be.
        """
        codes: dict[Key, dict[str, None]] = {}
        sites: dict[Key, Site] = {}
        for finding in findings:
            for each in finding.members or (finding,):
                site = self.site(each)
                key = site.document.graph, site.node, site.place
                sites.setdefault(key, site)
                codes.setdefault(key, {})[each.rule.code] = None
        sources: dict[Path, SourceText] = {}
        edits: dict[Path, list[Edit]] = {}
        spoken: dict[Term, dict[Term, list[str]]] = {}
        for key, site in sites.items():
            if site.place is None:
                spoken.setdefault(key[0], {})[site.node] = sorted(codes[key])
                continue
            source, span = site.place.source, site.place.span
            path = self._writable(site.document, source)
            sources[path] = source
            made = comment(source, span, sorted(codes[key]), self.reason)
            edits.setdefault(path, []).append(made)
        deltas: dict[Term, Delta] = {}
        for graph, nodes in spoken.items():
            document = self.examination.store.documents[graph]
            path = self._writable(document, document.source)
            deltas[graph] = delta(document, nodes, self.reason)
            sources[path] = document.source
            edits.setdefault(path, []).extend(self._said(document, deltas[graph]))
        return Proposal(sources, {path: _joined(made) for path, made in edits.items()}, deltas)

    def site(self, finding: Finding) -> Site:
        """Where *finding* is silenced.

        Raises Unsayable where the configuration alone can do that.
        """
        if finding.rule.name in FAULTS:
            raise Unsayable("a suppression at fault is to be mended, not silenced")
        home = self._homes.get(finding.location.source.name)
        if home is None:
            raise Unsayable("it lies in no robot model")
        if home.format in TREES:
            return self._element(home, finding.location)
        node = self._about.get(finding.focus, finding.focus)
        if is_address(node):
            raise Unsayable("it is about the file as a whole; use per-file-ignores")
        describing = [
            each for each in (home, *self.examination.documents) if node in each.map.nodes
        ]
        own = [
            each for each in describing if each.format not in TREES and not each.source.companion
        ]
        if not (is_iri(node) or is_blank(node)) or not own or node.startswith(f"<{SRC}"):
            raise Unsayable("it is about no node that the file describes; use per-file-ignores")
        return Site(own[0], node)

    def _element(self, home: Document, place: Location) -> Site:
        if home.graph not in self._nests:
            found: dict[str, list[tuple[Span, Location]]] = {}
            for spans in home.map.nodes.values():
                location = home.location(spans.whole)
                if ELEMENT.match(location.source.text, location.span.start):
                    found.setdefault(location.source.name, []).append((location.span, location))
            self._nests[home.graph] = {name: IntervalIndex.of(own) for name, own in found.items()}
        nest = self._nests[home.graph].get(place.source.name)
        around = None if nest is None else next(nest.around(place.span), None)
        if around is None:
            raise Unsayable("it lies in no element; use per-file-ignores")
        return Site(home, home.graph, around)

    def _said(self, document: Document, change: Delta) -> Iterable[Edit]:
        if not change:
            return ()
        if document.format in APPENDED:
            return [appended(document, change)]
        if document.graph not in self._editors:
            self._editors[document.graph] = editor(document, self.examination.options)
        return self._editors[document.graph].edits(change)

    def _writable(self, document: Document, source: SourceText) -> Path:
        """The file of *source*, a text of *document*; raises Unsayable if it is to stay."""
        if source.misread or source.companion or document.source.companion:
            raise Unsayable("the file is not to be written")
        if source.name in self.texts.kept:
            raise Unsayable(f"it is written in {source.name}, which was not named")
        path = self.texts.path(source)
        if source is not document.source:
            if document.source.name in self.texts.streamed:
                raise Unsayable("it is written in a file that standard input includes")
            self._reach.check(path, source.name)
        return path

    @cached_property
    def _reach(self) -> Reach:
        return Reach.of(self.texts, self.settings)

    @cached_property
    def _about(self) -> Mapping[Term, Term]:
        return {s: o for each in self.examination.documents for s, o in each.about.items()}

    @cached_property
    def _homes(self) -> Mapping[str, Document]:
        return homes(self.examination.documents)


def _joined(edits: Iterable[Edit]) -> tuple[Edit, ...]:
    """*edits* of one text in order; insertions at one place are one, and equal ones come once."""
    joined: dict[Span, dict[str, None]] = {}
    for span, text in sorted(edits):
        joined.setdefault(span, {})[text] = None
    return tuple(Edit(span, "".join(texts)) for span, texts in joined.items())
