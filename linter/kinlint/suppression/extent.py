"""Which comments cover a place: elements lie within each other or apart, so they make a tree."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from kinlint.suppression.directive import Directive
from kinlint.text import Location, Span


@dataclass(frozen=True, slots=True)
class _Nest:
    """The extents in one file, by their beginning; `around` is the number of the next larger."""

    spans: Sequence[Span]
    around: Sequence[int]
    directives: Sequence[Directive]


@dataclass(frozen=True, slots=True)
class Extents:
    """The directives that cover what is written within an element, by the names of files."""

    nests: dict[str, _Nest]

    @classmethod
    def of(cls, directives: Iterable[Directive]) -> Extents:
        """Those of *directives* that have an extent."""
        files: dict[str, list[tuple[Span, Directive]]] = {}
        for one in directives:
            if one.extent is not None and not one.whole_file:
                files.setdefault(one.extent.source.name, []).append((one.extent.span, one))
        return cls({name: _nest(found) for name, found in files.items()})

    def around(self, place: Location) -> Iterator[Directive]:
        """The directives whose extent *place* lies in, the innermost first."""
        nest = self.nests.get(place.source.name)
        if nest is None:
            return
        start, end = place.span
        at = bisect_right(nest.spans, start, key=lambda span: span.start) - 1
        while at >= 0:
            if end <= nest.spans[at].end:
                yield nest.directives[at]
            at = nest.around[at]


def _nest(found: list[tuple[Span, Directive]]) -> _Nest:
    found.sort(key=lambda pair: (pair[0].start, -pair[0].end))
    spans = [span for span, _ in found]
    around: list[int] = []
    for number, span in enumerate(spans):
        outer = number - 1
        while outer >= 0 and spans[outer].end < span.end:
            outer = around[outer]
        around.append(outer)
    return _Nest(spans, around, [one for _, one in found])
