"""The plan of one delta: its changes of the text, and the places where they are made."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from kinlint.document import Document
from kinlint.edits import Delta, NotExpressible
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.compaction import Compaction
from kinlint.formats.jsonld.editing.container_changes import ContainerChanges
from kinlint.formats.jsonld.editing.container_edits import NewChild
from kinlint.formats.jsonld.editing.new_values import ValueWriter
from kinlint.formats.jsonld.editing.style import Style
from kinlint.formats.jsonld.editing.target_triples import TargetGraph
from kinlint.formats.jsonld.editing.traced_expansion import ContextScope
from kinlint.formats.jsonld.editing.triple_places import Place, TriplePlaces
from kinlint.terms import Term, Triple
from kinlint.text import Span


class EditPlan(TargetGraph):
    """The changes of one text that say one delta."""

    def __init__(
        self,
        document: Document,
        places: TriplePlaces,
        style: Style,
        compaction: Compaction,
        delta: Delta,
    ) -> None:
        super().__init__(places, delta)
        self.document = document
        self.compaction = compaction
        self.changes = ContainerChanges(document.source.text, places.tree, style)
        self.values = ValueWriter(self, document.source, compaction)
        self._scopes: dict[int, ContextScope] = {}

    def places_of(self, triple: Triple) -> Iterator[Place]:
        """Yield the places of *triple*, except in text that is removed anyway.

        Raises NotExpressible where it is not the value of a key.
        """
        for span, place in zip(self.places.spans(triple), self.places.places(triple), strict=True):
            if self.is_cut(span):
                continue
            if place is None:
                raise NotExpressible("it is written as a reverse property, or in a map")
            yield place

    def is_cut(self, span: Span) -> bool:
        """Tell whether the text at *span* is removed."""
        return span in self.changes.cut

    def goes(self, triple: Triple) -> bool:
        """Tell whether all places of *triple* are removed anyway."""
        return all(map(self.is_cut, self.places.spans(triple)))

    def scope(self, element: Object) -> ContextScope:
        """Return the contexts at *element* once its types are changed."""
        scope = self._scopes.get(id(element)) or self.places.scope(element)
        if scope is None:
            raise NotExpressible("it is written in a map")
        return scope

    def retype(self, element: Object, types: Mapping[str, Any]) -> None:
        """Give *element* other types, which are its new members for `@type`."""
        kept = {key: value for key, value in element.items() if key == "@context"}
        old = self.scope(element)
        self._scopes[id(element)] = new = self.compaction.scope(old.outer, {**kept, **types})
        if new.keys is not old.keys:
            self._check_meaning(element, old, new)

    def _check_meaning(self, element: Object, old: ContextScope, new: ContextScope) -> None:
        """Refuse types with which a member that stays would say something else.

        A key may get its first meaning from a type, but not one that the old types hid.
        """
        node = self.places.subject(element)
        own = {key: value for key, value in element.items() if key == "@context"}
        untyped = self.compaction.scope(old.outer, own)
        for key, value in element.items():
            meaning = self.places.meaning(element, key)
            if key == "@context" or meaning == "@type":
                continue
            before = self.compaction.meaning(old, key, value)
            after = self.compaction.meaning(new, key, value)
            hidden = not before and self.compaction.meaning(untyped, key, value)
            if before == after or not (before or hidden):
                continue
            stated = [
                t for t in self.places.by_subject.get(node or "", ()) if t[1] == f"<{meaning}>"
            ]
            if not stated or any(triple not in self.removed for triple in stated):
                raise NotExpressible(f"with these types the key '{key}' means something else")

    def owner(self, node: Term, prop: Term) -> Object | None:
        """Return the object to say something of *node* in.

        One that loses a value, or the main one.
        """
        losing = sorted(self.old(node), key=lambda triple: triple[1] != prop)
        for triple in losing:
            for place in self.places.places(triple):
                if place is not None and not self._is_cut(place.owner):
                    return place.owner
        described = self.places.objects(node)
        return next((element for element in described if not self._is_cut(element)), None)

    def _is_cut(self, element: Object) -> bool:
        return self.is_cut(element.span)

    def add(self, array: Array, values: Iterable[Any]) -> None:
        """Add *values* to the end of *array*."""
        for value in values:
            self.changes.insert(array, NewChild(value, None, len(array) - 1))
