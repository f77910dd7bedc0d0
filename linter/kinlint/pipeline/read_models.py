"""Reads texts: the stage before all others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.text import SourceText


def read_documents(
    sources: Iterable[SourceText],
    failed: list[SourceError],
    settings: Settings,
    reading: Callable[[SourceText], Document],
) -> tuple[list[Document], list[Document]]:
    """Read *sources* by *reading*: return the documents without companions, and with them.

    SRDF is joined to its URDF.

    The errors of those that cannot be read go to *failed*, unless they are companions.
    """
    texts = list(sources)
    documents = list(_documents([each for each in texts if not each.companion], reading, failed))
    beside = _documents([each for each in texts if each.companion], reading, [])
    every = join_companions([*documents, *beside], settings.partner)
    return every[: len(documents)], every


def _documents(
    sources: Iterable[SourceText],
    reading: Callable[[SourceText], Document],
    failed: list[SourceError],
) -> Iterator[Document]:
    """Yield the documents of *sources*; the errors of those that cannot be read go to *failed*."""
    for source in sources:
        try:
            yield reading(source)
        except SourceError as error:
            error.text = source.text
            failed.append(error)
