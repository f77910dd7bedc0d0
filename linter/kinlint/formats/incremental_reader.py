"""Reads a file again and again while it is being written."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinlint.document import Document
from kinlint.formats.jsonld.format import JSONLD
from kinlint.formats.options import ReadOptions
from kinlint.formats.recognition import with_format
from kinlint.formats.registry import read
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.formats.jsonld.incremental.divided_reader import Reading


LARGE = 100_000
"""Number of characters from which it is worth taking a text apart before it has changed."""


class IncrementalReader:
    """Reads the texts that one file has, one after the other.

    What it reads is what `registry.read` does, but sooner, if little has changed since a text
    that could be read. For that it takes texts apart: the first one if it is large, else from the
    second one on. If not *divided*, the first text is never taken apart. If *lasting*, blank nodes
    keep their labels, so that the documents differ less, and from what is read at once.
    """

    def __init__(self, *, divided: bool = True, lasting: bool = False) -> None:
        self._dividing = divided
        self._lasting = lasting
        self._last: Document | None = None
        self._options: ReadOptions | None = None
        self._parted: Reading | None = None
        """The last reading that others can be made of, and not always that of `_last`."""

    def read(self, source: SourceText, options: ReadOptions) -> Document:
        """Return the document of *source*.

        That is the same document if nothing has changed and it depends on *source* alone. Raises
        SourceError as `registry.read` does; the next text is compared with the last one that could
        be read.
        """
        last = self._last
        unchanged = last is not None and (source, options) == (last.source, self._options)
        if last is not None and unchanged and not (last.format.includes or last.pieces):
            return last
        source = with_format(source)
        repeated = self._last is not None or len(source.text) >= LARGE
        divisible = self._dividing and repeated and source.format == JSONLD
        now = self._divided(source, options) if divisible else None
        self._dividing = True
        document = now.document if now is not None else read(source, options)
        self._last, self._options = document, options
        self._parted = now or self._parted
        return document

    def _divided(self, source: SourceText, options: ReadOptions) -> Reading | None:
        """Return *source*, read part by part; None if it has to be read at once."""
        from kinlint.formats.jsonld.incremental import divided_reader  # noqa: PLC0415  needs PyLD

        if self._parted is not None:
            try:
                return divided_reader.reread(self._parted, source, options, lasting=self._lasting)
            except divided_reader.Indivisible:
                pass
        try:
            return divided_reader.read_divided(source, options)
        except divided_reader.Indivisible:
            return None
