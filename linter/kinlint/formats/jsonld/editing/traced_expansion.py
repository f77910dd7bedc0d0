"""Expansion that notes the contexts at each object, and what each states at every place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.pyld import frozendict
from kinlint.formats.jsonld.traced_values import Expanded, Origin
from kinlint.formats.jsonld.triples import Triples
from kinlint.terms import Term, Triple
from kinlint.text import Span


class ContextScope(NamedTuple):
    """The contexts at an object: around it, for its keys, and for the names of its types."""

    outer: Context
    """Context around the object."""
    keys: Context
    """Context that gives its keys their meaning."""
    types: Context
    """Context that gives the names of its types their meaning."""


class Tracing(Processor):
    """Expansion that notes scope and origin of each object, by its identity, while `tracing`."""

    def __init__(self, memory: ContextCache, base: str, local: LocalContexts) -> None:
        super().__init__(memory, base, local)
        self.scopes: dict[int, ContextScope] = {}
        self.origins: dict[int, Origin] = {}
        self.tracing = True
        self._inverse: dict[int, tuple[Context, Any]] = {}
        self._there: Callable[[list[Any]], Any] | None = None
        self._outermost: Origin | None = None

    def trace_element(self, element: Object) -> None:
        """Expand *element* as one of the outermost graph, which was expanded before."""
        assert self._there is not None
        assert self._outermost is not None
        alone = Array(element.start)
        alone.end = element.end
        alone.append(element)
        before, self.tracing = self.trail[:], True
        self.trail[:] = [self._outermost]
        self._there(alone)
        self.trail[:], self.tracing = before, False

    def _expand_array(  # noqa: PLR0913  the signature is the processor's
        self, active_ctx: Context, active_property: Any, element: list[Any], options: Any,
        *, inside_list: bool, inside_index: bool, type_scoped_ctx: Any,
    ) -> Any:  # fmt: skip
        def there(elements: list[Any]) -> Any:
            return above(
                active_ctx, active_property, elements, options,
                inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
            )  # fmt: skip

        above = super()._expand_array
        if self._taker(active_ctx, active_property) is not None:
            self._there, self._outermost = there, self.trail[-1]
        return there(element)

    def _prepare_nested_context(self, active_ctx: Context, element: Any, options: Any) -> Any:
        prepared = super()._prepare_nested_context(active_ctx, element, options)
        if self.tracing and isinstance(element, Object):
            self.scopes[id(element)] = ContextScope(active_ctx, prepared[0], prepared[2])
            self.origins[id(element)] = self.trail[-1]
        return prepared

    def _get_inverse_context(self, active_ctx: Context) -> Any:
        """Return the inverse context, uncached.

        PyLD's key may be shared by different contexts here.
        """
        known = self._inverse.get(id(active_ctx))
        if known is None:
            own = frozendict({**active_ctx, "_uuid": f"kinlint {id(self)} {id(active_ctx)}"})
            known = self._inverse[id(active_ctx)] = (
                active_ctx,
                super()._get_inverse_context(own),
            )
        return known[1]


class Tracks(Triples):
    """Triples that also keep where they are repeated, and which objects describe a node.

    *described* is told which node an object describes, by its identity.
    """

    def __init__(self, blanks: BlankNodes, described: dict[int, Term]) -> None:
        super().__init__(blanks)
        self.again: dict[Triple, list[Span]] = {}
        self.objects: dict[Term, list[Object]] = {}
        self.origins: dict[int, Origin] = {}
        """The objects that were expanded for them, by their identity."""
        self._described = described

    @cached_property
    def by_start(self) -> Sequence[tuple[int, Triple]]:
        """The offsets at which values stand, ascending, with their triples."""
        starts = [(span.start, triple) for triple, span in self.spans.items()]
        starts += [(span.start, triple) for triple, spans in self.again.items() for span in spans]
        return sorted(starts)

    def _emit(
        self, subject: Term | None, prop: Term | None, value: Term | None, span: Span
    ) -> None:
        if subject is not None and prop is not None and value is not None:
            triple = subject, prop, value
            if triple in self.spans:
                self.again.setdefault(triple, []).append(span)
        super()._emit(subject, prop, value, span)

    def _node(self, node: dict[str, Any], whole: Span) -> Term | None:
        subject = super()._node(node, whole)
        origin: Origin | None = node.origin if isinstance(node, Expanded) else None
        if subject is not None and origin is not None:
            self._described[id(origin.element)] = subject
            if any(prop != "@id" for prop in node):
                self.objects.setdefault(subject, []).append(origin.element)
        return subject
