"""Nodes that get another name, or a first one."""

from __future__ import annotations

from kinlint.edits import Unsayable
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.editing.container_edits import Piece
from kinlint.formats.jsonld.editing.edit_plan import Plan
from kinlint.formats.jsonld.editing.key_order import number_before
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.terms import Term, Triple, iri_value, is_blank, is_iri


def write(plan: Plan) -> None:
    """Renames the nodes that lose all that is said of them to one that gains it."""
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


def _pairs(plan: Plan) -> list[tuple[Term, Term]]:
    """Old and new names; of several nodes that might be the same, the likest."""
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


def _likeness(plan: Plan, old: Term, new: Term) -> int:
    """Count the statements that *old* has and *new* is to have; 0 if they are less than half."""
    said = {(prop, _self(value, old)) for _, prop, value in plan.places.by_subject.get(old, ())}
    now = {(prop, _self(value, new)) for _, prop, value in plan.new(new)}
    alike = len(said & now)
    return alike if 2 * alike > len(said) or (alike and len(said) == 1) else 0


def _self(value: Term, node: Term) -> Term | None:
    return None if value == node else value


def _name(plan: Plan, element: Object, old: Term, new: Term) -> None:
    scope = plan.scope(element)
    name = plan.compaction.identifier(scope.keys, iri_value(new))
    key = plan.places.key_of(element, "@id")
    if key is not None:
        plan.changes.rename(key.value_span, name)
    elif is_blank(old):
        keyword = plan.compaction.keyword(scope.keys, "@id")
        after = number_before(plan.places, element, keyword)
        plan.changes.insert(element, Piece(name, keyword, after))
    else:
        raise Unsayable("the node has its name from a map")


def _settle(plan: Plan, triple: Triple, heir: Triple) -> None:
    """A triple of a renamed node is said with it; one that points to it where it is described."""
    if triple[0] != heir[0] and triple[1] not in LINKS and None in plan.places.places(triple):
        raise Unsayable("it is written as a reverse property, or in a map")
    old = plan.renamed.get(heir[2], heir[2])
    if old == triple[2] != heir[2]:
        described = plan.places.objects(old)
        for span in plan.places.spans(triple):
            seat = plan.places.seat(span)
            value = seat.value if seat else None
            if not any(value is element for element in described):
                return
    plan.settled.add(triple)
    plan.said.add(heir)
