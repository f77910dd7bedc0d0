"""PyLD's expansion, with the place of everything it expands riding along."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from pyld.jsonld import KEYWORD_PATTERN, KEYWORDS, JsonLdProcessor, frozendict

from kinlint.formats.json_text.values import Array, Key, Object, Parsed, Text
from kinlint.formats.jsonld.active import ActiveContexts, Context
from kinlint.formats.jsonld.marks import (
    Expanded,
    ExpandedArray,
    Iri,
    Origin,
    Reach,
    Resolution,
    value_span,
)
from kinlint.formats.jsonld.record import Record
from kinlint.formats.options import ContextLibrary
from kinlint.text import Span

_KEYWORDS = frozenset(KEYWORDS)
_LIKE_KEYWORD = re.compile(KEYWORD_PATTERN)
_ABSOLUTE = re.compile(r"([A-Za-z][A-Za-z0-9+-.]*|_):[^\s]*$")


class Processor(ActiveContexts, JsonLdProcessor):  # type: ignore[misc]
    """Expands one file; `record` holds what was noticed on the way.

    `trail` holds the objects round the one at work: the innermost is where an error happened.
    `repeated` finds the objects in which a key stands more than once. `on_node`, if set, is
    given each element of the outermost graph as soon as it is expanded; it is missing from the
    result then, and from the parsed text, so that a large file is in memory but once.
    """

    def __init__(
        self, library: ContextLibrary, base: str, *, strict: bool = False, mode: str = "1.1"
    ) -> None:
        ActiveContexts.__init__(self, library, strict=strict)
        JsonLdProcessor.__init__(self, on_property_dropped=self._on_dropped)
        self.record = Record()
        self.trail: list[Origin] = []
        self.repeated: dict[int, Origin] = {}
        self.on_node: Callable[[Any], None] | None = None
        self.options: dict[str, Any] = {
            "base": base,
            "isFrame": False,
            "keepFreeFloatingNodes": False,
            "processingMode": f"json-ld-{mode}",
            "contextResolver": self.resolver,
        }
        self._meanings: dict[tuple[int, bool, str | None], dict[str, Resolution]] = {}
        self._kept: list[Context] = []

    def expand_document(self, parsed: Parsed, context: Any = None) -> list[Any]:
        """The expanded form of a JSON text; *context* is in force from the start.

        Raises JsonLdError where the text breaks the rules of JSON-LD outside of contexts.
        """
        active = self._get_initial_context(self.options)
        if context is not None:
            active = self._process_context(active, context, self.options)
        expanded = self._expand(active, None, parsed.value, self.options)
        if isinstance(expanded, dict) and expanded.keys() == {"@graph"}:
            expanded = expanded["@graph"]
        if expanded is None:
            return []
        return expanded if isinstance(expanded, list) else [expanded]

    def _on_dropped(self, expanded: str | None) -> None:
        # A term that a context maps to null is dropped on purpose and arrives as None.
        if isinstance(expanded, Iri):
            self.record.drop(expanded.token, self.trail[-1], blind=expanded.resolution.blind)

    def _expand(
        self, active_ctx: Context, active_property: Any, element: Any, options: Any, **state: Any
    ) -> Any:
        if isinstance(element, list):
            return self._expand_array(active_ctx, active_property, element, options, **state)
        if isinstance(element, Object):
            parent = self.trail[-1] if self.trail else None
            origin = Origin(element, parent, active_property)
            self.trail.append(origin)
            if element.overwritten is not None:
                self.repeated[id(element)] = origin
            result = super()._expand(active_ctx, active_property, element, options, **state)
            # Not in a `finally`: after an error the trail tells where it happened.
            self.trail.pop()
            return Expanded(result, element.span, origin) if type(result) is dict else result
        result = super()._expand(active_ctx, active_property, element, options, **state)
        if isinstance(element, bool) and type(result) is dict:
            return Expanded(result, value_span(active_property) or self.trail[-1].element.span)
        return result

    def _expand_array(
        self, active_ctx: Context, active_property: Any, element: list[Any], options: Any,
        *, inside_list: bool = False, **state: Any,
    ) -> ExpandedArray:  # fmt: skip
        """PyLD's own loop, save that it knows which element it is at."""
        place = element.span if isinstance(element, Array) else self._around(active_property)
        result = ExpandedArray(place)
        container = self.get_context_value(active_ctx, active_property, "@container")
        inside_list = inside_list or (container is not None and "@list" in container)
        on_node = self._taker(active_ctx, active_property)
        take = on_node or result.append
        for index, item in enumerate(element):
            expanded = self._expand(
                active_ctx, active_property, item, options, inside_list=inside_list, **state
            )
            if expanded is None:
                continue
            if isinstance(expanded, list):
                if inside_list:
                    take(Expanded({"@list": expanded}, _element_span(element, index)))
                else:
                    result.extend(expanded)
            elif isinstance(item, bool):
                take(Expanded(expanded, _element_span(element, index) or place))
            else:
                take(expanded)
            if on_node:
                element[index] = None
        return result

    def _taker(self, active_ctx: Context, active_property: Any) -> Callable[[Any], None] | None:
        """Who takes the elements of an array instead of the result: `on_node`, at the top."""
        if self.on_node is None or len(self.trail) != 1 or active_property is None:
            return None
        graph = self._expand_iri(active_ctx, active_property, vocab=True) == "@graph"
        return self.on_node if graph else None

    def _around(self, active_property: Any) -> Span:
        return value_span(active_property) or self.trail[-1].element.span

    def _prepare_nested_context(self, active_ctx: Context, element: Any, options: Any) -> Any:
        if "@context" not in element:
            return super()._prepare_nested_context(active_ctx, element, options)
        token = element.key("@context") if isinstance(element, Object) else None
        self.site = token.value_span if token else None
        if not self.strict and isinstance(element["@context"], Mapping):
            element = {**element, "@context": [element["@context"]]}
        prepared = super()._prepare_nested_context(active_ctx, element, options)
        if len(self.trail) == 1:
            self.record.declare(prepared[0]["mappings"])
        return prepared

    def _expand_iri(
        self, active_ctx: Context, value: Any, base: Any = None, vocab: Any = None, **terms: Any
    ) -> Any:
        if not isinstance(value, Text) or type(active_ctx) is not frozendict or terms:
            return super()._expand_iri(active_ctx, value, base, vocab, **terms)
        about = (id(active_ctx), bool(vocab), base)
        meanings = self._meanings.get(about)
        if meanings is None:
            meanings = self._meanings[about] = {}
            self._kept.append(active_ctx)
        meaning = meanings.get(value)
        if meaning is None:
            plain = str(value)
            iri = super()._expand_iri(active_ctx, plain, base, vocab)
            reach = _reach(active_ctx, plain, iri, base, vocab=bool(vocab))
            meaning = meanings[plain] = Resolution(iri, reach, bool(active_ctx.get("_blind")))
        if meaning.iri is None:
            if isinstance(value, Key) and _LIKE_KEYWORD.match(value) and self.trail:
                self.record.drop(value, self.trail[-1], blind=False)
            return None
        if meaning.iri in _KEYWORDS:
            return meaning.iri
        if self.record.shadows:
            self.record.resolved(value, meaning)
        result = Iri(meaning.iri)
        result.token = value
        result.resolution = meaning
        return result


