"""Which front end reads a file; each is imported when it is needed."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Protocol, TypeAlias

from kinlint.document import Document
from kinlint.edits import Delta, Edit, Unsayable
from kinlint.errors import SourceError
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText

__all__ = ["EDITORS", "FORMATS", "Editor", "decode", "editor", "objection", "read", "recognise"]

FrontEnd: TypeAlias = Callable[[SourceText, ReadOptions], Document]


class Editor(Protocol):
    """Writes changes of one document into its text."""

    def edits(self, delta: Delta) -> Sequence[Edit]:
        """The smallest edits after which the text says *delta*, ascending, without overlap.

        Raises Unsayable where it cannot.
        """
        ...


FORMATS = {
    "jsonld": "kinlint.formats.jsonld.reader",
    "turtle": "kinlint.formats.turtle.reader",
    "ntriples": "kinlint.formats.nquads",
    "nquads": "kinlint.formats.nquads",
    "urdf": "kinlint.formats.xml.reader",
    "srdf": "kinlint.formats.xml.reader",
    "sdf": "kinlint.formats.sdf.reader",
    "xacro": "kinlint.formats.xacro.reader",
}
"""The modules whose `read(source, options)` is the front end of a format."""

EDITORS = {
    "jsonld": "kinlint.formats.jsonld.editing.editor",
    "turtle": "kinlint.formats.turtle.editing",
    "urdf": "kinlint.formats.xml.editing.editor",
    "srdf": "kinlint.formats.xml.editing.editor",
    "sdf": "kinlint.formats.xml.editing.editor",
    "xacro": "kinlint.formats.xml.editing.editor",
}
"""The modules whose `Editor(document, options)` writes changes into texts of a format."""

_SUFFIXES = {"jsonld": "jsonld", "ttl": "turtle", "nt": "ntriples", "nq": "nquads"}

KNOWN = (
    "JSON-LD (.jsonld, .json with an @context), Turtle (.ttl), N-Triples (.nt), N-Quads (.nq), "
    "URDF (.urdf, .xacro), SRDF (.srdf), SDF (.sdf, .world)"
)
"""The formats, for messages."""

_HEAD = 1024
_XML_SUFFIXES = (".urdf", ".srdf", ".sdf", ".world", ".xacro")

_TOKEN = re.compile(r'[ \t\r\n,:]*("(?:[^"\\]|\\.)*"|[\[\]{}]|[^\s",:\[\]{}]+)')
_CONTEXT = re.compile(r'[ \t\r\n]*:[ \t\r\n]*["\[{]')
_TURTLE = re.compile(r"(?im)^[ \t]*(?:@(?:prefix|base)[ \t]|(?:prefix|base)[ \t]+[\w.-]*:?[ \t]*<)")
_STATEMENT = re.compile(r"(?m)^[ \t]*(?:<[^<>\s]*>|_:\S+)[ \t]+<[^<>\s]*>[ \t]+[<\"_].*\.[ \t]*$")


def read(source: SourceText, options: ReadOptions) -> Document:
    """What *source* states.

    Raises SourceError when it cannot be read as what it claims to be, or claims nothing known.
    """
    form = options.format or recognise(source.name, source.text)
    if form is None:
        raise SourceError(source.name, f"not a robot model: {objection(source.text)}")
    front_end: FrontEnd = import_module(FORMATS[form]).read
    return front_end(source, options)


def editor(document: Document, options: ReadOptions) -> Editor:
    """What writes changes of *document* into its text.

    Raises Unsayable if its format is only read.
    """
    module = EDITORS.get(document.format)
    if module is None:
        raise Unsayable(f"{document.format or 'such'} files are only read")
    made: Editor = import_module(module).Editor(document, options)
    return made


def recognise(name: str, text: str) -> str | None:
    """The format of a file, by the end of its name or else by its content; None if unknown.

    JSON is JSON-LD if there is an `@context` at its top or in an element of a top-level array.
    """
    _, _, suffix = name.rpartition(".")
    known = _SUFFIXES.get(suffix.lower())
    if known is not None:
        return known
    head = text.lstrip()[:1]
    if head in ("{", "["):
        return "jsonld" if _has_context(text) else None
    if suffix.lower() == "json":
        return None
    if (found := _robot(name, text)) is not None:
        return found
    if _TURTLE.search(text):
        return "turtle"
    return "nquads" if _STATEMENT.search(text) else None


def objection(text: str) -> str:
    """What to say of *text* if it is in no format that is known."""
    if _begins_with_tag(text):
        from kinlint.formats.xml.recognition import unread  # noqa: PLC0415  few files are XML

        if (kind := unread(text)) is not None:
            return f"{kind} is not read yet; kinlint reads {KNOWN}"
    return f"kinlint reads {KNOWN}"


def _begins_with_tag(text: str) -> bool:
    return text[:_HEAD].lstrip()[:1] == "<"


def _robot(name: str, text: str) -> str | None:
    """The format of a robot in XML, by its root element or else by the end of its name."""
    if not _begins_with_tag(text) and not name.lower().endswith(_XML_SUFFIXES):
        return None
    from kinlint.formats.xml.recognition import sniff  # noqa: PLC0415  few files are XML

    return sniff(text, name)


def _has_context(text: str) -> bool:
    if '"@context"' not in text:
        return False
    depth, top = 0, 1
    for match in _TOKEN.finditer(text):
        found = match.group(1)
        if depth == 0 and found == "[":
            top = 2
        if found in ("{", "["):
            depth += 1
        elif found in ("}", "]"):
            depth -= 1
        elif depth == top and found == '"@context"' and _CONTEXT.match(text, match.end()):
            return True
    return False
