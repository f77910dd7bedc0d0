"""Lists whose values change."""

from __future__ import annotations

from difflib import SequenceMatcher
from typing import Any

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Array
from kinlint.formats.jsonld.editing.container_edits import NewChild
from kinlint.formats.jsonld.editing.edit_plan import EditPlan
from kinlint.formats.jsonld.editing.target_triples import LINKS
from kinlint.formats.jsonld.editing.text_path import Seat
from kinlint.formats.jsonld.editing.triple_places import Place
from kinlint.formats.jsonld.triples import FIRST, NIL, REST
from kinlint.terms import Term, Triple, iri_value


def edit_lists(plan: EditPlan) -> None:
    """Change elements of the lists that stay, or that another takes the place of."""
    done: set[Triple] = set()
    for triple in plan.removed:
        if triple[1] in LINKS and triple not in plan.settled:
            head = _head(plan, triple[0])
            if head is not None and head not in done:
                done.add(head)
                _change(plan, head)
    for triple in plan.added:
        if (
            triple[1] in LINKS
            and triple not in plan.stated
            and plan.places.by_subject.get(triple[0])
        ):
            head = _head(plan, triple[0])
            if head is not None and head not in done:
                done.add(head)
                _change(plan, head)


def _head(plan: EditPlan, cell: Term) -> Triple | None:
    """Return the triple that points to the list of *cell*."""
    seen: set[Term] = set()
    while True:
        pointing = plan.places.by_value.get(cell, [])
        if len(pointing) != 1 or cell in seen:
            return None
        seen.add(cell)
        if pointing[0][1] not in LINKS:
            return pointing[0]
        if pointing[0][1] == FIRST:
            raise NotExpressible("a list within a list is to change")
        cell = pointing[0][0]


def _change(plan: EditPlan, head: Triple) -> None:
    now = _successor(plan, head)
    if now is None:
        return
    places = list(plan.places_of(head))
    if not places:
        return
    if len(places) > 1:
        raise NotExpressible("the list is written more than once")
    before = _cells(plan, head[2])
    after = plan.sequence(now)
    dropped = {cell for cell, _ in before}.difference(cell for cell, _ in after)
    loose = [t for cell in dropped for t in plan.places.by_subject[cell]]
    if any(triple not in plan.removed for triple in loose):
        raise NotExpressible("a part of the list would belong to nothing")
    cells = [*(cell for cell, _ in before), *(cell for cell, _ in after)]
    plan.settled.update(
        t for c in cells for t in plan.places.by_subject.get(c, ()) if t in plan.removed
    )
    plan.stated.update(t for cell, _ in after for t in plan.new(cell))
    if now != head[2]:
        plan.settled.add(head)
        plan.stated.add((head[0], head[1], now))
    _ListEdits(plan, places[0], iri_value(head[1])).write(before, after)


def _successor(plan: EditPlan, head: Triple) -> Term | None:
    """Return the first cell of the list after the delta; None if there is none."""
    if head not in plan.removed:
        return head[2]
    values = [value for _, prop, value in plan.new(head[0]) if prop == head[1]]
    cells = {cell for cell, _ in _cells(plan, head[2])}
    lists = [value for value in values if plan.is_list(value) or value in cells]
    return lists[0] if len(lists) == 1 else None


def _cells(plan: EditPlan, head: Term) -> list[tuple[Term, Term]]:
    """Return the cells of a list of the text and their values."""
    found: dict[Term, Term] = {}
    while head != NIL:
        values = {prop: value for _, prop, value in plan.places.by_subject.get(head, ())}
        if values.keys() != LINKS or head in found:
            raise NotExpressible("the list is written in parts")
        found[head] = values[FIRST]
        head = values[REST]
    return list(found.items())


class _ListEdits:
    """A list of the text."""

    def __init__(self, plan: EditPlan, place: Place, prop: str) -> None:
        self.plan = plan
        self.place = place
        self.prop = prop

    def write(self, before: list[tuple[Term, Term]], after: list[tuple[Term, Term]]) -> None:
        """Replace the values of *before*, which are written, by those of *after*."""
        old, new = [value for _, value in before], [value for _, value in after]
        seats = [self._seat((cell, FIRST, value)) for cell, value in before]
        array = seats[0].holder if seats else self._empty()
        same = SequenceMatcher(None, old, new, autojunk=False)
        for what, start, end, first, last in same.get_opcodes():
            if what == "equal":
                continue
            shared = min(end - start, last - first)
            for number in range(shared):
                seat = seats[start + number]
                value = self._value(new[first + number], seat.value)
                self.plan.changes.replace(seat.span, value)
            for seat in seats[start + shared : end]:
                self._remove(seat)
            after_number = start + shared - 1
            for value in new[first + shared : last]:
                self._insert(array, seats, after_number, self._value(value, None))

    def _remove(self, seat: Seat) -> None:
        if not isinstance(seat.holder, Array):
            self.plan.changes.replace(seat.span, [])
            return
        self.plan.changes.lasting.add(id(seat.holder))
        self.plan.changes.remove(seat)

    def _insert(self, array: Any, seats: list[Seat], after: int, value: Any) -> None:
        if isinstance(array, Array):
            number = seats[after].number if after >= 0 else (seats[0].number - 1 if seats else -1)
            self.plan.changes.insert(array, NewChild(value, None, number))
        elif after >= 0:
            self.plan.changes.wrap(seats[0].span, value)
        else:
            raise NotExpressible("the list is written as a single value")

    def _seat(self, triple: Triple) -> Seat:
        spans = self.plan.places.spans(triple)
        seat = self.plan.places.seat(spans[0]) if len(spans) == 1 else None
        if seat is None:
            raise NotExpressible("the list is written more than once")
        return seat

    def _empty(self) -> Any:
        """Return the array of a list without elements."""
        value = self.place.item.value
        if not isinstance(value, Array):
            key = self.plan.places.key_of(value, "@list")
            value = value[key] if key else None
        if not isinstance(value, Array):
            raise NotExpressible("the list is written as a single value")
        return value

    def _value(self, term: Term, old: Any) -> Any:
        """Return the JSON of *term* in this list."""
        plan, place = self.plan, self.place
        return plan.values.element(plan.scope(place.owner), self.prop, place.key, term, old)
