"""Reads files by their formats, and writes changes into them; front ends load when needed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Protocol, TypeAlias

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.errors import SourceError
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.formats.recognition import objection, with_format
from kinlint.text import SourceText

__all__ = ["Editor", "decode", "editor", "read"]

FrontEnd: TypeAlias = Callable[[SourceText, ReadOptions], Document]


class Editor(Protocol):
    """Writes changes of one document into its text."""

    def edits(self, delta: Delta) -> Sequence[Edit]:
        """Return the smallest edits that apply *delta* to the text, ascending, without overlap.

        Raises Unsayable where it cannot.
        """
        ...


def read(source: SourceText, options: ReadOptions) -> Document:
    """Return what *source* states, read as its format.

    Raises SourceError when it cannot be read as what it claims to be, or claims nothing known.
    """
    source = with_format(source)
    if source.format is None:
        raise SourceError(source.name, f"not a robot model: {objection()}")
    front_end: FrontEnd = import_module(source.format.reader).read
    return front_end(source, options)


def editor(document: Document, options: ReadOptions) -> Editor:
    """Return what writes changes of *document* into its text.

    Raises NotExpressible if its format is only read.
    """
    if document.format.editor is None:
        raise NotExpressible(f"{document.format.title} files are only read")
    made: Editor = import_module(document.format.editor).Editor(document, options)
    return made
