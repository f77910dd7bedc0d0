"""The page of `--profile`: which symptoms of the anti-patterns come with the format of a file."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.format_profile import lines
from kinlint.formats import registry
from kinlint.formats.options import ReadOptions
from kinlint.project.discovery import Found
from kinlint.project.reading import read_models


def page(found: Found, settings: Settings, errors: list[SourceError]) -> Iterator[str]:
    """The lines of the page; why files cannot be read goes to *errors*."""
    sources, failed = read_models(found.inputs, settings)
    errors += [*found.errors, *failed]
    options = ReadOptions.from_settings(settings)

    def documents() -> Iterator[Document]:
        for source in sources:
            try:
                yield registry.read(source, options)
            except SourceError as error:
                errors.append(error)

    yield from (f"{line}\n" for line in lines(documents()))
