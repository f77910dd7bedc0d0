"""The step of IRI expansion (JSON-LD 1.1 API, 5.2) by which a string became an IRI."""

from __future__ import annotations

import re
from typing import Any, TypeAlias

from kinlint.formats.jsonld.traced_values import Reach

Bases: TypeAlias = tuple[Any, str]
"""The base that relative IRIs are resolved against, if any, and the base of the document."""
_ABSOLUTE = re.compile(r"([A-Za-z][A-Za-z0-9+-.]*|_):[^\s]*$")


def reach_of(context: Any, value: str, iri: Any, bases: Bases, *, vocab: bool) -> Reach:
    """Return the step of IRI expansion (JSON-LD 1.1 API, 5.2) that gave *iri*."""
    if vocab and value in context["mappings"]:
        return Reach.TERM
    return _reach_of_compact(context, value) or _reach_of_relative(
        context, iri == value, bases, vocab=vocab
    )


def _reach_of_compact(context: Any, value: str) -> Reach | None:
    prefix, colon, suffix = value.partition(":")
    if not prefix or not colon:
        return None
    if prefix == "_":
        return Reach.BLANK
    if suffix.startswith("//"):
        return Reach.ABSOLUTE
    mapping = context["mappings"].get(prefix)
    if mapping and mapping["_prefix"]:
        return Reach.PREFIX
    return Reach.SCHEME if _ABSOLUTE.match(value) else None


def _reach_of_relative(
    context: Any,
    unchanged: bool,  # noqa: FBT001
    bases: Bases,
    *,
    vocab: bool,
) -> Reach:
    author, (base, document) = context.get("@base"), bases
    if vocab and "@vocab" in context:
        fell = document and str(context["@vocab"]).startswith(document)
        return Reach.DOCUMENT_BASE if fell else Reach.VOCAB
    if base is None or unchanged or ("@base" in context and author is None):
        return Reach.NOWHERE
    return Reach.AUTHORS_BASE if author and _ABSOLUTE.match(author) else Reach.DOCUMENT_BASE
