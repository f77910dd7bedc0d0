"""Completion in JSON-LD: keys by the active context and the type, values by their property."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

from kinlint.formats.json_text.unfinished_json import JsonCursor, UnfinishedJson, UnfinishedNode
from kinlint.formats.jsonld.active_terms import ActiveTerms, Level, active_terms
from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.graph_values import TYPE, GraphValues
from kinlint.navigation.completion.situation import Situation

CONTEXT, ID, TYPES, GRAPH = "@context", "@id", "@type", "@graph"
KEYWORDS = {
    ID: "identifier of the node",
    TYPES: "classes of the node",
    GRAPH: "nodes of the graph",
    CONTEXT: "meaning of the keys",
    "@value": "value of a literal",
    "@language": "language of a text",
    "@list": "ordered values",
    "@set": "values without an order",
    "@reverse": "properties that lead to the node",
    "@included": "further nodes",
    "@index": "key of an index",
    "@nest": "further members of the node",
}
NEEDED, FITTING, USED, USUAL, RARE = range(5)


def complete(situation: Situation) -> Completions:
    """Return what can be written at the place of *situation*, in a file of JSON-LD."""
    cursor = UnfinishedJson(situation.source.text, situation.offset).cursor
    if cursor is None:
        return NOTHING
    completion = _Completion(situation, cursor)
    if cursor.is_key:
        return Completions.from_candidates(completion.keys(), cursor.token)
    return Completions.from_candidates(completion.values(), cursor.token)


class _Completion:
    def __init__(self, situation: Situation, cursor: JsonCursor) -> None:
        self.situation, self.cursor = situation, cursor
        around = list(cursor.node.around)
        self.objects = [each for each in around if each.is_object]
        self.in_context = any(each.key == CONTEXT for each in around) or cursor.key == CONTEXT
        self.graph = GraphValues(situation, self._spell)

    @cached_property
    def active(self) -> ActiveTerms:
        """The terms that are active in the object around."""
        return active_terms(self.situation.source, self.situation.options, self._levels)

    @cached_property
    def inside(self) -> ActiveTerms:
        """The terms that are active in the value that the cursor is in."""
        key = self.cursor.key
        if key is None or key.startswith("@"):
            return self.active
        return active_terms(self.situation.source, self.situation.options, self._levels, key)

    def _spell(self, iri: str) -> str | None:
        """Return how the value that the cursor is in is written if it is to be *iri*."""
        key = self.cursor.key or ""
        term = self.active.by_name.get(key)
        coerced = term is not None and term.coercion == "@vocab"
        return self.inside.spell(iri, vocabulary=key == TYPES or coerced)

    @property
    def _levels(self) -> Sequence[Level]:
        return [
            Level(each.key if each.parent is not None else None, _plain(each))
            for each in reversed(self.objects)
        ]

    @cached_property
    def types(self) -> Sequence[str]:
        """The classes that the object around is said to be of."""
        said = _listed(self.objects[0].get(TYPES) if self.objects else None)
        return [self.active.expand(each) for each in said if isinstance(each, str)]

    def keys(self) -> Iterator[Candidate]:
        """Yield the keys that the object does not have yet."""
        if self.in_context:
            return
        present = {key for key, _, place in self.cursor.node.members if place != self.cursor.token}
        outermost = self.cursor.node.parent is None
        for word, meaning in KEYWORDS.items():
            if word not in present and (word not in (CONTEXT, GRAPH) or outermost):
                common = word in (ID, TYPES) or (outermost and word == CONTEXT)
                yield self._key(word, meaning, NEEDED if common else RARE)
        vocabulary = self.graph.vocabulary
        above, used = vocabulary.above(self.types), self.graph.used_with(self.types)
        for term in self.active.terms:
            if term.name in present or term.is_prefix or vocabulary.is_class(term.iri):
                continue
            fits = term.is_scoped or vocabulary.belongs(term.iri, above)
            rank = FITTING if fits else USED if term.iri in used else USUAL
            yield self._key(term.name, vocabulary.describe(term.iri), rank)

    def _key(self, name: str, detail: str, rank: int) -> Candidate:
        rest = self.situation.source.text[self.cursor.token.end :].lstrip()[:1]
        colon = "" if rest == ":" else ": "
        return Candidate(name, Kind.ATTRIBUTE, detail, rank, f'"{name}"{colon}', again=bool(colon))

    def values(self) -> Iterator[Candidate]:
        """Yield what the value can be."""
        for each in self._values():
            text = f'"{each.label if each.text is None else each.text}"'
            yield each._replace(text=text)

    def _values(self) -> Iterator[Candidate]:
        key = self.cursor.key
        if self.in_context:
            if key == CONTEXT:
                iris = getattr(self.situation.options.contexts, "iris", ())
                yield from (Candidate(each, Kind.FILE, "context") for each in iris)
        elif key == TYPES:
            yield from self.graph.values(TYPE, ())
        elif key == ID:
            yield from self._identifiers()
        elif key is not None and not key.startswith("@"):
            yield from self.graph.values(self.active.expand(key), self.types)

    def _identifiers(self) -> Iterator[Candidate]:
        """Yield what the node can be called: what is not described yet, or what is referred to."""
        holder = self.objects[0].key
        referring = holder is not None and holder not in (GRAPH, "@included")
        if referring:
            levels = self._levels[:-1]
            outer = active_terms(self.situation.source, self.situation.options, levels)
            said = self.objects[1].get(TYPES) if len(self.objects) > 1 else None
            types = [outer.expand(each) for each in _listed(said) if isinstance(each, str)]
            yield from self.graph.values(outer.expand(holder or ""), types)
        else:
            yield from self.graph.undescribed()
        for term in self.active.terms:
            if term.is_prefix:
                yield Candidate(f"{term.name}:", Kind.WORD, term.iri, RARE, again=True)


def _listed(value: Any) -> Sequence[Any]:
    return value if isinstance(value, list) else [value]


def _plain(node: UnfinishedNode) -> Mapping[str, Any]:
    """Return the context of *node* and those of its members that may be its types."""
    found: dict[str, Any] = {}
    for key, value, _ in node.members:
        if key is None:
            continue
        if not isinstance(value, UnfinishedNode):
            found[key] = value
        elif key == CONTEXT or (not value.is_object and len(value.members) <= MOST_TYPES):
            found[key] = value.value
    return found


MOST_TYPES = 20
"""More values than that are no types of a node."""
