"""What reading a file may depend on besides its text."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from kinlint.configuration.settings import Settings
from kinlint.contexts.library import RELEASES, Contexts, Extra
from kinlint.vocabulary import DOCUMENT_BASE


class ContextLibrary(Protocol):
    """The JSON-LD contexts that may be named; nothing else is ever loaded."""

    @property
    def release(self) -> str:
        """The release of the comp-rob2b contexts that is served."""
        ...

    def document(self, iri: str) -> Mapping[str, Any] | None:
        """The document at *iri*, `{"@context": ...}`, or None if nobody knows it."""
        ...

    def at_release(self, release: str) -> ContextLibrary:
        """The same library serving another release."""
        ...


@dataclass(frozen=True)
class ReadOptions:
    """How to read.

    `releases` are all releases to which a lost term is compared. `base` is what relative IRIs
    are resolved against; an IRI below the default was relative where it was written. `format`
    overrides what the file's name and content say. `memory` is what a front end keeps from one
    file for the next.
    """

    contexts: ContextLibrary = field(default_factory=Contexts.bundled)
    releases: tuple[str, ...] = RELEASES
    base: str = DOCUMENT_BASE
    format: str | None = None
    memory: dict[Hashable, Any] = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def of(cls, settings: Settings) -> ReadOptions:
        """How *settings* want files to be read.

        Raises UsageError or ConfigError where they name no release or no context.
        """
        extra: tuple[Extra, ...] = (*settings.context_directories, *settings.extra_contexts.items())
        return cls(Contexts.bundled(settings.contexts, extra))
