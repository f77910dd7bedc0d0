"""Writes an expanded tree as text, and notes for each part of it the text that wrote that."""

from __future__ import annotations

from typing import NamedTuple
from xml.sax.saxutils import escape

from kinlint.formats.xacro.dom import Character, Comment, Element, Node, Raw, Text
from kinlint.formats.xacro.included_files import Pieces
from kinlint.formats.xacro.origin import Origin
from kinlint.formats.xacro.source_mapping import MappedRange, MappedText
from kinlint.formats.xacro.text_evaluation import Traced
from kinlint.formats.xacro.xacro_parser import ParsedXacro
from kinlint.text import Span


def write(parsed: ParsedXacro, pieces: Pieces) -> MappedText:
    """Return the text of the document *parsed*, whose nodes are from *pieces*."""
    writer = _Writer(pieces)
    for node in parsed.before:
        writer.node(node)
    assert parsed.root is not None
    writer.tree(parsed.root)
    for node in parsed.after:
        writer.node(node)
    return MappedText("".join(writer.parts), tuple(writer.leaves))


class _EvaluatedValue(NamedTuple):
    """A value that was evaluated."""

    value: str
    """The value."""
    origin: Origin
    """The text that wrote the node."""
    place: Span
    """The place of what was evaluated."""
    skipped: int = 0
    """Number of its first characters that are left out."""
    offset: int = 0
    """Number of characters before it in what was evaluated."""


class _Writer:
    def __init__(self, pieces: Pieces) -> None:
        self.parts: list[str] = []
        self.leaves: list[MappedRange] = []
        self._pieces = pieces
        self._at = 0

    def _put(self, text: str, origin: Origin, span: Span, *, exact: bool = False) -> None:
        """Write *text*, which comes from *span* of the text of *origin*.

        *exact*: character by character.
        """
        if not text:
            return
        begin = self._pieces.begin(origin.source)
        self.parts.append(text)
        self.leaves.append(MappedRange(self._at, begin + span.start, begin + span.end, exact))
        self._at += len(text)

    def _copy(self, origin: Origin, span: Span) -> None:
        self._put(origin.source[span], origin, span, exact=True)

    def tree(self, root: Element) -> None:
        """Write an element with all that is inside, without recursion."""
        waiting: list[tuple[Node, bool]] = [(root, False)]
        while waiting:
            node, closing = waiting.pop()
            if closing:
                assert isinstance(node, Element)
                self._close(node)
            elif isinstance(node, Element):
                self._open(node)
                if node.firstChild is not None:
                    waiting.append((node, True))
                    waiting.extend((child, False) for child in reversed(list(node.children)))
            else:
                self.node(node)

    def node(self, node: Node) -> None:
        """Write a comment or a text."""
        assert isinstance(node, Character)
        origin, data = node.origin, node.data
        if data == node.written and origin.end > origin.start:
            self._copy(origin, origin.span)
        elif isinstance(node, Comment):
            self._put(f"<!--{data}-->", origin, origin.span)
        elif isinstance(node, Text) and not isinstance(node, Raw):
            self._text(data, origin)

    def _text(self, data: str, origin: Origin) -> None:
        """Write a text that was evaluated: the blanks around it are not part of its value."""
        inside = data.strip()
        before = data[: len(data) - len(data.lstrip())] if inside else data
        place = origin.stripped
        self._put(before, origin, Span(place.start, place.start))
        start = place.start - origin.start
        self._evaluated(escape(inside), _EvaluatedValue(data, origin, place, len(before), start))
        after = data[len(before) + len(inside) :]
        self._put(after, origin, Span(place.end, place.end))

    def _open(self, node: Element) -> None:
        origin = node.origin
        name = origin.tag
        self._copy(origin, Span(origin.start, origin.start + 1))
        self._put(node.tagName, origin, name, exact=origin.source[name] == node.tagName)
        for each, value in node.values.items():
            self._attribute(node, each, value)
        closed = node.firstChild is None
        end = origin.inside
        if closed:
            self._put("/>", origin, Span(max(origin.start, origin.end - 2), origin.end))
        else:
            self._put(">", origin, Span(end - 1, end))

    def _close(self, node: Element) -> None:
        origin = node.origin
        start = min(origin.closing, origin.end)
        self._put(f"</{node.tagName}>", origin, Span(start, origin.end))

    def _attribute(self, node: Element, name: str, value: str) -> None:
        origin = node.givers.get(name, node.origin)
        given = origin is not node.origin
        spans = origin.attributes.get("value" if given else name)
        if spans is None:
            self._put(f' {name}="{escape(value, QUOTED)}"', origin, origin.tag)
            return
        if given:
            named = origin.attributes.get("name", spans).value
            exact = origin.source[named] == name
        else:
            named, exact = spans.name, True
        self._put(" ", origin, Span(named.start, named.start))
        self._put(name, origin, named, exact=exact)
        quote = origin.source.text[spans.value.start - 1]
        self._put("=", origin, Span(named.end, named.end))
        self._put(quote, origin, Span(spans.value.start - 1, spans.value.start))
        if not given and value == node.written.get(name):
            # Whoever parses XML finds blanks there, and so does whoever reads what xacro writes.
            as_read = origin.source[spans.value].translate(SPACES)
            self._put(as_read, origin, spans.value, exact=True)
        else:
            quoted = {quote: QUOTED[quote], **BLANKS}
            self._evaluated(escape(value, quoted), _EvaluatedValue(value, origin, spans.value))
        self._put(quote, origin, Span(spans.value.end, spans.value.end + 1))

    def _evaluated(self, text: str, said: _EvaluatedValue) -> None:
        """Write *text*, the value of *said*, part by part."""
        value, skipped, origin, place = said.value, said.skipped, said.origin, said.place
        raw = origin.source[place]
        whole = "&" not in raw and "\r" not in raw and text == value[skipped : skipped + len(text)]
        if not (isinstance(value, Traced) and whole):
            self._put(text, origin, place)
            return
        base = place.start - said.offset
        for part in value.parts:
            start, end = max(part.start, skipped), min(part.end, skipped + len(text))
            if start >= end:
                continue
            span = Span(base + part.begin, base + part.stop)
            exact = origin.source[span] == value[part.start : part.end]
            if exact:
                span = Span(span.start + start - part.start, span.end - (part.end - end))
            self._put(value[start:end], origin, span, exact=exact)


QUOTED = {'"': "&quot;", "'": "&apos;"}
SPACES = dict.fromkeys(map(ord, "\t\r\n"), " ")
BLANKS = {"\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}
