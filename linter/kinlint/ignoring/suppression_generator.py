"""Generates suppressions: comments and statements that silence rules where they found something."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import ClassVar

from kinlint.addresses import is_address
from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.finding import Finding, Fix
from kinlint.fixes.generator import Candidate, Generator
from kinlint.formats.appended_statements import append_statements
from kinlint.formats.xml.comment_edit import ELEMENT, comment_edit
from kinlint.ignoring.ignore_statements import ignore_delta
from kinlint.light_dataclasses import dataclass, field
from kinlint.rule import Applicability, Repair
from kinlint.suppression.interval_index import IntervalIndex
from kinlint.suppression.suppression_faults import FAULTS
from kinlint.terms import Term, is_blank, is_iri
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import SRC

SUPPRESSION = Repair("Ignore it here", Applicability.SAFE, "", "", (), (), ())
"""The repair that every suppression counts as: it changes no statement about the robot."""
UNREASONED = "the configuration requires a reason, as in --add-ignore='set at run time'"


@dataclass(frozen=True, slots=True)
class Site:
    """A place where findings are silenced."""

    graph: Term
    """The document."""
    node: Term
    """The node that the document describes; the document itself where an element is silenced."""
    element: Location | None = None
    """The element, in a tree of elements."""


@dataclass
class SuppressionGenerator(Generator):
    """Writes suppressions of what an examination found in texts."""

    reason: str | None = None
    """The reason that each suppression gives."""
    _nests: dict[Term, Mapping[str, IntervalIndex[Location]]] = field(default_factory=dict)

    remains: ClassVar[str] = "it would be found all the same"
    """The reason against a suppression that changes nothing."""
    lasting: ClassVar[bool] = True
    """A suppression stays for later runs."""

    def candidates(self, findings: Sequence[Finding], least: Applicability) -> list[Candidate]:
        """Return a suppression for each of *findings* that can be silenced at all."""
        assert least <= Applicability.SAFE
        found = list[Candidate]()
        for finding in findings:
            try:
                candidate = self.suppression([finding])
                if self.settings.for_file(finding.location.source.name).require_reason:
                    self._require_reason()
            except NotExpressible as problem:
                self.refused.append((finding, SUPPRESSION, str(problem)))
            else:
                found.append(candidate)
        return found

    def batches(self, candidates: Sequence[Candidate]) -> Iterator[list[Candidate]]:
        """Put all *candidates* into one batch: those at one place join."""
        yield list(candidates)

    def combined(self, batch: Sequence[Candidate]) -> Sequence[Candidate]:
        """Return what silences the findings of all of *batch*."""
        return [self.suppression([each.finding for each in batch])]

    def weighed(self, finding: Finding, fix: Fix) -> Fix:  # noqa: ARG002
        """Return *fix* as it is: the settings rate repairs only."""
        return fix

    def suppression(self, findings: Sequence[Finding]) -> Candidate:
        """Return what silences all of *findings*, as a candidate for the first.

        Raises `NotExpressible` if that cannot be written.
        """
        codes: dict[Site, set[str]] = {}
        for finding in findings:
            for each in finding.members or (finding,):
                codes.setdefault(self._site(each), set()).add(each.rule.code)
        sources: dict[Path, SourceText] = {}
        edits: dict[Path, list[Edit]] = {}
        nodes: dict[Term, dict[Term, list[str]]] = {}
        deltas: dict[Term, Delta] = {}

        def write(graph: Term, source: SourceText, change: Delta, made: Iterable[Edit]) -> None:
            path = self.writable_path(self.documents[graph], source)
            sources[path], deltas[graph] = source, change
            edits.setdefault(path, []).extend(made)

        for site, own in codes.items():
            if site.element is None:
                nodes.setdefault(site.graph, {})[site.node] = sorted(own)
            else:
                source, span = site.element.source, site.element.span
                in_lines = self.documents[site.graph].format.line_comments
                write_comment = import_module(in_lines).comment_edit if in_lines else comment_edit
                made = write_comment(source, span, sorted(own), self.reason)
                write(site.graph, source, Delta(), [made])
        for graph, codes_of in nodes.items():
            document = self.documents[graph]
            change = ignore_delta(document, codes_of, self.reason)
            write(graph, document.source, change, self._statements(document, change))
        joined = {path: _joined(made) for path, made in edits.items()}
        meant = Delta(added=tuple(triple for each in deltas.values() for triple in each.added))
        return Candidate(
            findings[0], SUPPRESSION, SUPPRESSION.title, 0, meant, Delta(), deltas, joined, sources
        )

    def _require_reason(self) -> None:
        if not self.reason:
            raise NotExpressible(UNREASONED)

    def _site(self, finding: Finding) -> Site:
        """Return where *finding* is silenced.

        Raises `NotExpressible` where the configuration alone can do that.
        """
        if finding.rule.name in FAULTS:
            raise NotExpressible("a faulty suppression has to be corrected, not suppressed")
        home = self.homes.get(finding.location.source.name)
        if home is None:
            raise NotExpressible("it is not in a robot model")
        if home.format.is_tree:
            return self._element(home, finding.location)
        node = self._about.get(finding.focus, finding.focus)
        if is_address(node):
            raise NotExpressible("it is about the file as a whole; use per-file-ignores")
        describing = [
            each for each in (home, *self.examination.documents) if node in each.map.nodes
        ]
        own = [each for each in describing if not each.format.is_tree and not each.source.companion]
        if not (is_iri(node) or is_blank(node)) or not own or node.startswith(f"<{SRC}"):
            raise NotExpressible(
                "it is about no node that the file describes; use per-file-ignores"
            )
        return Site(own[0].graph, node)

    def _element(self, home: Document, place: Location) -> Site:
        if home.format.line_comments is not None:
            return Site(home.graph, home.graph, place)
        if home.graph not in self._nests:
            found: dict[str, list[tuple[Span, Location]]] = {}
            for spans in home.map.nodes.values():
                location = home.location(spans.whole)
                if ELEMENT.match(location.source.text, location.span.start):
                    found.setdefault(location.source.name, []).append((location.span, location))
            self._nests[home.graph] = {
                name: IntervalIndex.from_spans(own) for name, own in found.items()
            }
        nest = self._nests[home.graph].get(place.source.name)
        around = None if nest is None else next(nest.containing(place.span), None)
        if around is None:
            raise NotExpressible("it is not in an element; use per-file-ignores")
        return Site(home.graph, home.graph, around)

    def _statements(self, document: Document, change: Delta) -> Iterable[Edit]:
        if not change:
            return ()
        if document.format.appendable:
            return [append_statements(document, change)]
        return self.editor(document).edits(change)

    @cached_property
    def _about(self) -> Mapping[Term, Term]:
        return {s: o for each in self.examination.documents for s, o in each.about.items()}


def _joined(edits: Iterable[Edit]) -> tuple[Edit, ...]:
    """Return *edits* of one text in order, insertions at one place as one, equal ones once."""
    joined: dict[Span, dict[str, None]] = {}
    for span, text in sorted(edits):
        joined.setdefault(span, {})[text] = None
    return tuple(Edit(span, "".join(texts)) for span, texts in joined.items())
