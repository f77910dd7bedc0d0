"""Answers about places in the texts of one model."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import islice
from pathlib import Path

from kinlint.addresses import enclosing, is_address
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selectors import Catalogue
from kinlint.facts.robot_structures import Extraction
from kinlint.finding import Finding
from kinlint.findings.locator import Locator
from kinlint.formats.recognition import with_format
from kinlint.navigation import usd_meaning
from kinlint.navigation.element_meaning import meaning
from kinlint.navigation.entity_hover import MOST, EntityPages
from kinlint.navigation.file_links import Link, links
from kinlint.navigation.graph_model import GraphModel
from kinlint.navigation.hover import ACROSS, Hover, on_findings, on_ignore
from kinlint.navigation.index import Index
from kinlint.navigation.inlay_hints import InlayHint, InlayHints
from kinlint.navigation.node_at_offset import Surroundings
from kinlint.navigation.node_description import Descriptions
from kinlint.navigation.occurrence import Occurrence
from kinlint.navigation.outline import Symbol, outline
from kinlint.navigation.part_summary import PartSummaries
from kinlint.navigation.renaming.rename import Renamer
from kinlint.navigation.xacro_names import label
from kinlint.navigation.xacro_values import property_value
from kinlint.pipeline.analyzer import Examination
from kinlint.suppression.directive import Directive, find_directives
from kinlint.term_format import TermFormatter
from kinlint.terms import is_iri
from kinlint.text import Location, SourceText, Span

SPACES = frozenset({"2D", "3D", "Euclidean"})
"""Types that nearly every node of a geometric model has."""


class Navigator:
    """The texts of *examination*, by their names; offsets count code points.

    A repeated analyzer made it, and is not asked again as long as this answers. *contexts* are
    files of contexts, by IRI.
    """

    def __init__(
        self, examination: Examination, rulebook: Rulebook, contexts: Mapping[str, Path]
    ) -> None:
        self._report, self._documents = examination.report, examination.documents
        self._options, self._rulebook, self._contexts = examination.options, rulebook, contexts
        self._model = GraphModel(examination)

    @cached_property
    def _index(self) -> Index:
        return Index(self._documents)

    @cached_property
    def _texts(self) -> Sequence[SourceText]:
        return [each for document in self._documents for each in document.sources]

    @cached_property
    def _surroundings(self) -> Surroundings:
        return Surroundings(self._documents, self._index)

    @cached_property
    def _links(self) -> Sequence[Link]:
        return tuple(links(self._documents, self._options, self._contexts))

    def links(self, name: str) -> Sequence[Link]:
        """Return the links to files and pages in the text called *name*, each place once."""
        own = (each for each in self._links if self._is(each.location, name))
        return tuple({each.location.span: each for each in own}.values())

    @cached_property
    def _directives(self) -> Sequence[Directive]:
        return find_directives(self._documents, Catalogue(self._rulebook.rules))

    def outline(self, name: str) -> Sequence[Symbol]:
        """Return the symbols of the text called *name*, as the robots in it hang together."""
        found = Extraction(self._model.context, self._locator).structures()
        descriptions = Descriptions(self._model, TermFormatter(kinds=self._locator.kinds))
        return outline(
            name,
            found,
            self._index,
            lambda node: ", ".join(each for each in descriptions.types(node) if each not in SPACES),
        )

    def definitions(self, name: str, offset: int) -> Sequence[Location]:
        """Return the descriptions of the entity at *offset* of the text called *name*, best first.

        The name of a file leads to its beginning.
        """
        for link in self._links:
            if link.source is not None and self._covers(link.location, name, offset):
                return [Location(link.source, Span(0, 0))]
        entities = [each.entity for each in self._index.at(name, offset)]
        return [each.location for each in self._index.descriptions(entities)]

    def references(self, name: str, offset: int, *, described: bool) -> Sequence[Location]:
        """Return every place that names what is named there; if *described*, descriptions first."""
        entities = [each.entity for each in self._index.at(name, offset)]
        found = self._index.descriptions(entities) if described else []
        return [each.location for each in (*found, *self._index.mentions(entities))]

    def inlay_hints(self, name: str, span: Span) -> Sequence[InlayHint]:
        """Return the values to show beside what *span* of the text called *name* says."""
        return self._hints.hints(name, span)

    @cached_property
    def _hints(self) -> InlayHints:
        return InlayHints(self._documents, self._index.paths)

    def renamer(self, is_ours: Callable[[Path], bool]) -> Renamer:
        """Return what renames in these texts; *is_ours* tells the files that may change."""
        return Renamer(self._index, is_ours)

    def highlights(self, name: str, offset: int) -> Sequence[Occurrence]:
        """Return the places in the same text that name what is named there."""
        entities = [each.entity for each in self._index.at(name, offset)]
        index = self._index
        found = (*index.descriptions(entities), *index.mentions(entities))
        return [each for each in found if self._is(each.location, name)]

    def hover(self, name: str, offset: int) -> Hover | None:
        """Return the hover text: findings and ignore directives before what the model states.

        A part of a robot that XML names is told in the words of its format, without its classes.
        """
        parts, spans = [], []
        found = self._findings(name, offset)
        if found:
            parts.append(on_findings(found))
            spans.append(min((each.location.span for each in found), key=_length))
        for directive, span in self._ignoring(name, offset):
            rules = [self._rulebook.by_code[code] for code in sorted(directive.codes)]
            parts.append(on_ignore(directive, rules))
            spans.append(span)
        named = self._index.at(name, offset)
        pages = self._pages(named, name, offset)
        summaries = [*self._summaries_of(named)]
        told = summaries or [*self._summaries_around(name, offset)]
        told += self._meaning(name, offset)
        told += self._values_there(named, name, offset)
        if summaries and pages is not None and _is_tree(named[0].location.source):
            told += self._entity_pages.places(named)
            pages = pages._replace(markdown="\n\n".join(told))
        elif told and pages is not None:
            pages = pages._replace(markdown=ACROSS.join(["\n\n".join(told), pages.markdown]))
        if pages is not None:
            parts.append(pages.markdown)
            spans.append(pages.span)
        elif told:
            parts.append("\n\n".join(told))
            spans.append(Span(offset, offset))
        return Hover(ACROSS.join(parts), min(spans, key=_length)) if parts else None

    @cached_property
    def _summaries(self) -> PartSummaries:
        return PartSummaries(self._model.context, self._locator)

    def _summaries_of(self, named: Sequence[Occurrence]) -> Iterator[str]:
        """Yield a sentence about each part of a robot that is *named* at one place."""
        entities = dict.fromkeys(each.entity for each in named)
        for entity in list(entities)[:MOST]:
            if is_iri(entity) and (told := self._summaries.summary(entity)):
                yield told

    def _summaries_around(self, name: str, offset: int) -> Iterator[str]:
        """Yield a sentence about each part of a robot that the element at *offset* stands in."""
        for around in self._surroundings.at(name, offset)[:MOST]:
            above = enclosing(around.node) if is_address(around.node) else ()
            yield from islice(filter(None, map(self._summaries.summary, above)), 1)

    def _meaning(self, name: str, offset: int) -> Iterator[str]:
        """Yield what the format means by the element and the attribute at *offset*."""
        for document in self._documents:
            for source in document.sources:
                if self._index.paths[source.name] == self._index.paths[name]:
                    told = ""
                    if document.format.fence == "xml":
                        told = meaning(source, document.format, offset)
                    elif document.format.fence == "usda":
                        told = usd_meaning.meaning(source.text, offset)
                    if told:
                        yield told
                    return

    def _values_there(self, named: Sequence[Occurrence], name: str, offset: int) -> Iterator[str]:
        """Yield the value of an expression of xacro at *offset*, or of a property *named* there."""
        for hint in self._hints.expressions(name, offset):
            yield f"value {hint.text.removeprefix('= ')}"
        for each in named[:1]:
            kind, own = label(each.entity) or ("", "")
            for document in self._documents if kind == "property" else ():
                texts = {source.name for source in document.sources}
                if each.location.source.name in texts:
                    if value := property_value(document, own):
                        yield f"**{own}** = {value}"
                    return

    def _pages(self, named: Sequence[Occurrence], name: str, offset: int) -> Hover | None:
        if named:
            return self._entity_pages.named(named)
        around = self._surroundings.at(name, offset)
        if not around:
            return None
        path = self._index.paths[name]
        source = next(each for each in self._texts if self._index.paths[each.name] == path)
        return self._entity_pages.nodes_hover(around, Location(source, around[0].span))

    @cached_property
    def _entity_pages(self) -> EntityPages:
        return EntityPages(self._model, self._index, self._locator)

    @cached_property
    def _locator(self) -> Locator:
        return Locator(self._documents, self._model.store)

    def _findings(self, name: str, offset: int) -> Sequence[Finding]:
        every = (*self._report.findings, *self._report.suppressed)
        return [each for each in every if self._covers(each.location, name, offset)]

    def _ignoring(self, name: str, offset: int) -> Iterator[tuple[Directive, Span]]:
        for directive in self._directives:
            place = directive.document.location(directive.span)
            if self._covers(place, name, offset):
                yield directive, place.span

    def _covers(self, place: Location, name: str, offset: int) -> bool:
        return self._is(place, name) and place.span.start <= offset <= place.span.end

    def _is(self, place: Location, name: str) -> bool:
        """Tell whether *place* is in the text called *name*."""
        paths = self._index.paths
        return place.source.name == name or paths[place.source.name] == paths[name]


def _is_tree(source: SourceText) -> bool:
    form = with_format(source).format
    return form is not None and form.is_tree


def _length(span: Span) -> int:
    return span.end - span.start
