"""Whole nodes that go."""

from __future__ import annotations

from kinlint.edits import Unsayable
from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.formats.jsonld.editing.edit_plan import Plan
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.terms import Term, iri, is_iri

_COLLECTIONS = frozenset({"@graph", "@included"})


def write(plan: Plan) -> None:
    """Takes out the objects of nodes of which nothing is said any more."""
    leaving = dict.fromkeys(triple[0] for triple in plan.removed if triple[1] not in LINKS)
    for node in leaving:
        about = plan.places.by_subject.get(node, ())
        if plan.new(node) or node in plan.renamed.values():
            continue
        if all(triple in plan.removed for triple in about):
            for element in plan.places.objects(node):
                _take_out(plan, node, element)


def _take_out(plan: Plan, node: Term, element: Object) -> None:
    seat = plan.places.tree.seat(element)
    if seat is None or plan.is_cut(element.span):
        return
    member = _member(plan, seat)
    if member is None:
        if isinstance(seat.holder, Array):
            plan.changes.remove(seat)
        return
    owner, key = member
    prop = plan.places.meaning(owner, key)
    if prop in _COLLECTIONS:
        plan.changes.lasting.add(id(seat.holder))
        plan.changes.remove(seat)
    elif is_iri(node) and prop is not None and not prop.startswith("@"):
        subject = plan.places.subject(owner)
        if subject is not None and (subject, iri(prop), node) not in plan.removed:
            written = plan.values.member(plan.scope(owner), prop, node, key=key)
            if written is None:
                raise Unsayable(f"the key '{key}' cannot hold a reference")
            plan.settled.add((subject, iri(prop), node))
            plan.changes.replace(element.span, written.value)


def _member(plan: Plan, seat: Seat) -> tuple[Object, Key] | None:
    """The member among whose values *seat* is; None in the outermost array."""
    holder: Object | Array = seat.holder
    at = seat.at
    while not (isinstance(at, Key) and isinstance(holder, Object)):
        above = plan.places.tree.seat(holder)
        if above is None:
            return None
        holder, at = above
    return holder, at
