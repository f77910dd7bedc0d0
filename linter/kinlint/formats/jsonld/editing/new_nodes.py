"""Nodes that the text does not describe yet."""

from __future__ import annotations

from kinlint.edits import Unsayable
from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.formats.jsonld.editing.container_edits import Piece
from kinlint.formats.jsonld.editing.edit_plan import Plan
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.jsonld.editing.triple_places import Place
from kinlint.terms import Term


def write(plan: Plan) -> None:
    """Adds each new node to the graph: behind one that it has to do with, or at the end."""
    for triple in list(plan.added):
        if triple not in plan.said and triple[1] not in LINKS:
            _add(plan, triple[0])


def _add(plan: Plan, node: Term) -> None:
    near = _near(plan, node)
    graph = _graph(plan, near)
    if graph is None or plan.is_cut(graph.key.value_span):
        raise Unsayable("the file has no @graph that could hold one more node")
    holder, key = graph.owner, graph.key
    written = plan.values.described(plan.scope(holder).keys, str(key), node)
    value = holder[key]
    if isinstance(value, Array):
        number = len(value) - 1 if near is None else _number(plan, near, value)
        plan.changes.insert(value, Piece(written, None, number))
    elif value is None:
        plan.changes.replace(key.value_span, [written])
    else:
        plan.changes.wrap(key.value_span, written)


def _near(plan: Plan, node: Term) -> Object | None:
    """An object of the text that points to *node* after the delta, or to which it points."""
    neighbours = [subject for subject, _, value in plan.added if value == node]
    neighbours += [value for _, _, value in plan.new(node)]
    for neighbour in neighbours:
        for element in plan.places.objects(plan.node(neighbour)):
            if not plan.is_cut(element.span):
                return element
    return None


def _graph(plan: Plan, near: Object | None) -> Place | None:
    """The `@graph` round *near*, or the first in the outermost object."""
    places = plan.places
    for holder, at in places.tree.above(near) if near is not None else ():
        if not isinstance(holder, Object) or not isinstance(at, Key):
            continue
        if places.meaning(holder, at) == "@graph":
            return Place(holder, at, Seat(holder, at))
    return places.graph


def _number(plan: Plan, near: Object, array: Array) -> int:
    """The number of the element of *array* in which *near* stands."""
    for seat in plan.places.tree.above(near):
        if seat.holder is array and isinstance(seat.at, int):
            return seat.at
    return len(array) - 1
