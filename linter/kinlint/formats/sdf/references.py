"""References by name in SDF, resolved in the scopes of worlds and models."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.formats.sdf.scopes import Scopes
from kinlint.formats.sdf.sdf_elements import SdfElement
from kinlint.formats.xml.references import NameUse
from kinlint.terms import Term, Triple, literal_value


def resolve_references(found: Iterable[NameUse], scopes: Scopes) -> Iterator[Triple]:
    """Yield what leads from the elements of the names *found* to what they name, if it is there."""
    owners = dict(_owners(scopes))
    for each in found:
        owner = owners.get(each.element)
        if owner is None:
            continue
        name = literal_value(each.value).strip()
        inside = each.reference.inside
        target = scopes.find_inside(name, owner) if inside else scopes.find(name, owner)
        if isinstance(target, SdfElement):
            yield each.element, each.reference.predicate, target.node


def _owners(scopes: Scopes) -> Iterator[tuple[Term, SdfElement]]:
    """Yield what is in a scope, and each element within it that is in none of its own."""
    for owner in scopes.enclosing:
        pending = [owner]
        while pending:
            element = pending.pop()
            yield element.node, owner
            pending += [each for each in element.children if each not in scopes.enclosing]
