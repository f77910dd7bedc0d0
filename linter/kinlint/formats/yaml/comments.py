"""Comments in YAML that silence rules: those of `kinlint.formats.line_directives`.

They are about keys with their values, and members of lists.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import yaml

from kinlint.formats.line_directives import state_directives
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xml.suppression_comments import MARK


def state_comments(text: str, tops: Sequence[yaml.Node], layer: SourceLayer) -> None:
    """Put what the comments of *text*, whose documents are *tops*, silence into *layer*."""
    if MARK not in text:
        return
    every = [*_nodes(tops)]
    scalars = [
        (each.start_mark.index, each.end_mark.index)
        for each in every
        if isinstance(each, yaml.ScalarNode)
    ]
    entries = sorted(each for node in every for each in _entries(node))

    def is_content(offset: int) -> bool:
        return any(start < offset < end for start, end in scalars)

    state_directives(text, entries, is_content, layer)


def _nodes(tops: Sequence[yaml.Node]) -> Iterator[yaml.Node]:
    """Yield all nodes, each once."""
    waiting, seen = [*tops], set[int]()
    while waiting:
        node = waiting.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        yield node
        if isinstance(node, yaml.MappingNode):
            waiting += (each for pair in node.value for each in pair)
        elif isinstance(node, yaml.SequenceNode):
            waiting += node.value


def _entries(node: yaml.Node) -> Iterator[tuple[int, int]]:
    """Yield the places of the keys of *node* with their values, or of its members."""
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            start = key.start_mark.index
            yield start, max(key.end_mark.index, value.end_mark.index)
    elif isinstance(node, yaml.SequenceNode):
        yield from ((each.start_mark.index, each.end_mark.index) for each in node.value)
