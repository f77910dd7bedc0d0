"""The way back from the triples of an XML file to its text, worked out when somebody asks.

Kept are only the offsets of the tags; everything finer is found by reading the tag again.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from heapq import merge
from typing import Any, NamedTuple

from kinlint.document import NodeSpans, OrderedNodes
from kinlint.formats.xml.value_reading import SPACE
from kinlint.terms import Term, Triple, iri
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE, SRC

LETTER = re.compile(r"[^\x00-\x7f]")


class Offsets:
    """Turns the offsets of bytes in UTF-8 into offsets of characters.

    *inserted* are the characters of *text*, in order, that are to count for nothing; all of them
    are ASCII.
    """

    def __init__(self, text: str, inserted: Sequence[int] = ()) -> None:
        self._bytes: list[int] = []
        self._extra: list[int] = [0]
        if text.isascii() and not inserted:
            return
        wide = (
            (match.start(), len(match[0].encode("utf-8", "surrogatepass")) - 1)
            for match in LETTER.finditer(text)
        )
        bytes_, extra = 0, 0
        for at, more in merge(wide, ((at, 0) for at in inserted)):
            self._bytes.append(at + bytes_)
            bytes_ += more
            extra += more or 1
            self._extra.append(extra)

    def __call__(self, byte: int) -> int:
        """Return the offset of the character that begins at *byte*."""
        if not self._bytes:
            return byte
        return byte - self._extra[bisect_right(self._bytes, byte - 1)]


NAME = re.compile(r"[^\s=<>\"'/]+")
WRITTEN = re.compile(r"\s*([^\s=<>\"'/]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
END = re.compile(r"\s*/?>")
MARKUP = re.compile(
    r"""<!--.*?--> | <\?.*?\?> | <!\[CDATA\[(.*?)\]\]>
    | <[^>"']*+ (?:"[^"]*+" [^>"']*+ | '[^']*+' [^>"']*+)*+ >""",
    re.DOTALL | re.VERBOSE,
)
WORD = re.compile(r"\S+")
COMPONENT = re.compile(r"(.*)-([1-9]\d*)", re.DOTALL)

AT, TEXT = f"<{ATTRIBUTE}", f"{SRC}text"
TEXT_ITSELF = iri(TEXT)


class Tag(NamedTuple):
    """A start tag: its name, the names and values of its attributes, and where it ends."""

    name: Span
    """Place of the name."""
    keys: dict[str, Span]
    """Places of the names of attributes."""
    attributes: dict[str, Span]
    """Places of the values of attributes, without quotes."""
    end: int
    """Offset behind the tag."""


class ElementPlaces:
    """The elements of a text: `index` numbers them, `starts` and `ends` are offsets in bytes.

    An end is where the second tag of an element begins, if it has two.
    """

    def __init__(
        self, text: str, offset: Offsets, index: dict[Term, int], starts: list[int], ends: list[int]
    ) -> None:
        self.text, self.offset = text, offset
        self.index, self.starts, self.ends = index, starts, ends
        self._tags: dict[int, Tag] = {}

    def tag(self, number: int) -> Tag:
        """Return the start tag of an element."""
        if number not in self._tags:
            self._tags[number] = self._tag(self.offset(self.starts[number]))
        return self._tags[number]

    def _tag(self, start: int) -> Tag:
        name = NAME.match(self.text, start + 1)
        at = name.end() if name else start + 1
        keys: dict[str, Span] = {}
        attributes: dict[str, Span] = {}
        own = Span(start + 1, at)
        while match := WRITTEN.match(self.text, at):
            keys.setdefault(match[1], Span(*match.span(1)))
            attributes.setdefault(match[1], Span(*match.span(2 if match[2] is not None else 3)))
            at = match.end()
        close = END.match(self.text, at)
        return Tag(own, keys, attributes, close.end() if close else at)

    def whole(self, number: int) -> Span:
        """Return an element from the first character of its first tag to the last of its last."""
        start, end = self.offset(self.starts[number]), self.tag(number).end
        if self.text[end - 2] != "/":
            end = self.text.find(">", self.offset(self.ends[number])) + 1
        return Span(start, end)

    def content(self, number: int) -> Span:
        """Return the span between the tags of an element."""
        start, end = self.tag(number).end, self.offset(self.ends[number])
        return Span(start, max(start, end))

    def runs(self, number: int) -> list[Span]:
        """Return the pieces of text of an element itself, without the space around them."""
        start, end = self.content(number)
        found, depth, at = [], 0, start
        for markup in MARKUP.finditer(self.text, start, end):
            if not depth:
                found.append(Span(at, markup.start()))
            at = markup.end()
            if markup[1] is not None:
                if not depth:
                    found.append(Span(*markup.span(1)))
            elif markup[0][1] not in "!?":
                depth += -1 if markup[0][1] == "/" else markup[0][-2] != "/"
        found.append(Span(at, end))
        return [span for each in found if (span := self.stripped(each)).end > span.start]

    def stripped(self, span: Span) -> Span:
        """Return *span* without the space at its ends."""
        raw = self.text[span.start : span.end]
        start = span.start + len(raw) - len(raw.lstrip(SPACE))
        return Span(start, max(start, span.end - len(raw) + len(raw.rstrip(SPACE))))

    def value_span(self, node: Term, predicate: Term, value: Term) -> Span:
        """Return the span of *value* of an element: in an attribute, in its text, or as a child."""
        child = self.index.get(value)
        if child is not None:
            return self.tag(child).name
        number = self.index[node]
        if predicate.startswith(AT):
            attributes = self.tag(number).attributes
            name = predicate[len(AT) : -1]
            span = attributes.get(name)
            if span is not None:
                exact = value[-1] == '"'
                return span if exact else self.stripped(span)
            part = COMPONENT.fullmatch(name)
            if part and part[1] in attributes:
                return self._component([attributes[part[1]]], int(part[2]))
        elif predicate.startswith(f"<{TEXT}"):
            runs = self.runs(number)
            if predicate != TEXT_ITSELF and runs:
                return self._component(runs, int(predicate[len(TEXT) + 2 : -1]))
            if runs:
                return Span(runs[0].start, runs[-1].end)
        return self.tag(number).name

    def _component(self, spans: list[Span], wanted: int) -> Span:
        """Return the word of the number *wanted* in *spans*, or all of them."""
        left = wanted
        for start, end in spans:
            for word in WORD.finditer(self.text, start, end):
                left -= 1
                if not left:
                    return Span(*word.span())
        return Span(spans[0].start, spans[-1].end)

    def node(self, number: int) -> NodeSpans:
        """Return an element, identified by the value of its `name` or else by its tag."""
        tag = self.tag(number)
        named = tag.attributes.get("name")
        return NodeSpans(
            self.whole(number), named if named and named.end > named.start else tag.name
        )


class TripleSpans(Mapping[Triple, Span]):
    """The spans of triples: those of elements by looking, all others as given.

    What is *derived* from another triple is where that one is.
    """

    def __init__(
        self,
        places: ElementPlaces,
        statements: list[Triple],
        given: dict[Triple, Span],
        derived: Mapping[Triple, Triple],
    ) -> None:
        self._places, self._statements, self._given = places, statements, given
        self._derived = derived

    @cached_property
    def _known(self) -> frozenset[Triple]:
        return frozenset(self._statements)

    def __getitem__(self, triple: Triple) -> Span:
        given = self._given.get(triple)
        if given is not None:
            return given
        if triple not in self._known:
            raise KeyError(triple)
        return self._places.value_span(*self._derived.get(triple, triple))

    def __contains__(self, triple: Any) -> bool:
        return triple in self._known

    def __iter__(self) -> Iterator[Triple]:
        return iter(self._statements)

    def __len__(self) -> int:
        return len(self._statements)


class ElementSpans(OrderedNodes):
    """The spans of elements, by looking, and of other nodes, as given."""

    def __init__(self, places: ElementPlaces, given: dict[Term, NodeSpans]) -> None:
        self._places, self._given = places, given

    def __getitem__(self, node: Term) -> NodeSpans:
        given = self._given.get(node)
        return given if given is not None else self._places.node(self._places.index[node])

    def __contains__(self, node: Any) -> bool:
        return node in self._given or node in self._places.index

    def __iter__(self) -> Iterator[Term]:
        yield from self._given
        yield from self._places.index

    def __len__(self) -> int:
        return len(self._given) + len(self._places.index)

    def around(self, offset: int) -> Iterator[tuple[Span, Term]]:
        """Yield the nodes that are described around *offset*, or end or begin there.

        Of elements around the one that *offset* is within, which are longer, there may be none.
        """
        given = ((spans.whole, node) for node, spans in self._given.items())
        yield from (each for each in given if each[0].start <= offset <= each[0].end)
        places = self._places
        nodes = list(places.index.items())
        after = bisect_right(nodes, offset, key=lambda each: places.offset(places.starts[each[1]]))
        for node, number in reversed(nodes[:after]):
            whole = places.whole(number)
            if offset <= whole.end and node not in self._given:
                yield whole, node
                if whole.start < offset < whole.end:
                    return

    def in_same_order(self, others: Mapping[Term, NodeSpans]) -> bool:
        """Tell whether *others* are the same nodes; elements are numbered as their tags begin."""
        return isinstance(others, ElementSpans) and tuple(self) == tuple(others)
