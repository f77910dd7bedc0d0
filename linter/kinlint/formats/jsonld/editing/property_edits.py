"""Changes of the types and values of the nodes that a JSON-LD text describes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.formats.jsonld.editing.container_edits import NewChild
from kinlint.formats.jsonld.editing.edit_plan import EditPlan
from kinlint.formats.jsonld.editing.key_order import number_before
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.jsonld.editing.triple_places import Place
from kinlint.terms import RDF_TYPE, Term, Triple, iri_value, is_iri
from kinlint.text import Span


def edit_properties(plan: EditPlan) -> None:
    """Change types and values of the nodes that the text describes."""
    subjects: dict[Term, tuple[list[Triple], list[Triple]]] = {}
    for triple in plan.removed:
        if triple not in plan.settled and triple[1] not in LINKS and not plan.goes(triple):
            subjects.setdefault(triple[0], ([], []))[0].append(triple)
    for triple in plan.added:
        node = plan.node(triple[0])
        if triple not in plan.stated and triple[1] not in LINKS and plan.places.objects(node):
            subjects.setdefault(node, ([], []))[1].append(triple)
    for node, (removed, added) in subjects.items():
        old = [triple for triple in removed if triple[1] == RDF_TYPE]
        new = [triple for triple in added if triple[1] == RDF_TYPE]
        if old or new:
            write_types(plan, node, old, new)
    for node, (removed, added) in subjects.items():
        old = [triple for triple in removed if triple[1] != RDF_TYPE]
        new = [triple for triple in added if triple[1] != RDF_TYPE]
        _Node(plan, node).write(old, new)


class _Node:
    """The changes of one node; new members are gathered, so that values can share a key."""

    def __init__(self, plan: EditPlan, node: Term) -> None:
        self.plan = plan
        self.node = node
        self.members: dict[tuple[int, str], tuple[Object, list[Any]]] = {}

    def write(self, removed: Sequence[Triple], added: Sequence[Triple]) -> None:
        """Remove *removed* and add *added*; those of one property replace each other."""
        waiting = [triple for triple in added if triple not in self.plan.stated]
        for triple in removed:
            places = list(self.plan.places_of(triple))
            heir = next((new for new in waiting if new[1] == triple[1]), None)
            if places and heir and self._replaced(places[0], heir):
                waiting.remove(heir)
                places = places[1:]
            for place in places:
                self.plan.changes.lasting.add(id(place.owner))
                self.plan.changes.remove(place.item)
        for triple in waiting:
            if triple not in self.plan.stated:
                self._insert(triple)
        for (_, key), (owner, values) in self.members.items():
            value = values[0] if len(values) == 1 else values
            after = number_before(self.plan.places, owner, key)
            self.plan.changes.insert(owner, NewChild(value, key, after))

    def _replaced(self, place: Place, heir: Triple) -> bool:
        """Replace the value at *place* by that of *heir* and tell whether that was possible."""
        plan, old = self.plan, place.item.value
        prop, scope = iri_value(heir[1]), plan.scope(place.owner)
        content = self._content(old)
        if content is not None:
            inner = plan.values.inner_value(scope, prop, heir[2], place.key, content)
            if inner is not None:
                plan.stated.add(heir)
                plan.changes.replace(content.span, inner)
                return True
        member = plan.values.member(scope, prop, heir[2], key=place.key, old=old)
        if member is None:
            return False
        plan.stated.add(heir)
        plan.changes.replace(place.item.span, member.value)
        return True

    def _content(self, old: Any) -> Seat | None:
        """Return the `@value` or `@id` of an object that is a value and says nothing of a node."""
        places = self.plan.places
        if not isinstance(old, Object) or places.scope(old) is None:
            return None
        if any(old is element for element in places.objects(places.subject(old) or "")):
            return None
        keys = (places.key_of(old, meaning) for meaning in ("@value", "@id"))
        return next((Seat(old, key) for key in keys if key is not None), None)

    def _insert(self, triple: Triple) -> None:
        plan = self.plan
        owner = plan.owner(self.node, triple[1])
        if owner is None:
            raise NotExpressible(
                "the file does not describe the node that something is to be said of"
            )
        plan.stated.add(triple)
        prop, scope = iri_value(triple[1]), plan.scope(owner)
        for key in plan.places.keys_of(owner, prop):
            if self._goes(owner, key):
                continue
            member = plan.values.member(scope, prop, triple[2], key=key)
            if member is not None and self._joined(owner, key, member.value):
                return
        member = plan.values.member(scope, prop, triple[2])
        assert member is not None
        if (token := owner.key(member.key)) is not None and not self._goes(owner, token):
            raise NotExpressible(f"the key '{member.key}' has another value already")
        self.members.setdefault((id(owner), member.key), (owner, []))[1].append(member.value)

    def _goes(self, owner: Object, key: Key) -> bool:
        return Seat(owner, key).number in self.plan.changes.gone(owner)

    def _joined(self, owner: Object, key: Key, value: Any) -> bool:
        """Add *value* to those under *key* and tell whether that was possible."""
        plan, old = self.plan, owner[key]
        span = key.value_span
        if isinstance(old, Object):
            scope = plan.places.scope(old)
            inner = plan.places.key_of(old, "@set") if scope else None
            if scope is None or plan.places.key_of(old, "@list"):
                return False
            if inner is not None:
                old, span = old[inner], inner.value_span
        if isinstance(old, Array):
            plan.add(old, [value])
        elif old is None:
            plan.changes.replace(span, value)
        else:
            plan.changes.wrap(span, value)
        return True


def write_types(
    plan: EditPlan, node: Term, removed: Sequence[Triple], added: Sequence[Triple]
) -> None:
    """Change the types of *node*, and with them the contexts that they bring along."""
    if any(not is_iri(triple[2]) for triple in (*removed, *added)):
        raise NotExpressible("the type has no IRI")
    owner = plan.owner(node, RDF_TYPE)
    if owner is None:
        raise NotExpressible("the file does not describe the node that is to have a type")
    plan.stated.update(added)
    scope = plan.scope(owner)
    names = [plan.compaction.type(scope, iri_value(triple[2])) for triple in added]
    touched: dict[int, tuple[Object, dict[Span, str | None]]] = {}
    for triple in removed:
        for number, place in enumerate(plan.places_of(triple)):
            held = touched.setdefault(id(place.owner), (place.owner, {}))[1]
            heir = names.pop(0) if names and place.owner is owner and not number else None
            held[place.item.span] = heir
            plan.changes.lasting.add(id(place.owner))
            if heir is None:
                plan.changes.remove(place.item)
            else:
                plan.changes.replace(place.item.span, heir)
    if names:
        touched.setdefault(id(owner), (owner, {}))
        _insert(plan, owner, names)
    for element, held in touched.values():
        _retype(plan, element, held, names if element is owner else [])


def _insert(plan: EditPlan, owner: Object, names: list[str]) -> None:
    key = plan.places.key_of(owner, "@type")
    if key is None or Seat(owner, key).number in plan.changes.gone(owner):
        name = plan.compaction.keyword(plan.scope(owner).keys, "@type")
        value: Any = names[0] if len(names) == 1 else list(names)
        after = number_before(plan.places, owner, name)
        plan.changes.insert(owner, NewChild(value, name, after))
    elif isinstance(old := owner[key], Array):
        plan.add(old, names)
    else:
        for name in names:
            plan.changes.wrap(key.value_span, name)


def _retype(
    plan: EditPlan, element: Object, held: dict[Span, str | None], names: list[str]
) -> None:
    """Set the contexts at *element* to those of the types at the seats of *held*."""
    types: dict[str, list[Any]] = {}
    for key in plan.places.keys_of(element, "@type"):
        value = element[key]
        seats = [Seat(value, n) for n in range(len(value))] if isinstance(value, Array) else []
        now = [held.get(seat.span, seat.value) for seat in seats or [Seat(element, key)]]
        types[str(key)] = [name for name in now if name is not None]
    name = next(iter(types), None) or plan.compaction.keyword(plan.scope(element).keys, "@type")
    types.setdefault(name, []).extend(names)
    plan.retype(element, types)