def _element_span(array: list[Any], index: int) -> Any:
    return array.element_span(index) if isinstance(array, Array) else None


def _reach(context: Context, value: str, iri: Any, base: Any, *, vocab: bool) -> Reach:
    """By which of its steps IRI expansion (JSON-LD 1.1 API, 5.2) came to *iri*."""
    if vocab and value in context["mappings"]:
        return Reach.TERM
    return _reach_of_compact(context, value) or _reach_of_relative(
        context, iri == value, base, vocab=vocab
    )


def _reach_of_compact(context: Context, value: str) -> Reach | None:
    prefix, colon, suffix = value.partition(":")
    if not prefix or not colon:
        return None
    if prefix == "_":
        return Reach.BLANK
    if suffix.startswith("//"):
        return Reach.ABSOLUTE
    mapping = context["mappings"].get(prefix)
    if mapping and mapping["_prefix"]:
        return Reach.PREFIX
    return Reach.SCHEME if _ABSOLUTE.match(value) else None


def _reach_of_relative(context: Context, unchanged: bool, base: Any, *, vocab: bool) -> Reach:  # noqa: FBT001
    author = context.get("@base")
    if vocab and "@vocab" in context:
        vocabulary = context["@vocab"]
        fell = isinstance(base, str) and base and str(vocabulary).startswith(base)
        return Reach.DOCUMENT_BASE if fell else Reach.VOCAB
    if base is None or unchanged or ("@base" in context and author is None):
        return Reach.NOWHERE
    return Reach.AUTHORS_BASE if author and _ABSOLUTE.match(author) else Reach.DOCUMENT_BASE
