"""Options of reading: all inputs of a reader besides the text."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from kinlint.configuration.settings import Settings
from kinlint.contexts.context_library import RELEASES, Contexts, Extra
from kinlint.files.packages import Packages
from kinlint.files.pathname import real
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText
from kinlint.vocabulary import DOCUMENT_BASE


class ContextLibrary(Protocol):
    """The JSON-LD contexts that may be named; nothing else is ever loaded."""

    @property
    def release(self) -> str:
        """The release of the comp-rob2b contexts that is served."""
        ...

    @property
    def memory(self) -> dict[Hashable, Any]:
        """Results of readers that follow from these documents alone, which never change."""
        ...

    def document(self, iri: str) -> Mapping[str, Any] | None:
        """Return the document at *iri*, `{"@context": ...}`, or None if it is unknown."""
        ...

    def resembling(self, iri: str) -> str | None:
        """Return the IRI of the only document that the unknown *iri* can be a slip for."""
        ...

    def below(self, iri: str) -> Sequence[str]:
        """Return the names of known documents in the folder that the unknown *iri* is called as."""
        ...

    def at_release(self, release: str) -> ContextLibrary:
        """Return the same library serving another release."""
        ...


def _any_packages(_name: str) -> Packages:
    return Packages()


def _no_arguments(_name: str) -> Mapping[str, str]:
    return {}


@dataclass(frozen=True)
class ReadOptions:
    """Options of reading."""

    contexts: ContextLibrary = field(default_factory=Contexts.bundled)
    """Library of JSON-LD contexts."""
    releases: tuple[str, ...] = RELEASES
    """All releases to which a lost term is compared."""
    base: str = DOCUMENT_BASE
    """Base of relative IRIs; an IRI below the default was relative in the text."""
    memory: dict[Hashable, Any] = field(default_factory=dict, repr=False, compare=False)
    """Data that a front end keeps from one file for the next."""
    packages_of: Callable[[str], Packages] = field(default=_any_packages, compare=False)
    """Function that finds the packages for the source of a name."""
    xacro_arguments_of: Callable[[str], Mapping[str, str]] = field(
        default=_no_arguments, compare=False
    )
    """Function that finds the arguments for the source of a name."""
    xacro_variables_of: Callable[[str], Collection[str]] = field(
        default=_no_arguments, compare=False
    )
    """Function that finds the environment variables that the source of a name may see."""
    overlay: Mapping[Path, SourceText] = field(default_factory=dict, repr=False, compare=False)
    """Texts that replace the content of included files, by their paths with all links followed."""

    def overlaid_text(self, path: Path) -> SourceText | None:
        """Return the text that replaces the content of the file at *path*.

        None if there is none.
        """
        return self.overlay.get(real(path)) if self.overlay else None

    @classmethod
    def from_settings(cls, settings: Settings) -> ReadOptions:
        """Return the options that *settings* ask for.

        Raises UsageError or ConfigError where they name no release or no context.
        """
        extra: tuple[Extra, ...] = (*settings.context_directories, *settings.extra_contexts.items())
        return cls(
            Contexts.bundled(settings.contexts, extra),
            packages_of=_packages_of(settings),
            xacro_arguments_of=lambda name: dict(settings.for_file(name).xacro_args),
            xacro_variables_of=lambda name: settings.for_file(name).xacro_env,
        )


def _packages_of(settings: Settings) -> Callable[[str], Packages]:
    """Return a function that finds the packages of a source by its name, and caches them."""
    known: dict[tuple[Hashable, ...], Packages] = {}

    def packages(name: str) -> Packages:
        own = settings.for_file(name)
        key = own.packages, own.workspace
        if key not in known:
            known[key] = Packages(dict(own.packages), own.workspace, linted=settings.linted)
        return known[key]

    return packages
