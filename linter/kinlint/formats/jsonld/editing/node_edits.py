"""Renaming, deletion and addition of whole nodes in a JSON-LD text."""

from __future__ import annotations

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.formats.jsonld.editing.container_edits import NewChild
from kinlint.formats.jsonld.editing.edit_plan import EditPlan
from kinlint.formats.jsonld.editing.key_order import number_before
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.jsonld.editing.triple_places import Place
from kinlint.terms import Term, Triple, iri, iri_value, is_blank, is_iri


def rename_nodes(plan: EditPlan) -> None:
    """Rename the nodes that lose all their statements to others that gain them."""
    for old, new in _pairs(plan):
        plan.renamed[new] = old
    for new, old in plan.renamed.items():
        for element in plan.places.objects(old):
            _name(plan, element, old, new)
    names = {old: new for new, old in plan.renamed.items()}
    for triple in plan.removed if names else ():
        subject, prop, value = triple
        heir = names.get(subject, subject), prop, names.get(value, value)
        if heir in plan.added:
            _settle(plan, triple, heir)


def _pairs(plan: EditPlan) -> list[tuple[Term, Term]]:
    """Return old and new names; of several nodes that might be the same, the likest."""
    places = plan.places
    leaving = dict.fromkeys(triple[0] for triple in plan.removed)
    gone = [
        node
        for node in leaving
        if places.objects(node)
        and not plan.new(node)
        and all(triple in plan.removed for triple in places.by_subject.get(node, ()))
    ]
    coming = dict.fromkeys(triple[0] for triple in plan.added)
    names = [node for node in coming if is_iri(node) and node not in places.by_subject]
    scores = [
        (_likeness(plan, old, new), -gone.index(old), -names.index(new))
        for old in gone
        for new in names
    ]
    pairs: list[tuple[Term, Term]] = []
    for score, minus_old, minus_new in sorted(scores, reverse=True):
        old, new = gone[-minus_old], names[-minus_new]
        if score and not any(old == one or new == other for one, other in pairs):
            pairs.append((old, new))
    return pairs


def _likeness(plan: EditPlan, old: Term, new: Term) -> int:
    """Count the statements that *old* has and *new* is to have; 0 if they are less than half."""
    before = {(prop, _self(value, old)) for _, prop, value in plan.places.by_subject.get(old, ())}
    now = {(prop, _self(value, new)) for _, prop, value in plan.new(new)}
    alike = len(before & now)
    return alike if 2 * alike > len(before) or (alike and len(before) == 1) else 0


def _self(value: Term, node: Term) -> Term | None:
    return None if value == node else value


def _name(plan: EditPlan, element: Object, old: Term, new: Term) -> None:
    scope = plan.scope(element)
    name = plan.compaction.identifier(scope.keys, iri_value(new))
    key = plan.places.key_of(element, "@id")
    if key is not None:
        plan.changes.rename(key.value_span, name)
    elif is_blank(old):
        keyword = plan.compaction.keyword(scope.keys, "@id")
        after = number_before(plan.places, element, keyword)
        plan.changes.insert(element, NewChild(name, keyword, after))
    else:
        raise NotExpressible("the node has its name from a map")


def _settle(plan: EditPlan, triple: Triple, heir: Triple) -> None:
    """Settle a triple of a renamed node; it is stated with it, or where the node is described."""
    if triple[0] != heir[0] and triple[1] not in LINKS and None in plan.places.places(triple):
        raise NotExpressible("it is written as a reverse property, or in a map")
    old = plan.renamed.get(heir[2], heir[2])
    if old == triple[2] != heir[2]:
        described = plan.places.objects(old)
        for span in plan.places.spans(triple):
            seat = plan.places.seat(span)
            value = seat.value if seat else None
            if not any(value is element for element in described):
                return
    plan.settled.add(triple)
    plan.stated.add(heir)


_COLLECTIONS = frozenset({"@graph", "@included"})


def delete_nodes(plan: EditPlan) -> None:
    """Delete the objects of nodes that have no statements any more."""
    leaving = dict.fromkeys(triple[0] for triple in plan.removed if triple[1] not in LINKS)
    for node in leaving:
        about = plan.places.by_subject.get(node, ())
        if plan.new(node) or node in plan.renamed.values():
            continue
        if all(triple in plan.removed for triple in about):
            for element in plan.places.objects(node):
                _take_out(plan, node, element)


def _take_out(plan: EditPlan, node: Term, element: Object) -> None:
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
                raise NotExpressible(f"the key '{key}' cannot hold a reference")
            plan.settled.add((subject, iri(prop), node))
            plan.changes.replace(element.span, written.value)


def _member(plan: EditPlan, seat: Seat) -> tuple[Object, Key] | None:
    """Return the member among whose values *seat* is; None in the outermost array."""
    holder: Object | Array = seat.holder
    at = seat.at
    while not (isinstance(at, Key) and isinstance(holder, Object)):
        above = plan.places.tree.seat(holder)
        if above is None:
            return None
        holder, at = above
    return holder, at


def add_nodes(plan: EditPlan) -> None:
    """Add each new node to the graph: behind a related one, or at the end."""
    for triple in list(plan.added):
        if triple not in plan.stated and triple[1] not in LINKS:
            _add(plan, triple[0])


def _add(plan: EditPlan, node: Term) -> None:
    near = _near(plan, node)
    graph = _graph(plan, near)
    if graph is None or plan.is_cut(graph.key.value_span):
        raise NotExpressible("the file has no @graph that could hold one more node")
    holder, key = graph.owner, graph.key
    written = plan.values.described(plan.scope(holder).keys, str(key), node)
    value = holder[key]
    if isinstance(value, Array):
        number = len(value) - 1 if near is None else _number(plan, near, value)
        plan.changes.insert(value, NewChild(written, None, number))
    elif value is None:
        plan.changes.replace(key.value_span, [written])
    else:
        plan.changes.wrap(key.value_span, written)


def _near(plan: EditPlan, node: Term) -> Object | None:
    """Return an object of the text that points to *node* after the delta, or to which it points."""
    neighbours = [subject for subject, _, value in plan.added if value == node]
    neighbours += [value for _, _, value in plan.new(node)]
    for neighbour in neighbours:
        for element in plan.places.objects(plan.node(neighbour)):
            if not plan.is_cut(element.span):
                return element
    return None


def _graph(plan: EditPlan, near: Object | None) -> Place | None:
    """Return the `@graph` round *near*, or the first in the outermost object."""
    places = plan.places
    for holder, at in places.tree.above(near) if near is not None else ():
        if not isinstance(holder, Object) or not isinstance(at, Key):
            continue
        if places.meaning(holder, at) == "@graph":
            return Place(holder, at, Seat(holder, at))
    return places.graph


def _number(plan: EditPlan, near: Object, array: Array) -> int:
    """Return the number of the element of *array* in which *near* stands."""
    for seat in plan.places.tree.above(near):
        if seat.holder is array and isinstance(seat.at, int):
            return seat.at
    return len(array) - 1
