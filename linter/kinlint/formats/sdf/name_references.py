"""References by name in SDF: what leads to the elements that names stand for, and what dangles."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from kinlint.formats.sdf.scopes import WORLD, Scopes, SdfScope
from kinlint.formats.sdf.sdf_elements import SdfElement
from kinlint.formats.source_layer import src
from kinlint.formats.xml.references import NameUse, gap_of
from kinlint.formats.xml.schema import TEXT
from kinlint.suggestion import LOOKED_UP, nearest
from kinlint.terms import Term, Triple, iri_value, literal, literal_value

ENDS = ("parent", "child")
"""The elements of a joint that may name the world from within any model."""
APART = ("actor", "population", "state")
"""The elements of a world with names of their own, which are not looked up."""


class References:
    """The elements in *scopes* that may refer to others."""

    def __init__(self, scopes: Scopes) -> None:
        self.scopes = scopes
        self._users: dict[Term, tuple[SdfElement, SdfElement, bool]] = {}
        """The elements by their nodes, each with the nearest one that is in a scope, or has one.

        Also whether names of the element belong to the scope of that one itself: those of an
        include.
        """
        self._compared: dict[tuple[str, int], str | None] = {}
        """The most similar names of missing ones, by these and the identity of a scope's names."""
        for owner in dict.fromkeys((*scopes.own, *scopes.enclosing)):
            self._take(owner, inside=owner not in scopes.enclosing)
        for model, include in scopes.included.items():
            self._users.update((each.node, (each, model, False)) for each in include.children)

    def _take(self, owner: SdfElement, *, inside: bool) -> None:
        pending = [(owner, inside)]
        while pending:
            element, inside = pending.pop()
            self._users[element.node] = element, owner, inside
            pending += [
                (each, inside or each.tag == "include")
                for each in element.children
                if each not in self.scopes.enclosing
                and each not in self.scopes.own
                and each.tag not in APART
            ]

    def statements(self, found: Iterable[NameUse]) -> Iterator[tuple[Triple, Triple]]:
        """Yield what leads from the elements of the names *found* to what they name, there or not.

        With each statement comes the one that has the name. What an unread file may define is left
        out.
        """
        for each in found:
            name = literal_value(each.value)
            name = name.strip() if each.place == TEXT else name
            if not name or each.element not in self._users:
                continue
            element, owner, around = self._users[each.element]
            inside = each.reference.inside
            if (around and inside) or self._replaced(element, owner):
                continue
            source = each.element, each.place, each.value
            scope, home = self._scope(owner, inside=around or inside)
            target = self.scopes.look_up(name, scope, home)
            if isinstance(target, SdfElement):
                yield (each.element, each.reference.predicate, target.node), source
            elif target.certain and (name != WORLD or element.tag not in ENDS):
                near = self._nearest(name, target.known)
                yield from ((gap, source) for gap in self._dangling(each, element, owner, near))

    def _nearest(self, name: str, known: Mapping[str, SdfElement]) -> str | None:
        """Return the name among those *known* in a scope that is most like *name*.

        After many names, None.
        """
        key = name, id(known)
        if key not in self._compared and len(self._compared) < LOOKED_UP:
            self._compared[key] = nearest(name, known)
        return self._compared.get(key)

    def _scope(self, owner: SdfElement, *, inside: bool) -> tuple[SdfScope, SdfElement]:
        """Return where a name is looked for that *owner* uses, and the element around it."""
        if inside:
            return self.scopes.own[owner], owner
        scope = self.scopes.enclosing[owner]
        return scope, owner.holder or scope.element

    def _replaced(self, element: SdfElement, owner: SdfElement) -> bool:
        """Tell whether *element* is the pose of a model for which its include has another one."""
        include = self.scopes.included.get(owner)
        return (
            include is not None
            and element.parent is owner
            and element.tag == "pose"
            and include.first("pose") is not None
        )

    @staticmethod
    def _dangling(
        name: NameUse, element: SdfElement, owner: SdfElement, near: str | None
    ) -> Iterator[Triple]:
        gap = gap_of(name)
        role = element.tag if name.place == TEXT else iri_value(name.place).rpartition("#")[2]
        yield name.element, src("dangling"), gap
        yield gap, src("node"), owner.node
        yield gap, src("property"), name.place
        yield gap, src("written"), name.value
        yield gap, src("role"), literal(role)
        if near is not None:
            yield gap, src("resembles"), literal(near)
