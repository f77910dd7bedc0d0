"""Reads texts: the stage before all others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.text import SourceText


def gathered(
    sources: Iterable[SourceText],
    failed: list[SourceError],
    settings: Settings,
    reading: Callable[[SourceText], Document],
) -> tuple[list[Document], list[Document]]:
    """What *sources* say to *reading*, without companions and with them, SRDF joined to its URDF.

    The errors of those that cannot be read go to *failed*, unless they are companions.
    """
    texts = list(sources)
    documents = list(_documents([each for each in texts if not each.companion], reading, failed))
    beside = _documents([each for each in texts if each.companion], reading, [])
    joined = _joined([*documents, *beside], settings)
    return joined[: len(documents)], joined


def _joined(documents: Sequence[Document], settings: Settings) -> list[Document]:
    """*documents*, in which each SRDF says which URDF it is about."""
    from kinlint.formats.srdf.pairing import join, may_be_srdf, partners  # noqa: PLC0415

    texts = [document.source for document in documents]
    if not any(map(may_be_srdf, texts)):
        return list(documents)
    return join(documents, partners(texts, settings.partner))


def _documents(
    sources: Iterable[SourceText],
    reading: Callable[[SourceText], Document],
    failed: list[SourceError],
) -> Iterator[Document]:
    """What *sources* say; the errors of those that cannot be read go to *failed*."""
    for source in sources:
        try:
            yield reading(source)
        except SourceError as error:
            failed.append(error)
