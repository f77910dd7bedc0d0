"""References by name in SDF, resolved in the scopes of worlds and models."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.formats.sdf.scopes import Scopes
from kinlint.formats.sdf.sdf_elements import Element
from kinlint.formats.xml.references import Name
from kinlint.terms import Term, Triple, literal_value


def resolved(found: Iterable[Name], scopes: Scopes) -> Iterator[Triple]:
    """Yield what leads from the elements of the names *found* to what they name, if it is there."""
    owners = dict(_owners(scopes))
    for each in found:
        owner = owners.get(each.element)
        if owner is None:
            continue
        name = literal_value(each.value).strip()
        inside = each.reference.inside
        target = scopes.inside(name, owner) if inside else scopes.find(name, owner)
        if isinstance(target, Element):
            yield each.element, each.reference.predicate, target.node


def _owners(scopes: Scopes) -> Iterator[tuple[Term, Element]]:
    """Yield what is in a scope, and each element within it that is in none of its own."""
    for owner in scopes.around:
        pending = [owner]
        while pending:
            element = pending.pop()
            yield element.node, owner
            pending += [each for each in element.children if each not in scopes.around]
