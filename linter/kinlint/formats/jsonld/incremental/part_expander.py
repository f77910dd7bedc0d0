"""Expands a file element by element, and elements of it again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.traced_values import ExpandedArray, Origin
from kinlint.text import Span


class Indivisible(Exception):
    """The file is not the sum of its parts, or cannot be shown to be."""


class DividedProcessor(Processor):
    """A processor that leaves the elements of the outermost graph to *take*.

    It stays at the place of that graph: what `expand` gives is what it would give there. `around`
    is the object that holds the graph, `place` where its elements stand with their brackets.
    """

    def __init__(
        self,
        memory: ContextCache,
        base: str,
        local: LocalContexts,
        take: Callable[[Array, Context, str], None],
    ) -> None:
        super().__init__(memory, base, local)
        self._take = take
        self._taken: list[Any] = []
        self._there: Callable[[Array], ExpandedArray] | None = None
        self.around: Origin | None = None
        self.place = Span(0, 0)
        self.on_node = self._taken.append

    @property
    def contexts(self) -> int:
        """Return the number of active contexts in the cache."""
        return len(self._kept)

    def expand(self, element: Object) -> list[Any]:
        """Return the nodes that *element* is, as an element of the outermost graph: one or none.

        Raises Indivisible if it becomes more than an element of that, and what expansion raises.
        """
        if self._there is None or self.around is None:
            raise Indivisible
        alone = Array(element.start)
        alone.end = element.end
        alone.append(element)
        self.trail[:] = [self.around]
        self._taken.clear()
        outside = self._there(alone)
        if outside:
            raise Indivisible
        return list(self._taken)

    def _expand_array(  # noqa: PLR0913  the signature is the processor's
        self, active_ctx: Context, active_property: Any, element: list[Any], options: Any,
        *, inside_list: bool, inside_index: bool, type_scoped_ctx: Any,
    ) -> ExpandedArray:  # fmt: skip
        def there(elements: list[Any]) -> ExpandedArray:
            return above(
                active_ctx, active_property, elements, options,
                inside_list=inside_list, inside_index=inside_index, type_scoped_ctx=type_scoped_ctx,
            )  # fmt: skip

        above = super()._expand_array
        if self._taker(active_ctx, active_property) is None:
            return there(element)
        if self._there is not None or not isinstance(element, Array):
            raise Indivisible
        self._there, self.around = there, self.trail[-1]
        self.place = element.span
        self._take(element, active_ctx, active_property)
        return ExpandedArray(element.span)
