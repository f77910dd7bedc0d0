"""States what the tags of an XML file say: a triple for each element, attribute and component.

This is where the time of reading goes, hence the closures over local names and the plain tuples.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, TypeAlias

from kinlint.addresses import child_address, repeated_address, root_of
from kinlint.formats.xml.element_types import ANY, ElementType, Schema
from kinlint.formats.xml.schema import embedded
from kinlint.formats.xml.schema_diagnostics import Diagnostics
from kinlint.formats.xml.value_reading import SPACE, Form, value_reader
from kinlint.terms import XSD, Term, Triple, iri_value, literal
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, SRC

if TYPE_CHECKING:
    from xml.parsers.expat import XMLParserType

MOST_DEEP = 200
LONGEST_ADDRESS = 4_000
MOST_ELEMENTS = 1_000_000
MOST_ATTRIBUTES = 1_000

Frame: TypeAlias = tuple[str, Term, ElementType, int, dict[str, int]]
"""An open element: its address, its node, its type, its number, its first child of each tag."""

_ORDER = f"<{SRC}order>"
_TEXT = f"<{SRC}text>"
_WORDS = f"<{SRC}words>"
_STRINGS = value_reader(Form(("text",)))
UNSTATED = ElementType("", "", unstated=True)
"""Type of all elements of which nothing is stated."""


class TooLarge(Exception):
    """A file is larger or deeper than any robot, as is seen at `byte`."""

    def __init__(self, cause: str, byte: int) -> None:
        super().__init__(cause)
        self.byte = byte


class Elements:
    """Elements read so far.

    `index` numbers the elements; `starts` and `ends` are the offsets of their tags, in bytes.
    `closed` is the number of the element that ended last. `scopes` are the addresses of models and
    the like, with the tags of the elements that they know by name.
    """

    def __init__(
        self, document: Term, schema: Schema, roots: Mapping[str, ElementType] | None = None
    ) -> None:
        self.schema = schema
        self.remarks = Diagnostics(schema)
        self.statements: list[Triple] = []
        self.index: dict[Term, int] = {}
        self.starts: list[int] = []
        self.ends: list[int] = []
        self.closed = -1
        self.scopes: list[tuple[str, tuple[str, ...]]] = []
        known = dict(schema.roots if roots is None else roots)
        above = ElementType("", "", children=known, once=frozenset(known))
        self.frames: list[Frame] = [(iri_value(root_of(document)), document, above, -1, {})]
        self._texts: dict[int, list[str]] = {}

    def listen(self, parser: XMLParserType, stands_for: Mapping[int, str] | None = None) -> None:
        """Have *parser* tell what it reads, characters put back that others *stand for*."""
        pending: list[str] = []
        start = self._start_handler(parser, pending)

        def characters(text: str) -> None:
            if not text.isspace():
                pending.append(text)

        parser.buffer_text = True
        parser.StartElementHandler = start
        parser.EndElementHandler = self._end_handler(parser, pending)
        parser.CharacterDataHandler = characters
        if stands_for:

            def start_restored(tag: str, attributes: dict[str, str]) -> None:
                start(tag, {key: said.translate(stands_for) for key, said in attributes.items()})

            def characters_restored(text: str) -> None:
                characters(text.translate(stands_for))

            parser.StartElementHandler = start_restored
            parser.CharacterDataHandler = characters_restored

    def _start_handler(  # noqa: C901, PLR0915  one call for each element, not five
        self, parser: XMLParserType, pending: list[str]
    ) -> Callable[[str, dict[str, str]], None]:
        frames, index, starts, ends = self.frames, self.index, self.starts, self.ends
        add, remarks, texts = self.statements.append, self.remarks, self._texts
        counts = dict[str, int]()
        namespace, naming, unset = self.schema.namespace, self.schema.names, self.schema.unset
        stepped = self.schema.kinds if self.schema.nested else frozenset[str]()

        def start(tag: str, attributes: dict[str, str]) -> None:  # noqa: C901, PLR0912, PLR0915
            above, parent, outer, holder, first = frames[-1]
            if pending:
                texts.setdefault(holder, []).extend(pending)
                pending.clear()

            type_ = outer.children.get(tag)
            if outer.unstated or (type_ is not None and type_.unstated):
                frames.append((above, parent, UNSTATED, holder, first))
                if len(frames) > MOST_DEEP:
                    raise TooLarge(_excess(len(frames), above), parser.CurrentByteIndex)
                return
            number = len(starts)
            starts.append(parser.CurrentByteIndex)
            ends.append(-1)
            if type_ is not None:
                predicate = type_.predicate
            else:
                foreign = outer.open or ":" in tag
                type_, predicate = ANY, f"<{EXTENSION if foreign else namespace}{tag}>"
                if tag in outer.embeds:
                    type_ = embedded(outer.embeds[tag])

            name = attributes.get(naming)
            address = child_address(above, tag, name) if holder >= 0 else above
            if not name and tag in stepped:
                address += "/"
            order = counts[address] = counts.get(address, 0) + 1
            if order > 1:
                address = repeated_address(address, order)
            node = f"<{address}>"
            index[node] = number
            add((parent, predicate, node))
            if order > 1 and not name:
                add((node, _ORDER, f'"{order}"^^<{XSD}integer>'))

            if len(attributes) > MOST_ATTRIBUTES:
                raise TooLarge(f"more than {MOST_ATTRIBUTES} attributes", starts[number])
            if attributes:
                slots = type_.attributes
                for key, written in attributes.items():
                    slot = slots.get(key)
                    if slot is None:
                        self._unlisted(number, node, type_, key, attributes)
                        continue
                    value = slot.reading[written]
                    if value.__class__ is str:
                        add((node, slot.predicate, value))
                    elif value is None:
                        if unset and not written.strip():
                            continue
                        add((node, slot.predicate, literal(written)))
                        remarks.note_malformed_value(number, tag, key, written, slot)
                    else:
                        components = slot.components(len(value))
                        for component, each in zip(components, value, strict=True):
                            add((node, component, each))

            if type_.scope:
                self.scopes.append((address, type_.scope))
            before = first.setdefault(tag, number)
            if before != number and tag in outer.once:
                remarks.note_repeated(number, holder, tag, before)
            if type_ is ANY:
                remarks.note_unlisted_element(number, outer, tag, first, attributes)
            elif type_.checked or not number:
                dated = outer.lifetime != type_.lifetime
                remarks.check_element(number, type_, attributes, self._display_only, dated=dated)
            frames.append((address, node, type_, number, {}))
            if len(frames) > MOST_DEEP or len(address) > LONGEST_ADDRESS or number >= MOST_ELEMENTS:
                raise TooLarge(_excess(len(frames), address), starts[number])

        return start

    def _end_handler(self, parser: XMLParserType, pending: list[str]) -> Callable[[str], None]:
        frames, ends, texts, remarks = self.frames, self.ends, self._texts, self.remarks
        add = self.statements.append
        scopes = remarks.scopes

        def end(tag: str) -> None:
            _, node, type_, number, first = frames.pop()
            if type_ is UNSTATED:
                pending.clear()
                return
            ends[number] = parser.CurrentByteIndex
            if type_.data:
                words = len("".join((*texts.pop(number, ()), *pending)).split())
                pending.clear()
                add((node, _WORDS, f'"{words}"^^<{XSD}integer>'))
            elif pending or (texts and number in texts):
                written = "".join((*texts.pop(number, ()), *pending)).strip(SPACE)
                pending.clear()
                self._text(number, node, type_, tag, written)
            if type_.requires or type_.expects:
                self._missing(number, type_, tag, first)
            if scopes and number in scopes:
                remarks.leave_element(number)
            self.closed = number

        return end

    def _missing(self, number: int, type_: ElementType, tag: str, first: Mapping[str, int]) -> None:
        """Note the children that an element of *type_* lacks; *first* are the tags that it has."""
        for each in (*type_.requires, *type_.expects):
            if each not in first:
                optional = each in type_.expects
                self.remarks.note(
                    "MissingElement", number, None,
                    tag=each, parentTag=tag, displayOnly=self._display_only(type_) or None,
                    optional=optional or None, default=type_.assumed.get(each),
                )  # fmt: skip

    def _display_only(self, type_: ElementType) -> bool:
        """Tell whether an element of *type_* below the open ones only matters for display."""
        return type_.display_only or any(frame[2].display_only for frame in self.frames)

    def _unlisted(
        self, number: int, node: Term, type_: ElementType, key: str, attributes: Mapping[str, str]
    ) -> None:
        """State the one of *attributes* that is called *key*, which its element does not list."""
        if not self.remarks.check_unlisted(number, type_, key, attributes):
            return
        written = attributes[key]
        value = _STRINGS[written]
        said = value if isinstance(value, str) else literal(written)
        self.statements.append((node, f"<{ATTRIBUTE}{key}>", said))
        if value is None:
            self.remarks.note_unexpanded(number, key, written)

    def _text(self, number: int, node: Term, type_: ElementType, tag: str, written: str) -> None:
        """State the text of an element."""
        add, slot = self.statements.append, type_.content
        if slot is None:
            value = _STRINGS[written]
            if type_.open:
                add((node, _TEXT, value if isinstance(value, str) else literal(written)))
            if value is None:
                self.remarks.note_unexpanded(number, "", written)
            elif not type_.open:
                self.remarks.note("StrayText", number, "", written=written, tag=tag)
            return
        value = slot.reading[written]
        if value is None:
            add((node, _TEXT, literal(written)))
            self.remarks.note_malformed_value(number, tag, "", written, slot)
        elif isinstance(value, str):
            add((node, _TEXT, value))
            if type_.choices or type_.usual:
                self.remarks.check_word(number, type_, "", written)
        else:
            components = slot.components(len(value))
            self.statements.extend((node, c, v) for c, v in zip(components, value, strict=True))


def _excess(depth: int, address: str) -> str:
    if depth > MOST_DEEP:
        return f"elements are nested more than {MOST_DEEP} deep"
    if len(address) > LONGEST_ADDRESS:
        return f"the names on the way to this element have over {LONGEST_ADDRESS} characters"
    return f"more than {MOST_ELEMENTS} elements"
