"""Edits of what the source layer states: keys and names that are lost, and contexts in use."""

from __future__ import annotations

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Key, Object
from kinlint.formats.jsonld.editing.context_edits import add_context
from kinlint.formats.jsonld.editing.edit_plan import EditPlan
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple, iri_value, is_iri, literal_value
from kinlint.text import Span
from kinlint.vocabulary import SRC

_KEY, _CONTEXT, _NAMESPACE = src("key"), src("context"), src("namespace")
_WRITTEN = frozenset({_KEY, _CONTEXT, _NAMESPACE, src("written")})


def edit_source_layer(plan: EditPlan) -> None:
    """Replace and remove the tokens that the source layer gives the places of.

    Raises Unsayable where the delta changes a statement about the file that no token makes.
    """
    added = [triple for triple in plan.added if triple[1].startswith(f"<{SRC}")]
    for triple in [triple for triple in plan.removed if triple[1].startswith(f"<{SRC}")]:
        heir = next((new for new in added if new[:2] == triple[:2]), None)
        if triple[1] not in _WRITTEN:
            raise NotExpressible("it follows from what the file says")
        plan.settled.add(triple)
        if heir is not None:
            added.remove(heir)
            plan.stated.add(heir)
        _change(plan, triple, heir[2] if heir else None)
    for triple in added:
        if triple[:2] != (plan.document.graph, _CONTEXT):
            raise NotExpressible("it follows from what the file says")
        plan.stated.add(triple)
        add_context(plan, _text(triple[2]))


def _text(term: Term) -> str:
    return iri_value(term) if is_iri(term) else literal_value(term)


def _change(plan: EditPlan, triple: Triple, new: Term | None) -> None:
    spans = plan.document.map.nodes.get(triple[0])
    if spans is None:
        raise NotExpressible("it is not known where it is written")
    if plan.document.location(spans.whole).source is not plan.document.source:
        raise NotExpressible("it is written in a context file")
    if new is not None:
        span = _iri_of_term(plan, spans.whole) if triple[1] == _NAMESPACE else spans.whole
        plan.changes.rename(span, _text(new))
        return
    seat = (
        _key_at(plan, spans.whole)
        if triple[1] == _KEY
        else plan.places.tree.seat_at(spans.whole.start)
    )
    if seat is None:
        raise NotExpressible("it is not known where it is written")
    if isinstance(seat.holder, Object) and isinstance(seat.at, Key):
        _spare(plan, seat.holder, seat.at)
    plan.changes.remove(seat)


def _iri_of_term(plan: EditPlan, span: Span) -> Span:
    """Return the place of the IRI in the term definition at *span*, a string or an object."""
    definition = plan.places.tree.container_at(span.start)
    if not isinstance(definition, Object) or definition.span != span:
        return span
    token = definition.key("@id")
    if token is None or not isinstance(definition[token], str):
        raise NotExpressible("the term has no IRI of its own")
    return token.value_span


def _spare(plan: EditPlan, holder: Object, key: Key) -> None:
    """Mark what a repeated member states as kept when one of its copies goes."""
    members = [*holder.items(), *(holder.overwritten or ())]
    value = next(value for token, value in members if token is key)
    if any(token == key and token is not key and other == value for token, other in members):
        plan.settled.update(plan.places.within(key.value_span))


def _key_at(plan: EditPlan, span: Span) -> Seat | None:
    """Return the member whose key is the token at *span*."""
    holder = plan.places.tree.container_at(span.start)
    if not isinstance(holder, Object):
        return None
    keys = [key for key in holder if isinstance(key, Key) and key.start == span.start]
    keys += [m.key for m in holder.overwritten or () if m.key.start == span.start]
    return Seat(holder, keys[0]) if keys else None
