"""Order of keys: a new key goes where sibling objects have it."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.text_path import children
from kinlint.formats.jsonld.editing.triple_places import TriplePlaces

_SIBLINGS = 500


def number_before(places: TriplePlaces, owner: Object, key: str) -> int:
    """Return the number of the child of *owner* after which *key* belongs, -1 if it comes first."""
    names = [str(child.key) for child in children(owner)]
    meanings = [name if name == "@context" else places.meaning(owner, name) for name in names]
    if places.meaning(owner, key) == "@id":
        return meanings.index("@context") if "@context" in meanings else -1
    for sibling in _siblings(places, owner):
        if key not in sibling:
            continue
        order = [str(child.key) for child in children(sibling)]
        at = order.index(key)
        for name in reversed(order[:at]):
            if name in names:
                return names.index(name)
        for name in order[at + 1 :]:
            if name in names:
                return names.index(name) - 1
    if places.meaning(owner, key) == "@type":
        found = [n for n, meaning in enumerate(meanings) if meaning in ("@id", "@context")]
        return max(found, default=-1)
    return len(names) - 1


def _siblings(places: TriplePlaces, owner: Object) -> Iterator[Object]:
    """Yield objects in the same array, those with the same types first."""
    seat = places.tree.seat(owner)
    if seat is None or not isinstance(seat.holder, Array):
        return
    near = [each for each in seat.holder[:_SIBLINGS] if isinstance(each, Object)]
    others = [each for each in near if each is not owner]
    kind = owner.get("@type")
    yield from (each for each in others if each.get("@type") == kind)
    yield from (each for each in others if each.get("@type") != kind)
