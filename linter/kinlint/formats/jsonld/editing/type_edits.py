"""Types that go, come and take each other's place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kinlint.edits import Unsayable
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.container_edits import Piece
from kinlint.formats.jsonld.editing.edit_plan import Plan
from kinlint.formats.jsonld.editing.key_order import number_before
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.terms import RDF_TYPE, Term, Triple, iri_value, is_iri
from kinlint.text import Span


def write_types(plan: Plan, node: Term, removed: Sequence[Triple], added: Sequence[Triple]) -> None:
    """The types of *node* change; the contexts that they bring along change with them."""
    if any(not is_iri(triple[2]) for triple in (*removed, *added)):
        raise Unsayable("the type has no IRI")
    owner = plan.owner(node, RDF_TYPE)
    if owner is None:
        raise Unsayable("the file does not describe the node that is to have a type")
    plan.said.update(added)
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


def _insert(plan: Plan, owner: Object, names: list[str]) -> None:
    key = plan.places.key_of(owner, "@type")
    if key is None or Seat(owner, key).number in plan.changes.gone(owner):
        name = plan.compaction.keyword(plan.scope(owner).keys, "@type")
        value: Any = names[0] if len(names) == 1 else list(names)
        after = number_before(plan.places, owner, name)
        plan.changes.insert(owner, Piece(value, name, after))
    elif isinstance(old := owner[key], Array):
        plan.add(old, names)
    else:
        for name in names:
            plan.changes.wrap(key.value_span, name)


def _retype(plan: Plan, element: Object, held: dict[Span, str | None], names: list[str]) -> None:
    """The contexts at *element* once the types at the seats of *held* are what they are there."""
    types: dict[str, list[Any]] = {}
    for key in plan.places.keys_of(element, "@type"):
        value = element[key]
        seats = [Seat(value, n) for n in range(len(value))] if isinstance(value, Array) else []
        now = [held.get(seat.span, seat.value) for seat in seats or [Seat(element, key)]]
        types[str(key)] = [name for name in now if name is not None]
    name = next(iter(types), None) or plan.compaction.keyword(plan.scope(element).keys, "@type")
    types.setdefault(name, []).extend(names)
    plan.retype(element, types)
