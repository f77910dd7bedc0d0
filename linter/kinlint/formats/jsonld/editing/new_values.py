"""New values of properties: references, literals, lists and whole nodes."""

from __future__ import annotations

from functools import partial
from typing import Any

from kinlint.edits import NotExpressible, negated
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.editing.compaction import Compaction, Member
from kinlint.formats.jsonld.editing.style import Verbatim
from kinlint.formats.jsonld.editing.target_triples import TargetGraph
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.jsonld.editing.traced_expansion import ContextScope
from kinlint.formats.jsonld.editing.value_objects import Item, is_form_of, literal_items
from kinlint.terms import RDF_TYPE, Term, iri_value, is_blank, is_iri, is_literal
from kinlint.text import SourceText


class ValueWriter:
    """Writes the values of one goal as the text would."""

    def __init__(self, goal: TargetGraph, source: SourceText, compaction: Compaction) -> None:
        self._goal = goal
        self._source = source
        self._compaction = compaction
        self._spellings: set[str] | None = None
        self._within: set[Term] = set()

    def member(
        self, scope: ContextScope, prop: str, term: Term, *, key: str | None = None, old: Any = None
    ) -> Member | None:
        """Return the value *term* of *prop* as a member of an object, of *key* if one is given.

        *old* is the value that it takes the place of. None if *key* cannot have it.
        """
        if self._is_node(term):
            named = iri_value(term) if is_iri(term) else None
            if key is None:
                key = self._compaction.key_for_node(scope, prop, named)
            elif not self._compaction.holds_nodes(scope, key):
                return None
            return Member(key, self._embedded(scope.keys, key, term))
        items = self._items(term, old)
        if key is not None:
            return self._compaction.member_for_key(scope, key, prop, items, partial(self._is, term))
        return self._compaction.member(scope, prop, items, partial(self._is, term))

    def inner_value(
        self, scope: ContextScope, prop: str, term: Term, key: str, content: Seat
    ) -> Any:
        """Return the JSON to put at *content*, the `@value` or `@id` of an object that *key* has.

        None if *term* cannot be written by that alone.
        """
        assert isinstance(content.holder, Object)
        named = self._goal.places.meaning(content.holder, str(content.at)) == "@id"
        if named is is_literal(term) or self._is_node(term) or self._goal.is_list(term):
            return None
        around = {str(name): value for name, value in content.holder.items()}
        for item in self._items(term, content.value):
            inner = item.get("@value")
            if named:
                inner = self._compaction.identifier(scope.keys, item["@id"])
            whole = {**around, str(content.at): inner}
            if self._compaction.has_value(scope, key, prop, whole, partial(self._is, term)):
                return inner
        return None

    def element(self, scope: ContextScope, prop: str, key: str, term: Term, old: Any) -> Any:
        """Return the JSON of *term* in the list under *key*, in the place of *old*.

        Raises Unsayable where *key* cannot have it.
        """
        items = self._items(term, old)
        how = partial(self._is, term)
        member = self._compaction.member_for_key(scope, key, prop, items, how, listed=True)
        if member is None:
            raise NotExpressible(f"the key '{key}' cannot hold the value")
        return member.value

    def _is_node(self, term: Term) -> bool:
        """Tell whether *term* is written as an object: it has no name, or no place of its own."""
        if is_literal(term) or self._goal.is_list(term) or term in self._goal.places.trace.labels:
            return False
        if is_blank(term):
            return True
        placeless = self._goal.places.graph is None and term not in self._within
        described = self._goal.node(term) in self._goal.places.by_subject
        return placeless and not described and bool(self._goal.new(term))

    def _embedded(self, outer: Context, key: str, term: Term) -> Any:
        if term in self._goal.places.by_subject or self._goal.places.objects(term):
            return self._moved(term)
        return self.described(outer, key, term)

    def _moved(self, term: Term) -> Verbatim:
        """Return the text of an object without name, which may be moved but not repeated."""
        objects = self._goal.places.objects(term)
        pointing = self._goal.places.by_value.get(term, [])
        if len(objects) != 1 or any(triple not in self._goal.removed for triple in pointing):
            raise NotExpressible("a node without an identifier cannot be referred to")
        self._goal.settled.update(self._goal.places.within(objects[0].span))
        return Verbatim(self._source[objects[0].span])

    def described(self, outer: Context, key: str | None, term: Term) -> dict[str, Any]:
        """Return a new node with all its statements, as the value of *key*."""
        if term in self._within:
            raise NotExpressible("a node without an identifier would contain itself")
        self._within.add(term)
        compaction, triples = self._compaction, self._goal.new(term)
        self._goal.stated.update(triples)
        around = compaction.within(outer, key, {})
        types = [compaction.type(around, iri_value(v)) for _, p, v in triples if p == RDF_TYPE]
        skeleton = {compaction.keyword(around.keys, "@type"): types} if types else {}
        scope = compaction.within(outer, key, skeleton)
        written: dict[str, Any] = {}
        if is_iri(term):
            name = compaction.identifier(scope.keys, iri_value(term))
            written[compaction.keyword(scope.keys, "@id")] = name
        for name, names in skeleton.items():
            written[name] = names[0] if len(names) == 1 else names
        members: dict[str, list[Any]] = {}
        for _, prop, value in triples:
            if prop != RDF_TYPE:
                member = self.member(scope, iri_value(prop), value)
                assert member is not None
                members.setdefault(member.key, []).append(member.value)
        for name, values in members.items():
            written[name] = values[0] if len(values) == 1 else values
        return written

    def _items(self, term: Term, old: Any = None) -> list[Item]:
        """Return the forms of *term* as an expanded value."""
        if is_literal(term):
            return literal_items(term, self._kept_spellings(), old)
        if self._goal.is_list(term):
            sequence = self._goal.sequence(term)
            self._goal.stated.update(
                triple for cell, _ in sequence for triple in self._goal.new(cell)
            )
            forms = [self._items(value) for _, value in sequence]
            count = max(map(len, forms), default=1)
            return [
                {"@list": [form[min(n, len(form) - 1)] for form in forms]} for n in range(count)
            ]
        if is_blank(term) and term not in self._goal.places.trace.labels:
            raise NotExpressible("a node without an identifier would stand in a list")
        return [{"@id": self._name(term)}]

    def _name(self, term: Term) -> str:
        """Return a node as expanded JSON-LD names it."""
        return iri_value(term) if is_iri(term) else f"_:{self._goal.places.trace.labels[term]}"

    def _is(self, term: Term, item: Item) -> bool:
        """Tell whether the expanded *item* means *term*."""
        if is_literal(term):
            return "@value" in item and is_form_of(item, term)
        if self._goal.is_list(term):
            values = [value for _, value in self._goal.sequence(term)]
            found = item.get("@list")
            return (
                found is not None
                and len(found) == len(values)
                and all(map(self._is, values, found))
            )
        return item.get("@id") == self._name(term) and "@value" not in item

    def _kept_spellings(self) -> set[str]:
        """Return the spellings of removed values and their negatives, without quotes.

        A number that moves, or changes its sign, keeps its own.
        """
        if self._spellings is None:
            spans = (
                span for triple in self._goal.removed for span in self._goal.places.spans(triple)
            )
            said = {self._source[span].strip('"') for span in spans}
            self._spellings = said.union(map(negated, said))
        return self._spellings
