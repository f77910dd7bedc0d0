"""Scopes of suppression comments: everything within the element that they are about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kinlint.suppression.directive import Directive
from kinlint.suppression.interval_index import IntervalIndex
from kinlint.text import Location, Span


@dataclass(frozen=True, slots=True)
class SuppressionScopes:
    """The directives that cover what is written within an element, by the names of files."""

    nests: dict[str, IntervalIndex[Directive]]

    @classmethod
    def from_directives(cls, directives: Iterable[Directive]) -> SuppressionScopes:
        """Index the *directives* that have an extent."""
        files: dict[str, list[tuple[Span, Directive]]] = {}
        for one in directives:
            if one.extent is not None and not one.whole_file:
                files.setdefault(one.extent.source.name, []).append((one.extent.span, one))
        return cls({name: IntervalIndex.from_spans(found) for name, found in files.items()})

    def covering(self, place: Location) -> Iterator[Directive]:
        """The directives whose extent *place* lies in, the innermost first."""
        nest = self.nests.get(place.source.name)
        return iter(()) if nest is None else nest.containing(place.span)
