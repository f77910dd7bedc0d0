"""Names of parts that an element can refer to, where it stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.addresses import document_iri
from kinlint.formats.xml.element_types import Reference, Schema
from kinlint.formats.xml.unfinished_text import TextElement, UnfinishedText
from kinlint.navigation.completion.candidate import Candidate, Kind
from kinlint.navigation.completion.element_place import MACRO, types_of
from kinlint.navigation.completion.situation import Situation

SEPARATOR = "::"
NEAR, USUAL = 0, 1
MERGED = "merge"
"""Attribute of what is included whose parts are called as if they stood where it does."""
CLASS = "class"
"""Attribute with the name of what others inherit."""
DEEPEST = 4
"""Most names that a path through nested models has."""


class ReferredNames:
    """The names that can be written in *text*, whose format has the schema *table*."""

    def __init__(self, situation: Situation, text: UnfinishedText, table: Schema) -> None:
        self._situation, self._text, self._table = situation, text, table

    def candidates(self, reference: Reference, user: TextElement) -> Iterator[Candidate]:
        """Yield what *reference* can lead to from *user*."""
        tags = {tag for space, tag in reference.targets if space == self._table.namespace}
        if tags and self._table.nested:
            yield from self._of_kinds(tags, user)
        elif tags and not self._table.flat:
            yield from self._in_scopes(tags, user, inside=reference.inside)
        else:
            yield from self._written(tags, user)
            yield from self._known(reference.targets)

    def _of_kinds(self, tags: set[str], user: TextElement) -> Iterator[Candidate]:
        """Yield the names of the kinds that *tags* have, wherever the model has them."""
        types, names = self._table.types, self._table.names
        kinds = {one.kind for tag in tags for one in types.get(tag, ())} - {""}
        for each in self._text.elements:
            naming = CLASS if each.tag in tags and names not in each.attributes else names
            name = each.attributes.get(naming, "")
            own = types_of(each, self._table) if name and each.start != user.start else ()
            if any(one.kind in kinds for one in own):
                yield Candidate(name, Kind.NAME, each.tag, NEAR)
        document = self._situation.document
        for part in self._situation.names.parts:
            own = types.get(part.tag, ())
            here = document is not None and part.document == document.graph
            if here and any(one.kind in kinds for one in own):
                yield Candidate(part.name, Kind.NAME, part.tag, USUAL)

    def _written(self, tags: set[str], user: TextElement) -> Iterator[Candidate]:
        """Yield names that the text itself has, those of the same macro first."""
        macro = _macro(user)
        for each in self._text.elements:
            name = each.attributes.get(self._table.names, "")
            if each.tag not in tags or not name or each.start == user.start:
                continue
            if _macro(each) is not macro or (macro is None and "$" in name):
                continue
            roots = self._table.roots.values()
            if self._table.nested or any(one.children.get(each.tag) for one in roots):
                is_use = any(one.references for one in types_of(each, self._table))
                if not is_use or self._is_outermost(each):
                    yield Candidate(name, Kind.NAME, each.tag, NEAR)

    def _is_outermost(self, element: TextElement) -> bool:
        above = [each for each in element.ancestors if ":" not in each.tag]
        return len(above) <= 1

    def _known(self, targets: Sequence[tuple[str, str]]) -> Iterator[Candidate]:
        """Yield the names that other files have, and those of this one once it is expanded."""
        situation = self._situation
        pairing, name = situation.source.pairing, situation.source.name
        own = {
            each.graph
            for each in situation.documents
            if any(source.name == name for source in each.sources)
        } or None
        other = {document_iri(pairing.partner)} if pairing and pairing.partner else None
        for namespace, tag in targets:
            is_own = namespace == self._table.namespace
            if is_own and not situation.format.includes:
                continue
            homes = own if is_own else other
            for part in situation.names.outermost(namespace, tag):
                if homes is None or part.document in homes:
                    yield Candidate(part.name, Kind.NAME, part.tag)

    def _in_scopes(self, tags: set[str], user: TextElement, *, inside: bool) -> Iterator[Candidate]:
        """Yield the names in the scope that *user* is in, or that is its own."""
        scopes = [each for each in (user, *user.ancestors) if self._scope(each)]
        if not inside and scopes[:1] == [user]:
            scopes = scopes[1:]
        if not scopes:
            return
        own = user.attributes.get(self._table.names, "")
        for name, tag in self._members(scopes[0], DEEPEST):
            if tag in tags and name and (name, tag) != (own, user.tag):
                yield Candidate(name, Kind.NAME, tag, NEAR if SEPARATOR not in name else USUAL)
        known = self._scope(scopes[0])
        for tag in sorted(tags - known):
            if any(each.scope for each in self._table.types.get(tag, ())):
                yield Candidate(tag, Kind.NAME, f"the {tag} around", USUAL + 1)

    def _scope(self, element: TextElement) -> frozenset[str]:
        """Return the tags of what *element* knows by name."""
        return frozenset(tag for each in types_of(element, self._table) for tag in each.scope)

    def _members(self, scope: TextElement, depth: int) -> Iterator[tuple[str, str]]:
        """Yield the names in *scope* with the tags of what has them, and those in nested scopes."""
        known = self._scope(scope)
        for each in scope.children:
            name = each.attributes.get(self._table.names, "")
            if each.tag in known:
                yield name, each.tag
                if depth > 1 and self._scope(each):
                    for inner, tag in self._members(each, depth - 1):
                        yield f"{name}{SEPARATOR}{inner}", tag
        yield from self._included(scope)

    def _included(self, scope: TextElement) -> Iterator[tuple[str, str]]:
        """Yield the names in what *scope* includes from other files, as it was read last."""
        document = self._situation.document
        if document is None:
            return
        way: list[str] = []
        for each in (*reversed(list(scope.ancestors)), scope):
            if each.tag not in self._table.roots:
                way += (each.tag, each.attributes.get(self._table.names, ""))
        parts = [
            each
            for each in self._situation.names.parts
            if each.document == document.graph and list(each.path[: len(way)]) == way
        ]
        orders: dict[str, int] = {}
        for each in scope.children:
            orders[each.tag] = orders.get(each.tag, 0) + 1
            order = f";{orders[each.tag]}" if orders[each.tag] > 1 else ""
            for part in parts:
                step, *inner = (*part.path[len(way) :], "", "")[:2]
                if step == f"{each.tag}{order}" and inner[0] in self._table.roots:
                    names = list(part.path[len(way) + 2 :][1::2])
                    if each.attributes.get(MERGED, "").lower() in ("true", "1"):
                        names = names[1:]
                    elif written := self._written_name(each):
                        names[:1] = [written]
                    yield SEPARATOR.join(names), part.tag

    def _written_name(self, element: TextElement) -> str:
        """Return the text of the child of *element* that is its name."""
        for each in element.children:
            if each.tag == self._table.names:
                return self._text.text[each.content : each.end].partition("<")[0].strip()
        return ""


def _macro(element: TextElement) -> TextElement | None:
    return next((each for each in element.ancestors if each.tag == MACRO), None)
