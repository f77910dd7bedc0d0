"""Reads the files of one robot, each SRDF joined to the URDF it speaks of."""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.formats.dependencies.companions import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText


def documents(sources: Sequence[SourceText], settings: Settings) -> list[Document]:
    """Read *sources*, each SRDF joined to its URDF.

    Raises `SourceError` for the first that cannot be read.
    """
    options = ReadOptions.from_settings(settings)
    return join_companions([read(source, options) for source in sources], settings.partner)
