"""Parses a file into the tree that xacro works on, and says where it is not well-formed."""

from __future__ import annotations

from xml.parsers import expat

from kinlint.formats.xacro.dom import Character, Comment, Element, Node, Raw, Text, VisitRecord
from kinlint.formats.xacro.origin import Origin
from kinlint.formats.xml.recovery import MARKS
from kinlint.formats.xml.tag_scanner import LOST
from kinlint.text import SourceText

SEPARATOR = "\x1f"
"""Separator of namespace and name; no XML has it."""
DEPTH = 256
PARTS = 3


class Malformed(Exception):
    """A text is no XML that xacro reads, from `offset` of `source` on."""

    def __init__(self, reason: str, source: SourceText, offset: int) -> None:
        super().__init__(reason)
        self.source = source
        self.offset = offset


class ParsedXacro:
    """The root element of a file, and what stands before and after it."""

    def __init__(self) -> None:
        self.before: list[Node] = []
        self.root: Element | None = None
        self.after: list[Node] = []


def parse(source: SourceText, watch: VisitRecord) -> ParsedXacro:
    """Return the tree of *source*.

    Raises Malformed where it is not well-formed XML with namespaces declared, has a document type,
    or is nested too deeply.
    """
    return _Parser(source, watch).parsed()


class _Parser:
    def __init__(self, source: SourceText, watch: VisitRecord) -> None:
        self._source = source
        self._watch = watch
        self._data = source.text.encode("utf-8", "surrogatepass")
        self._ascii = len(self._data) == len(source.text)
        self._byte = self._offset = 0
        self._open: list[Element] = []
        self._result = ParsedXacro()
        self._last: Element | Character | None = None
        self._pending: list[str] = []
        self._namespaces: dict[str, str] = {}
        self._begun = 0
        self._cdata = False
        parser = expat.ParserCreate("utf-8", SEPARATOR)
        parser.namespace_prefixes = True
        parser.buffer_text = False
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.CommentHandler = self._comment
        parser.ProcessingInstructionHandler = self._instruction
        parser.StartCdataSectionHandler = self._start_cdata
        parser.EndCdataSectionHandler = self._end_cdata
        parser.StartNamespaceDeclHandler = self._namespace
        parser.StartDoctypeDeclHandler = self._doctype
        self._parser = parser

    def parsed(self) -> ParsedXacro:
        if MARKS.match(self._source.text):
            raise Malformed("a second byte order mark", self._source, 0)
        try:
            self._parser.Parse(self._data, True)  # noqa: FBT003
        except expat.ExpatError as error:
            at = self._code_points(self._parser.ErrorByteIndex)
            cause = f"not well-formed: {expat.ErrorString(error.code)}"
            if lost := LOST.match(self._source.text):
                cause = f"no < before {lost['tag'] or 'the declaration'}"
            raise Malformed(cause, self._source, at) from None
        return self._result

    def _here(self) -> int:
        return self._code_points(self._parser.CurrentByteIndex)

    def _code_points(self, byte: int) -> int:
        """Return the offset in the text of *byte*; cheap where they are asked for in order."""
        if self._ascii:
            return byte
        if byte < self._byte:
            self._byte = self._offset = 0
        self._offset += len(self._data[self._byte : byte].decode("utf-8", "replace"))
        self._byte = byte
        return self._offset

    def _add(self, node: Node) -> None:
        if self._open:
            self._open[-1].insertBefore(node, None)
        elif self._result.root is None:
            self._result.before.append(node)
        else:
            self._result.after.append(node)

    def _start(self, name: str, values: dict[str, str]) -> None:
        at = self._here()
        self._flush(at)
        if len(self._open) >= DEPTH:
            raise Malformed(f"elements are nested more than {DEPTH} deep", self._source, at)
        attributes = {**self._namespaces, **{_qualified(key): v for key, v in values.items()}}
        self._namespaces = {}
        inside = _tag_end(self._source.text, at)
        origin = Origin(self._source, at, inside, inside, inside)
        element = Element(_qualified(name), attributes, origin, self._watch)
        if self._open:
            self._open[-1].insertBefore(element, None)
        else:
            self._result.root = element
        self._open.append(element)
        self._begun = inside

    def _end(self, name: str) -> None:
        del name
        at = self._here()
        self._flush(at)
        origin = self._open.pop().origin
        if at >= origin.inside and not self._source.text.startswith("/>", origin.inside - 2):
            origin.closing = at
            origin.end = self._source.text.find(">", at) + 1
        self._begun = origin.end

    def _characters(self, data: str) -> None:
        self._pending.append(data)

    def _flush(self, at: int) -> None:
        """Make one text of the characters up to *at*."""
        if self._pending:
            data = "".join(self._pending)
            self._pending = []
            kind = Raw if self._cdata else Text
            self._add(kind(data, Origin(self._source, self._begun, at), self._watch))
        self._begun = at

    def _start_cdata(self) -> None:
        self._flush(self._here())
        self._cdata = True

    def _end_cdata(self) -> None:
        at = self._here() + len("]]>")
        if not self._pending:
            self._pending.append("")
        self._flush(at)
        self._cdata = False

    def _comment(self, data: str) -> None:
        self._whole(Comment, data, "<!--", "-->")

    def _instruction(self, target: str, data: str) -> None:
        self._whole(Raw, f"{target} {data}", "<?", "?>")

    def _whole(self, kind: type[Character], data: str, opening: str, closing: str) -> None:
        at = self._here()
        self._flush(at)
        end = self._source.text.find(closing, at + len(opening)) + len(closing)
        self._add(kind(data, Origin(self._source, at, end), self._watch))
        self._begun = end

    def _namespace(self, prefix: str | None, uri: str | None) -> None:
        self._namespaces["xmlns:" + prefix if prefix else "xmlns"] = uri or ""

    def _doctype(self, *_: object) -> None:
        raise Malformed("it has a document type declaration", self._source, self._here())


def _qualified(name: str) -> str:
    """Return the name as it is written, of one that expat put together with its namespace."""
    parts = name.split(SEPARATOR)
    return f"{parts[2]}:{parts[1]}" if len(parts) == PARTS else parts[-1]


def _tag_end(text: str, start: int) -> int:
    """Return the end of the start tag at *start*: `>` may stand in the values of attributes."""
    at = start
    while True:
        end = text.find(">", at)
        if end < 0:
            return len(text)
        quote = _open_quote(text, start, end)
        if not quote:
            return end + 1
        at = text.find(quote, end)
        if at < 0:
            return len(text)
        start = at = at + 1


def _open_quote(text: str, start: int, end: int) -> str:
    """Return the quote that is open at *end*, if any, when none is at *start*."""
    at = start
    while True:
        found = [i for i in (text.find('"', at, end), text.find("'", at, end)) if i >= 0]
        if not found:
            return ""
        opening = min(found)
        closing = text.find(text[opening], opening + 1, end)
        if closing < 0:
            return text[opening]
        at = closing + 1
