"""Expanded values in the terms of the contexts at an object, by PyLD's compaction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.active_context import FAULTS, Context
from kinlint.formats.jsonld.editing.traced_expansion import ContextScope, Tracing
from kinlint.formats.jsonld.editing.value_objects import Item
from kinlint.formats.jsonld.traced_values import Origin

_MAPS = frozenset({"@language", "@index", "@id", "@type", "@graph"})


class Member(NamedTuple):
    """A key, and the JSON of one value under it."""

    key: str
    """The key."""
    value: Any
    """JSON of the value."""


class Compaction:
    """Writes IRIs and values as a file would; `needed` are prefixes that it lacks for that."""

    def __init__(
        self, processor: Tracing, prefixes: Callable[[ContextScope], Mapping[str, str]]
    ) -> None:
        self._processor: Any = processor
        self._known = prefixes
        self._options = {**processor.options, "link": {}, "compactArrays": True}
        self.needed: dict[str, str] = {}

    def within(self, outer: Context, key: str | None, skeleton: Mapping[str, Any]) -> ContextScope:
        """Return the contexts at a new object with the types of *skeleton*, the value of *key*."""
        return self.scope(self._processor.entering(outer, key), skeleton)

    def scope(self, outer: Context, skeleton: Mapping[str, Any]) -> ContextScope:
        """Return the contexts at an object with the contexts and types of *skeleton*."""
        processor = self._processor
        processor.trail.append(Origin(Object(0), None, None))
        try:
            keys, _, types = processor._prepare_nested_context(  # noqa: SLF001
                outer, skeleton, processor.options
            )
        except FAULTS as fault:
            raise NotExpressible("the contexts of its types cannot be combined") from fault
        finally:
            processor.trail.pop()
        return ContextScope(outer, keys, types)

    def keyword(self, context: Context, name: str) -> str:
        """Return the keyword *name*, or the alias that the file has for it."""
        return str(self._processor._compact_iri(context, name))  # noqa: SLF001

    def type(self, scope: ContextScope, iri: str) -> str:
        """Return the class *iri* as a type."""
        name = self._iri(scope.types, iri, vocab=True)
        base = self._processor.options["base"]
        found = self._processor._expand_iri(scope.types, name, base, vocab=True)  # noqa: SLF001
        if found != iri:
            raise NotExpressible(f"no name for the type {iri} under the contexts of the file")
        return self._prefixed(scope, iri) if name == iri else name

    def identifier(self, context: Context, iri: str) -> str:
        """Return the IRI or blank node *iri* as the value of an `@id`."""
        if iri.startswith("_:"):
            return iri
        base = self._processor.options["base"]
        name = self._iri(context, iri, base=base)
        found = self._processor._expand_iri(context, name, base)  # noqa: SLF001
        if found != iri:
            raise NotExpressible(f"no way to write {iri} under the contexts of the file")
        return name

    def _iri(self, context: Context, iri: str, **how: Any) -> str:
        try:
            return str(self._processor._compact_iri(context, iri, **how))  # noqa: SLF001
        except FAULTS as fault:
            raise NotExpressible(f"no way to write {iri} under the contexts of the file") from fault

    def member(
        self, scope: ContextScope, prop: str, items: list[Item], agrees: Callable[[Item], bool]
    ) -> Member:
        """Return a member that states that *prop* has the value of which *items* are the forms.

        *agrees* tells whether an item means that value. Plain values are preferred to objects, and
        terms to compact IRIs.
        """
        keys = [self._iri(scope.keys, prop, value=item, vocab=True) for item in items]
        found = [
            member
            for key, item in zip(keys, items, strict=True)
            if (member := self.member_for_key(scope, key, prop, [item], agrees)) is not None
        ]
        if not found:
            raise NotExpressible(f"no term for {prop} under the contexts of the file")
        terms = scope.keys["mappings"]
        best = max(found, key=lambda each: (not isinstance(each.value, dict), each.key in terms))
        return best._replace(key=self._prefixed(scope, prop)) if best.key == prop else best

    def member_for_key(  # noqa: PLR0913
        self, scope: ContextScope, key: str, prop: str, items: list[Item],
        agrees: Callable[[Item], bool], *, listed: bool = False,
    ) -> Member | None:  # fmt: skip
        """Return such a member for a given *key*, as an element of its list if *listed*.

        None if the key cannot have the value.
        """
        for item in items:
            try:
                value = self._value(scope, key, item)
                whole = self._in_list(scope, key, value) if listed else value
                expanded = self._expanded(scope, key, prop, whole)
            except FAULTS:
                continue
            if listed:
                expanded = [each for found in expanded for each in found.get("@list", ())]
            mapped = isinstance(value, dict) and self._is_map(scope, key)
            if len(expanded) == 1 and agrees(expanded[0]) and not mapped:
                return Member(key, value)
        return None

    def _is_map(self, scope: ContextScope, key: str) -> bool:
        """Tell whether objects under *key* are maps."""
        container = self._processor.get_context_value(scope.keys, key, "@container") or ()
        return not _MAPS.isdisjoint(container)

    def has_value(
        self, scope: ContextScope, key: str, prop: str, value: Any, agrees: Callable[[Item], bool]
    ) -> bool:
        """Tell whether *value* under *key* expands to one item that *agrees* accepts."""
        try:
            expanded = self._expanded(scope, key, prop, value)
        except FAULTS:
            return False
        return len(expanded) == 1 and agrees(expanded[0])

    def _value(self, scope: ContextScope, key: str, item: Item) -> Any:
        processor, options = self._processor, self._options
        if "@list" not in item:
            value = processor._compact(scope.keys, key, item, options)  # noqa: SLF001
            return _value_first(value, self.keyword(scope.keys, "@value"))
        elements = [self._value(scope, key, element) for element in item["@list"]]
        return self._in_list(scope, key, *elements)

    def _in_list(self, scope: ContextScope, key: str, *elements: Any) -> Any:
        container = self._processor.get_context_value(scope.keys, key, "@container") or ()
        written = list(elements)
        return written if "@list" in container else {self.keyword(scope.keys, "@list"): written}

    def _expanded(self, scope: ContextScope, key: str, prop: str, value: Any) -> list[Any]:
        """Return the values of *prop* that `{key: value}` expands to at an object of *scope*."""
        values = self.meaning(scope, key, value).get(prop, [])
        return values if isinstance(values, list) else [values]

    def meaning(self, scope: ContextScope, key: str, value: Any) -> dict[str, Any]:
        """Expand `{key: value}` at an object of *scope*."""
        processor = self._processor
        found: dict[str, Any] = {}
        processor.trail.append(Origin(Object(0), None, None))
        try:
            processor._expand_object(  # noqa: SLF001
                scope.keys, None, None, {key: value}, found, processor.options,
                type_scoped_ctx=scope.types,
            )  # fmt: skip
        finally:
            processor.trail.pop()
        return found

    def key_for_node(self, scope: ContextScope, prop: str, identifier: str | None) -> str:
        """Return the key for a value of *prop* that is an object."""
        item = {"@id": identifier or "_:b"}
        key = self._iri(scope.keys, prop, value=item, vocab=True)
        if not self.holds_nodes(scope, key):
            raise NotExpressible(f"the term '{key}' cannot hold a node")
        return self._prefixed(scope, prop) if key == prop else key

    def holds_nodes(self, scope: ContextScope, key: str) -> bool:
        """Tell whether an object under *key* is a node to which the property points."""
        mapping = scope.keys["mappings"].get(key) or {}
        if mapping.get("reverse") or mapping.get("@nest") or mapping.get("@type") == "@json":
            return False
        return "@list" not in (mapping.get("@container") or ()) and not self._is_map(scope, key)

    def _prefixed(self, scope: ContextScope, iri: str) -> str:
        """Return an IRI that no context abbreviates, with a prefix that is to be added."""
        for prefix, namespace in self._known(scope).items():
            local = iri[len(namespace) :] if iri.startswith(namespace) else ""
            if local and "/" not in local and "#" not in local:
                if prefix in scope.keys["mappings"] or prefix in scope.types["mappings"]:
                    continue
                self.needed[prefix] = namespace
                return f"{prefix}:{local}"
        return iri


def _value_first(value: Any, keyword: str) -> Any:
    """Return a value object in the order in which people write it."""
    if isinstance(value, dict) and keyword in value:
        return {keyword: value[keyword], **value}
    return value
