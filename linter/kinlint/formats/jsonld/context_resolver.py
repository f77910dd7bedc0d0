"""Finds the context documents that a file names: in the library, or not at all."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, cast

from kinlint.formats.jsonld.pyld import JsonLdError
from kinlint.formats.jsonld.pyld import resolve as resolve_iri
from kinlint.formats.options import ContextLibrary

# The context of a document whose "@context" is null, told apart from no document.
_NULL = object()


class Resolved:
    """A context that takes part; `missing` says why it is not the requested one.

    `meant` is the IRI of the one that it is instead, since that must have been meant.
    """

    def __init__(self, document: Any, missing: str | None = None, meant: str | None = None) -> None:
        self.document = document
        self.missing = missing
        self.meant = meant

    def get_processed(self, _active: Any) -> None:
        """Return None: PyLD's cache is keyed by an identifier that every scoped context renews."""

    def set_processed(self, _active: Any, _processed: Any) -> None:
        """Do nothing; see `get_processed`."""


class EntryResolver(ABC):
    """Resolves contexts entry by entry, as PyLD asks its ContextResolver to."""

    def resolve(
        self, active: Mapping[str, Any], context: Any, base: str, chain: tuple[str, ...] = ()
    ) -> list[Resolved]:
        """Return the contexts that *context* (an IRI, a context, null or an array) stands for."""
        if isinstance(context, Mapping) and "@context" in context:
            context = context["@context"]
        entries = context if isinstance(context, list) else [context]
        return [found for entry in entries for found in self._entry(active, entry, base, chain)]

    @abstractmethod
    def _entry(
        self, active: Mapping[str, Any], entry: Any, base: str, chain: tuple[str, ...]
    ) -> list[Resolved]:
        """Return the contexts that *entry* of an array stands for."""


class Resolver(EntryResolver):
    """Stands in for PyLD's ContextResolver.

    *strict* raises for an unknown context, as the specification demands; otherwise an
    empty context takes its place. Documents are never altered, so a library may be shared.
    """

    def __init__(self, library: ContextLibrary, *, strict: bool) -> None:
        self._library = library
        self._strict = strict
        self._remote: dict[str, list[Resolved]] = {}
        self._documents: dict[tuple[str, str], Any] = {}

    def _entry(
        self, active: Mapping[str, Any], entry: Any, base: str, chain: tuple[str, ...]
    ) -> list[Resolved]:
        if isinstance(entry, str):
            return self._document(active, str(entry), base, chain)
        if entry is None or entry is False:
            return [Resolved(None)]
        if not isinstance(entry, Mapping):
            raise _error("a context must be an object, an IRI or null", "invalid local context", "")
        return [self._with_import(active, entry, base)]

    def _with_import(self, active: Mapping[str, Any], context: Any, base: str) -> Resolved:
        # PyLD merges into the imported document itself, and so into later uses of it.
        imported = context.get("@import")
        if not isinstance(imported, str) or active.get("processingMode") == "json-ld-1.0":
            return Resolved(context)
        iri = absolute_iri(str(imported), base)
        found = self._fetched(iri, str(imported))
        if found is None:
            return self._unknown(iri, context)
        if not isinstance(found, Mapping):
            raise _error(
                f"the imported {iri} is not a single context", "invalid remote context", iri
            )
        if "@import" in found:
            raise _error(f"the imported {iri} imports a context", "invalid context entry", iri)
        return Resolved({**found, **_without_import(context)})

    def _document(
        self, active: Mapping[str, Any], written: str, base: str, chain: tuple[str, ...]
    ) -> list[Resolved]:
        iri = absolute_iri(written, base)
        if iri in chain:
            old = active.get("processingMode") == "json-ld-1.0"
            code = "recursive context inclusion" if old else "context overflow"
            raise _error(f"the context {iri} includes itself", code, iri)
        if iri not in self._remote:
            context = self._fetched(iri, written)
            if context is None:
                return self._misnamed(active, iri, chain) or [self._unknown(iri, {})]
            found = None if context is _NULL else context
            self._remote[iri] = self.resolve(active, found, iri, (*chain, iri))
        return self._remote[iri]

    def _misnamed(
        self, active: Mapping[str, Any], iri: str, chain: tuple[str, ...]
    ) -> list[Resolved]:
        """Return the contexts of the document that *iri* must have been meant to name."""
        meant = None if self._strict else self._library.resembling(iri)
        if meant is None or meant in chain:
            return []
        found = self._document(active, meant, meant, (*chain, iri))
        return [Resolved(each.document, each.missing, meant) for each in found]

    def _fetched(self, iri: str, written: str) -> Any:
        """Return the context in the document at *iri*, its references made absolute.

        Always the same.
        """
        if (iri, written) not in self._documents:
            self._documents[iri, written] = self._read(iri, written)
        return self._documents[iri, written]

    def _read(self, iri: str, written: str) -> Any:
        document = self._library.document(iri) or self._library.document(written)
        if document is None:
            return None
        if not isinstance(document, Mapping):
            raise _error(f"{iri} is not a JSON object", "invalid remote context", iri)
        context = document.get("@context", {})
        return _NULL if context is None else _located(context, iri)

    def _unknown(self, iri: str, context: Any) -> Resolved:
        if self._strict:
            raise _error(f"unknown context {iri}", "loading remote context failed", iri)
        why = "it is unknown, and contexts are not fetched"
        return Resolved(_without_import(context), why)


def _error(message: str, code: str, iri: str) -> JsonLdError:
    return JsonLdError(message, "jsonld.SyntaxError", {"url": iri}, code=code)


def _without_import(context: Mapping[str, Any]) -> dict[str, Any]:
    return {term: value for term, value in context.items() if term != "@import"}


def absolute_iri(iri: str, base: str) -> str:
    """Return *iri* against *base*; as it is where it cannot be resolved."""
    try:
        return cast("str", resolve_iri(iri, base))
    except ValueError:
        return iri


def _located(context: Any, iri: str) -> Any:
    """Return a copy of *context* whose references are absolute.

    Relative ones are relative to *iri*.
    """
    if isinstance(context, str):
        return absolute_iri(context, iri)
    if isinstance(context, list):
        return [_located(entry, iri) for entry in context]
    if not isinstance(context, Mapping):
        return context
    return {term: _located_definition(term, value, iri) for term, value in context.items()}


def _located_definition(term: str, value: Any, iri: str) -> Any:
    if term == "@import" and isinstance(value, str):
        return absolute_iri(value, iri)
    if isinstance(value, Mapping) and "@context" in value:
        return {**value, "@context": _located(value["@context"], iri)}
    return value
