"""The outermost graph of a file, element by element: compiled, or expanded by PyLD."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.compiled.element_compiler import ElementCompiler, Group, PlacedGroup
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.triples import Triples


class CompiledGraph:
    """States the elements of the outermost graph in turn; `groups` are the statements so far."""

    def __init__(
        self,
        processor: Processor,
        blanks: BlankNodes,
        triples: Triples,
        watch: LossObserver,
        repeats: list[Object],
    ) -> None:
        self.groups: list[Group] = []
        self._compiler = ElementCompiler(processor)
        self._blanks = blanks
        self._triples = triples
        self._watch = watch
        self._repeats = repeats

    @property
    def declined(self) -> Mapping[str, int]:
        """The number of elements that PyLD expanded, by reason."""
        return self._compiler.declined

    def take(self, element: Unplaced, outer: Any, key: str) -> Object | None:
        """State *element* under *key* of the object with the context *outer*.

        Return it with its places if PyLD has to expand it, and None otherwise.
        """
        group = self._compiler.state(element, outer, key, self._blanks, self._watch)
        if group is None:
            placed, repeats = element.placed()
            self._repeats += repeats
            return placed
        if self._triples.spans or self._triples.nodes:
            self.finish()
        self.groups.append(group)
        return None

    def finish(self) -> None:
        """Add what was expanded by PyLD since the last element."""
        triples = self._triples
        self.groups.append(PlacedGroup(triples.spans, triples.nodes))
        triples.spans, triples.nodes = {}, {}
