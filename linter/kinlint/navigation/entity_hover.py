"""Hover text of an entity: its name, its types, and what the model or kinlint states of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.addresses import document_of, lifted
from kinlint.findings.locator import Locator
from kinlint.navigation.graph_model import GraphModel
from kinlint.navigation.hover import ACROSS, Hover
from kinlint.navigation.index import Index
from kinlint.navigation.node_at_offset import Around
from kinlint.navigation.node_description import Descriptions
from kinlint.navigation.occurrence import CLASS, Entity, Occurrence
from kinlint.navigation.vocabulary_hover import page, sort
from kinlint.navigation.xacro_names import label
from kinlint.term_format import TermFormatter
from kinlint.terms import Term, is_iri
from kinlint.text import Location

MOST = 4
"""Most entities at one place, and nodes made of one element, that are shown."""


class EntityPages:
    """Pages about what *index* has, said by *model*; *locator* knows how files abbreviate."""

    def __init__(self, model: GraphModel, index: Index, locator: Locator) -> None:
        self._model, self._index, self._locator = model, index, locator

    def named(self, occurrences: Sequence[Occurrence]) -> Hover:
        """Return the pages on what is named at one place, where *occurrences* are."""
        place = occurrences[0].location
        entities = dict.fromkeys(each.entity for each in occurrences)
        pages = [self._page(each, place) for each in list(entities)[:MOST]]
        return Hover(ACROSS.join(pages), place.span)

    def nodes_hover(self, around: Sequence[Around], location: Location) -> Hover:
        """Return the pages on what *location* is in, but does not name."""
        display = self._locator.display(location)
        pages = ["\n".join(self._node(each.node, display)) for each in around[:MOST]]
        return Hover(ACROSS.join(dict.fromkeys(pages)), location.span)

    def _page(self, entity: Entity, place: Location) -> str:
        homes = self._index.descriptions([entity])
        if (xacro := label(entity)) is not None:
            kind, name = xacro
            whose = "default class of MJCF" if kind == CLASS else f"{kind} of xacro"
            lines = [f"**{name}**: {whose}"]
            if homes:
                lines += ["", "```xml", _line(homes[0].location), "```"]
        else:
            lines = list(self._node(entity, self._locator.display(place)))
        for line in self._elsewhere(entity, place) if is_iri(entity) or xacro else ():
            lines += ["", line]
        return "\n".join(lines)

    def places(self, occurrences: Sequence[Occurrence]) -> Iterator[str]:
        """Yield where else the entities of *occurrences*, at one place, are described."""
        place = occurrences[0].location
        for entity in list(dict.fromkeys(each.entity for each in occurrences))[:MOST]:
            yield from self._elsewhere(entity, place)

    def _elsewhere(self, entity: Entity, place: Location) -> Iterator[str]:
        homes = self._index.descriptions([entity])
        found = [each.location for each in homes if each.location != place]
        shown = ", ".join(f"{each.source.name}:{each.start.line}" for each in found[:MOST])
        if shown:
            yield f"Described at {shown}"

    def _node(self, node: Term, display: TermFormatter) -> Iterator[str]:
        """Yield a heading about *node* and, below it, a list."""
        store = self._model.store
        descriptions = Descriptions(self._model, display)
        owner = store.documents.get(document_of(node))
        if owner is not None and node not in owner.map.nodes:
            yield f"**{display.term(node)}**: nothing has this name"
            return
        if owner is not None:
            yield from self._element(node, descriptions)
            return
        if self._index.descriptions([node]):
            yield _heading(descriptions, node)
            yield ""
            yield from descriptions.lines(node)
            return
        known = page(node, store, display)
        kind = sort(node, store)
        yield f"**{display.term(node)}**: {kind or 'described nowhere in this model'}"
        yield ""
        yield from known

    def _element(self, element: Term, descriptions: Descriptions) -> Iterator[str]:
        """Yield the description of the node that stands for *element*, or of all made of it."""
        made = self._model.made(element)
        own = lifted(element)
        itself = [each for each in (own, f"{own[:-1]}/frame>") if each in made][:1]
        if not itself:
            tag = self._model.tag(element) or "document"
            yield f"**{descriptions.display.term(element)}**: `<{tag}>`"
        for node in (itself or made)[:MOST]:
            lines = descriptions.lines(node)
            if lines or itself:
                yield from () if itself else ("",)
                yield _heading(descriptions, node)
                yield ""
                yield from lines


def _heading(descriptions: Descriptions, node: Term) -> str:
    types = ", ".join(f"`{each}`" for each in descriptions.types(node))
    return f"**{descriptions.display.term(node)}**{f': {types}' if types else ''}"


def _line(location: Location) -> str:
    return location.source.line(location.start.line).strip()
