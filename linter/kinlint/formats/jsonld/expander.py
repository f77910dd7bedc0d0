"""PyLD's expansion, with the place of everything it expands riding along."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.json_text.json_values import (
    Array,
    Integer,
    Key,
    Object,
    ParsedJson,
    Real,
    Text,
)
from kinlint.formats.jsonld.active_context import UNREAD, ActiveContexts, Context, uncertain
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expansion_record import ExpansionRecord
from kinlint.formats.jsonld.iri_reach import reach_of
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.missing_context import CONTEXT, lacks_context, misnamed_context
from kinlint.formats.jsonld.pyld import KEYWORD_PATTERN, KEYWORDS, JsonLdProcessor, frozendict
from kinlint.formats.jsonld.traced_values import (
    RELATIVE,
    Expanded,
    ExpandedArray,
    Iri,
    Origin,
    Reach,
    Resolution,
    value_span,
)
from kinlint.text import Span

_KEYWORDS = frozenset(KEYWORDS)
_CONTENT = frozenset({"@value", "@list", "@set"})
_LIKE_KEYWORD = re.compile(KEYWORD_PATTERN)


class Processor(ActiveContexts, JsonLdProcessor):  # type: ignore[misc]
    """Expands one file; `record` holds what was noticed on the way.

    `trail` holds the objects round the one at work: the innermost is where an error happened.
    `repeated` finds the objects in which a key stands more than once. `on_node`, if set, is
    given each element of the outermost graph as soon as it is expanded; it is missing from the
    result then, and from the parsed text, so that a large file is in memory but once.
    """

    def __init__(
        self,
        memory: ContextCache,
        base: str,
        local: LocalContexts | None = None,
        *,
        strict: bool = False,
        mode: str = "1.1",
    ) -> None:
        ActiveContexts.__init__(self, memory, local, strict=strict)
        JsonLdProcessor.__init__(self, on_property_dropped=self._on_dropped)
        self.record = ExpansionRecord()
        self.trail: list[Origin] = []
        self.repeated: dict[int, Origin] = {}
        self.on_node: Callable[[Any], None] | None = None
        self.on_unplaced: Callable[[Unplaced, Context, str], Object | None] = _place
        """Takes an element without places of the outermost graph, or returns it with places."""
        self.options: dict[str, Any] = {
            "base": base,
            "isFrame": False,
            "keepFreeFloatingNodes": False,
            "processingMode": f"json-ld-{mode}",
            "contextResolver": self.resolver,
        }
        self._meanings: dict[tuple[int, bool, str | None], dict[str, Resolution]] = {}
        self._kept: list[Context] = []
        self.contextless = False
        """True if no object of the text has a context."""
        self.misnamed: Key | None = None
        """The outermost key that is read as `@context`, if it must have been meant."""
        memory.begin(self._get_initial_context(self.options))

    def expand_document(self, parsed: ParsedJson, context: Any = None) -> list[Any]:
        """Return the expanded form of a JSON text; *context* is in force from the start.

        Raises JsonLdError where the text breaks the rules of JSON-LD outside of contexts.
        """
        active = self._get_initial_context(self.options)
        if context is not None:
            active = self._process_context(active, context, self.options)
        elif not self.strict and lacks_context(parsed):
            self.contextless = True
            self.misnamed = misnamed_context(parsed.value)
            active = uncertain(active, CONTEXT)
        expanded = self._expand(active, None, parsed.value, self.options)
        if isinstance(expanded, dict) and expanded.keys() == {"@graph"}:
            expanded = expanded["@graph"]
        if expanded is None:
            return []
        return expanded if isinstance(expanded, list) else [expanded]

    @property
    def initial(self) -> Context:
        """The context in which every file begins."""
        return self._get_initial_context(self.options)

    def nested_context(self, active: Context, node: Mapping[str, Any]) -> Context:
        """Return the context in the object *node*: by its own contexts, and by those of its types.

        Only its `@context` and its types are looked at.
        """
        found: Context = super()._prepare_nested_context(active, node, self.options)[0]
        return found

    def entering(self, outer: Context, key: str | None) -> Context:
        """Return the context of a value of *key*, before its own contexts and those of its types.

        Steps 3 and 7 to 8 of the expansion algorithm (JSON-LD 1.1 API, 5.1).
        """
        scoped = self.get_context_value(outer, key, "@context")
        if scoped is not None:
            outer = self._process_context(
                outer, scoped, self.options, propagate=True, override_protected=True
            )
        outer = self._revert_to_previous_context(outer)
        if scoped is not None:
            outer = self._process_context(outer, scoped, self.options, override_protected=True)
        return outer

    def _on_dropped(self, expanded: str | None) -> None:
        # A term that a context maps to null is dropped on purpose and arrives as None.
        if isinstance(expanded, Iri) and expanded.token is not self.misnamed:
            self.record.drop(expanded.token, self.trail[-1], expanded.resolution)

    # The flags are spelled out: Python 3.12 counts a call with ** against a limit of its own.
    def _expand(  # noqa: PLR0913  the signature is PyLD's
        self, active_ctx: Context, active_property: Any, element: Any, options: Any,
        *, inside_list: bool = False, inside_index: bool = False, type_scoped_ctx: Any = None,
    ) -> Any:  # fmt: skip
        if isinstance(element, list):
            return self._expand_array(
                active_ctx, active_property, element, options,
                inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
            )  # fmt: skip
        if isinstance(element, Object):
            parent = self.trail[-1] if self.trail else None
            origin = Origin(element, parent, active_property)
            self.trail.append(origin)
            if element.overwritten is not None:
                self.repeated[id(element)] = origin
            result = super()._expand(
                active_ctx, active_property, element, options,
                inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
            )  # fmt: skip
            # Not in a `finally`: after an error the trail tells where it happened.
            self.trail.pop()
            if result is None and origin.content and element.get(origin.content) is not None:
                self.record.float(element[origin.content], element.span)
            return Expanded(result, element.span, origin) if type(result) is dict else result
        result = super()._expand(
            active_ctx, active_property, element, options,
            inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
        )  # fmt: skip
        if isinstance(element, bool) and type(result) is dict:
            return Expanded(result, self._around(active_property))
        if result is None and isinstance(element, (Text, Integer, Real)):
            self.record.float(element, element.span)
        return result

    def _expand_index_map(
        self, active_ctx: Context, active_property: Any, value: dict[str, Any], *rest: Any
    ) -> Any:
        """Expand an index map: literals carry no place, but arrays know those of their elements."""
        placed = dict(value)
        for key, item in value.items():
            if isinstance(item, bool) and isinstance(key, Key):
                placed[key] = Array(key.value_start)
                placed[key].literals = {0: key.value_span}
                placed[key].append(item)
        return super()._expand_index_map(active_ctx, active_property, placed, *rest)

    def _expand_array(  # noqa: PLR0913
        self, active_ctx: Context, active_property: Any, element: list[Any], options: Any,
        *, inside_list: bool, inside_index: bool, type_scoped_ctx: Any,
    ) -> ExpandedArray:  # fmt: skip
        """Expand an array as PyLD does, but keep track of the current element."""
        place = element.span if isinstance(element, Array) else self._around(active_property)
        result = ExpandedArray(place)
        container = self.get_context_value(active_ctx, active_property, "@container")
        inside_list = inside_list or (container is not None and "@list" in container)
        on_node = self._taker(active_ctx, active_property)
        take = on_node or result.append
        for index, item in enumerate(element):
            if type(item) is Unplaced:
                item = self.on_unplaced(item, active_ctx, active_property)  # noqa: PLW2901
                if item is None:
                    continue
            expanded = self._expand(
                active_ctx, active_property, item, options,
                inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
            )  # fmt: skip
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
        """Return the receiver of array elements, `on_node` for the top-level graph; else None."""
        if self.on_node is None or len(self.trail) != 1 or active_property is None:
            return None
        graph = self._expand_iri(active_ctx, active_property, vocab=True) == "@graph"
        return self.on_node if graph else None

    def _around(self, active_property: Any) -> Span:
        origin = self.trail[-1]
        return value_span(origin.content) or value_span(active_property) or origin.element.span

    def _prepare_nested_context(self, active_ctx: Context, element: Any, options: Any) -> Any:
        token = element.key(CONTEXT) if isinstance(element, Object) else None
        if self.misnamed is not None and len(self.trail) == 1:
            token = self.misnamed
            element = {**element, CONTEXT: element[token]}
            active_ctx = self._get_initial_context(self.options)
        if CONTEXT not in element:
            return super()._prepare_nested_context(active_ctx, element, options)
        self.site = token.value_span if token else None
        if not self.strict and isinstance(element[CONTEXT], Mapping):
            element = {**element, CONTEXT: [element[CONTEXT]]}
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
            bases = (base, self.options["base"])
            reach = reach_of(active_ctx, plain, iri, bases, vocab=bool(vocab))
            meant = active_ctx["mappings"] if vocab and reach in RELATIVE else {}
            unread = active_ctx.get(UNREAD, "")
            meaning = meanings[plain] = Resolution(iri, reach, unread, meant)
        if meaning.iri is None or meaning.iri in _KEYWORDS:
            if self.trail:
                self._reserved(value, meaning.iri, self.trail[-1])
            return meaning.iri
        if self.record.shadows:
            self.record.resolved(value, meaning)
        result = Iri(meaning.iri)
        result.token = value
        result.resolution = meaning
        if base is not None and self.trail:
            self.trail[-1].identify(value, result)
        return result

    def _reserved(self, token: Text, keyword: str | None, origin: Origin) -> None:
        """Note what the keyword *token* does to its object, or that it is none."""
        if not isinstance(token, Key):
            if keyword != "@json" and (keyword or _LIKE_KEYWORD.match(token)):
                self.record.reserve(token, origin)
        elif keyword is None:
            like = _LIKE_KEYWORD.match(token) is not None
            self.record.clear(token, origin, Resolution(None, Reach.NOWHERE) if like else None)
        elif keyword in _CONTENT:
            origin.content = token
        elif keyword == "@id":
            origin.naming = token


def _place(element: Unplaced, _context: Context, _key: str) -> Object:
    return element.placed()[0]


def _element_span(array: list[Any], index: int) -> Any:
    return array.element_span(index) if isinstance(array, Array) else None
