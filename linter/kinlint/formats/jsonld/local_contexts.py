"""Reads contexts from files of the project that models name by relative references.

Nothing is fetched: a reference leads to a file beside the one in which it stands, or nowhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.dependencies.included_text import included_text
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.json_text.json_values import Array, Key, Object, Text
from kinlint.formats.jsonld.context_resolver import (
    EntryResolver,
    Resolved,
    Resolver,
    absolute_iri,
)
from kinlint.formats.jsonld.pyld import JsonLdError
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText
from kinlint.uri_references import split_uri

LARGEST = 1 << 22
MOST_FILES = 100
"""Limits of context files: the bytes of one, and the number that one model may name."""

SELF = "it includes itself"
_FILE = "file:"
_REFERENCES = ("@context", "@import")


@dataclass
class LocalContexts:
    """Context files that a model names, directly or in other context files.

    The tokens of a context know their places: spans count through the text of the model and those
    of the files, one after the other, as `Document.pieces` does.
    """

    source: SourceText
    """Text of the model."""
    options: ReadOptions
    """Options of reading, with the contexts that need no file."""
    asked: bool = False
    """True once a file was named, be it there or not."""
    _pieces: list[tuple[int, SourceText]] = field(default_factory=list)
    _known: dict[str, Any] = field(default_factory=dict)
    _iris: dict[str, str | None] = field(default_factory=dict)
    _written: dict[int, str] = field(default_factory=dict)
    """References in the files as they are written, by their offsets."""

    @property
    def pieces(self) -> tuple[tuple[int, SourceText], ...]:
        """The offsets of the texts, that of the model first; empty if no file was named."""
        return ((0, self.source), *self._pieces) if self.asked else ()

    def iri(self, reference: str) -> str | None:
        """Return the IRI of the file that *reference*, written in the model, names.

        None if it names none: it is known by that name, or an address elsewhere.
        """
        if reference not in self._iris:
            self._iris[reference] = self._located(reference, absolute(self.source.name))
        return self._iris[reference]

    def named(self, entry: Any) -> str | None:
        """Return the IRI of the file that *entry* of a context names, if it names one."""
        return self.iri(str(entry)) if isinstance(entry, str) else None

    def written(self, entry: str) -> str:
        """Return the reference *entry* as it is written, be it absolute by now or not."""
        return self._written.get(getattr(entry, "start", -1), str(entry))

    def _located(self, reference: str, near: Path) -> str | None:
        if reference.startswith(_FILE):
            return reference
        names = (reference, absolute_iri(reference, self.options.base))
        if any(self.options.contexts.document(each) is not None for each in names):
            return None
        parts = split_uri(reference)
        if parts.scheme or parts.netloc or not parts.path:
            return None
        return absolute(near.parent / unquote(parts.path)).as_uri()

    def context(self, iri: str) -> Any:
        """Return the context in the file of *iri*, its references made absolute.

        Raises Unreadable, with the reason.
        """
        self.asked = True
        if iri not in self._known:
            try:
                self._known[iri] = self._read(Path(unquote(split_uri(iri).path)))
            except (Unreadable, SourceError, ValueError) as error:
                self._known[iri] = Unreadable(str(error))
        found = self._known[iri]
        if isinstance(found, Unreadable):
            raise found
        return found

    def _read(self, path: Path) -> Any:
        near = absolute(self.source.name)
        if len(self._pieces) >= MOST_FILES:
            raise Unreadable(f"the model names more than {MOST_FILES} context files")
        reach = ProjectReach(near, self.options.packages_of(self.source.name))
        text = included_text(path, reach, shown(path), self.options, LARGEST)
        last, before = self._pieces[-1] if self._pieces else (0, self.source)
        offset = last + len(before.text) + 1
        parse(text)  # Errors are at places of the file.
        # Space before a JSON text means nothing, but moves all that follows to its offset.
        moved = parse(SourceText(text.name, " " * offset + text.text)).value
        if not isinstance(moved, Object) or "@context" not in moved:
            raise Unreadable(f"'{text.name}' is not a context document, it has no '@context'")
        self._pieces.append((offset, text))
        self._absolute(moved, path)
        return moved["@context"]

    def _absolute(self, value: Object | Array, path: Path) -> None:
        """Make the references in *value*, of the file at *path*, absolute."""
        pending: list[tuple[Any, bool]] = [(value, False)]
        while pending:
            at, inside = pending.pop()
            entries = at.items() if isinstance(at, Mapping) else enumerate(at)
            for key, each in list(entries):
                referring = key in _REFERENCES if isinstance(key, Key) else inside
                if isinstance(each, (Object, Array)):
                    pending.append((each, referring and isinstance(each, Array)))
                elif referring and isinstance(each, Text):
                    iri = self._located(each, path)
                    if iri is not None:
                        self._written[each.start] = str(each)
                        at[key] = _moved(each, iri)


def _moved(token: Text, value: str) -> Text:
    """Return *value* at the place of *token*."""
    made = Text(value)
    made.start, made.end = token.start, token.end
    return made


class LocalResolver(EntryResolver):
    """Stands in for PyLD's ContextResolver: resolves files, and leaves the rest to *shared*."""

    def __init__(self, near: LocalContexts, shared: Resolver) -> None:
        self._near = near
        self._shared = shared

    def _entry(
        self, active: Mapping[str, Any], entry: Any, base: str, chain: tuple[str, ...]
    ) -> list[Resolved]:
        imported = entry.get("@import") if isinstance(entry, Mapping) else None
        named = entry if isinstance(entry, str) else imported
        iri = self._near.iri(named) if isinstance(named, str) else None
        if iri is None:
            return self._shared.resolve(active, entry, base, chain)
        rest = (
            {term: value for term, value in entry.items() if term != "@import"} if imported else {}
        )
        if iri in chain:
            raise JsonLdError(f"the context {iri} includes itself", "jsonld.SyntaxError")
        try:
            found = self._near.context(iri)
        except Unreadable as error:
            return [Resolved(rest, str(error))]
        if not imported:
            return self.resolve(active, found, base, (*chain, iri))
        if not isinstance(found, Mapping) or "@import" in found:
            raise JsonLdError(f"the imported {iri} is not a single context", "jsonld.SyntaxError")
        return [Resolved({**found, **rest})]
