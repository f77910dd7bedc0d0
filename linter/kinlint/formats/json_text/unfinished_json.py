"""Objects of a JSON text that is being typed, and the place of the cursor among them.

Nothing has to be well-formed: a string ends with its line at the latest, commas and colons may be
missing, and a bracket closes the innermost object or array that it fits.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Span

_TOKEN = re.compile(r'"(?P<string>(?:[^"\\\r\n]|\\.)*)(?P<end>"?)|[{}\[\]:,]|[^\s{}\[\]:,"]+')


@dataclass(eq=False)
class UnfinishedNode:
    """An object or an array as far as it is written."""

    is_object: bool
    """True of an object."""
    span: Span
    """Place of it, with its brackets."""
    parent: UnfinishedNode | None = None
    """The object or array that it is in; None at the top."""
    key: str | None = None
    """The key of the member of the nearest object around that it is in, or is."""
    members: list[tuple[str | None, Any, Span]] = field(default_factory=list)
    """The members of an object, or elements of an array, whose keys are None: with each its value,
    a node or a scalar, and the place of its key or else of itself."""

    @property
    def value(self) -> Any:
        """The same as Python has it."""
        found = [
            (key, each.value if isinstance(each, UnfinishedNode) else each)
            for key, each, _ in self.members
        ]
        return dict(found) if self.is_object else [each for _, each in found]

    def get(self, key: str) -> Any:
        """Return the value of the member *key* as Python has it; None if there is none."""
        found = next((each for name, each, _ in self.members if name == key), None)
        return found.value if isinstance(found, UnfinishedNode) else found

    @property
    def around(self) -> Iterator[UnfinishedNode]:
        """Yield itself and what it is in, the innermost first."""
        at: UnfinishedNode | None = self
        while at is not None:
            yield at
            at = at.parent


@dataclass
class JsonCursor:
    """The place of the cursor."""

    node: UnfinishedNode
    """The innermost object or array around."""
    is_key: bool
    """True where a key is, or can be."""
    key: str | None
    """The key of the member whose value the cursor is in."""
    token: Span
    """The string or word that the cursor is in, with its quotes; empty between tokens."""
    quoted: bool
    """True if the token is a string."""


class UnfinishedJson:
    """The objects and arrays of *text*; `cursor` is the place of *offset*, if it is in one.

    `nodes` are all of them, outer ones first.
    """

    def __init__(self, text: str, offset: int) -> None:
        self.text = text
        self.cursor: JsonCursor | None = None
        self.nodes: list[UnfinishedNode] = []
        self._offset = offset
        self._node: UnfinishedNode | None = None
        self._key: tuple[str, Span] | None = None
        self._colon = False
        end = 0
        for match in _TOKEN.finditer(text):
            if self.cursor is None and match.start() >= offset:
                self._place(Span(offset, offset), quoted=False)
            self._take(match)
            end = match.end()
        if self.cursor is None and end < offset:
            self._place(Span(offset, offset), quoted=False)
        while self._node is not None:
            self._close(self._node, len(text))

    def _take(self, match: re.Match[str]) -> None:
        mark, span = match[0], Span(*match.span())
        if mark in ("{", "["):
            self._begin(mark == "{", span)
        elif mark in ("}", "]"):
            node = self._node
            while node is not None and node.is_object != (mark == "}"):
                node = node.parent
            while node is not None and self._node is not None:
                closed = self._node
                self._close(closed, span.end)
                if closed is node:
                    break
        elif mark == ":":
            self._colon = self._key is not None
        elif mark == ",":
            self._key, self._colon = None, False
        else:
            self._scalar(match, span)

    def _scalar(self, match: re.Match[str], span: Span) -> None:
        quoted = match["string"] is not None
        inside = span.start < self._offset <= (span.end - len(match["end"] or ""))
        if self.cursor is None and inside:
            self._place(span, quoted=quoted)
        node = self._node
        if node is None:
            return
        if not node.is_object:
            node.members.append((None, _scalar(match[0]), span))
        elif self._key is not None and self._colon:
            node.members.append((self._key[0], _scalar(match[0]), self._key[1]))
            self._key, self._colon = None, False
        elif quoted:
            self._key = match["string"], span

    def _begin(self, is_object: bool, span: Span) -> None:  # noqa: FBT001
        outer = self._node
        key = self._key[0] if self._key else outer.key if outer and not outer.is_object else None
        node = UnfinishedNode(is_object, span, outer, key)
        self.nodes.append(node)
        if outer is not None:
            place = self._key[1] if self._key else span
            outer.members.append((self._key[0] if self._key else None, node, place))
        self._node, self._key, self._colon = node, None, False

    def _close(self, node: UnfinishedNode, end: int) -> None:
        node.span = Span(node.span.start, end)
        self._node, self._key, self._colon = node.parent, None, False

    def _place(self, token: Span, *, quoted: bool) -> None:
        node = self._node
        if node is None:
            return
        is_key = node.is_object and not (self._key is not None and self._colon)
        key = (self._key[0] if self._key else None) if node.is_object else node.key
        self.cursor = JsonCursor(node, is_key, None if is_key else key, token, quoted)


def _scalar(token: str) -> Any:
    try:
        return json.loads(token)
    except ValueError:
        return token.strip('"')
