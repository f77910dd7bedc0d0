"""The concise notation of shapes/contexts (see its README) as JSON-LD contexts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, TypeAlias

from kinlint.terms import XSD

Definition: TypeAlias = str | dict[str, Any]
Context: TypeAlias = dict[str, Any]

UNCOERCED = {"number", "text"}
"""Words for what a property takes where its context states no coercion."""

_WELL_KNOWN = {"xsd": XSD}


def expand_context(base: str, path: str, source: Mapping[str, Any]) -> Context:
    """The local context that *source*, the document at *path* under *base*, stands for.

    IRIs stay compact, with the document's own prefix, because that is how the published documents
    write them: a file that redefines the prefix changes the scoped contexts of both alike.
    """
    own, *others = source["prefixes"].split()
    namespace = source.get("namespace", f"{path}#")
    return {
        **({"@version": source["version"]} if "version" in source else {}),
        own: namespace if "://" in namespace else base + namespace,
        **{prefix: _WELL_KNOWN[prefix] for prefix in others},
        **source.get("others", {}),
        **_classes(own, source.get("classes", "")),
        **_properties(own, source.get("properties", {})),
    }


def _classes(prefix: str, source: str | Mapping[str, Mapping[str, str]]) -> Context:
    groups = {source: {}} if isinstance(source, str) else source
    return {
        name: _scoped(iri, _properties(prefix, properties))
        for names, properties in groups.items()
        for name, iri in (_member(prefix, name) for name in names.split())
    }


def _scoped(identifier: str, inner: Context) -> Definition:
    return {"@id": identifier, "@context": inner} if inner else identifier


def _properties(prefix: str, source: Mapping[str, str]) -> Context:
    lines = [(name, line) for names, line in source.items() for name in names.split()]
    return {name: _property(prefix, name, line) for name, line in lines}


def _property(prefix: str, name: str, line: str) -> Definition:
    head, _, members = line.partition("one of ")
    words = head.split()
    definition: Context = {"@id": f"{prefix}:{name}"}
    inner: Context = dict(_member(prefix, member) for member in members.split())
    while words:
        word = words.pop(0)
        if word == "as":
            definition["@id"] = _member(prefix, words.pop(0))[1]
        elif word == "from":
            inner["@base"] = words.pop(0)
        elif word in {"@list", "@set"}:
            definition["@container"] = word
        elif word not in UNCOERCED:
            definition["@type"] = word
    if inner:
        definition["@context"] = inner
    return definition


def _member(prefix: str, member: str) -> tuple[str, str]:
    """Return the term *member* with its IRI, which `TERM=NAME` and `TERM=PREFIX:NAME` tell."""
    if "://" in member:
        return re.split(r"[#/]", member)[-1], member
    term, _, name = member.rpartition("=")
    return term or name, name if ":" in name else f"{prefix}:{name}"
