"""Trees from graphs, by PyLD's framing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from kinlint.formats.jsonld.pyld import JsonLdProcessor
from kinlint.terms import XSD, Term, Triple, is_literal, literal_datatype, literal_value

NATIVE: Mapping[str, Callable[[str], object]] = {
    f"{XSD}double": float,
    f"{XSD}integer": int,
    f"{XSD}boolean": "true".__eq__,
}
"""Datatypes whose values JSON has; doubles keep their last digit."""


def tree(triples: Iterable[Triple], frame: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the tree that *frame* makes of *triples*, which have neither lists nor types.

    PyLD reads N-Quads in quadratic time, so it is given nodes.
    """
    nodes: dict[Term, dict[str, Any]] = {}
    for s, p, o in triples:
        node = nodes.setdefault(s, {"@id": _identity(s)})
        node.setdefault(p[1:-1], []).append(_value(o))
    options = {"base": "", "documentLoader": None, "omitGraph": True, "embed": "@always"}
    found: Mapping[str, Any] = JsonLdProcessor().frame(list(nodes.values()), frame, options)
    return found


def _identity(node: Term) -> str:
    return node[1:-1] if node[0] == "<" else node


def _value(term: Term) -> Mapping[str, Any]:
    if not is_literal(term):
        return {"@id": _identity(term)}
    native = NATIVE.get(literal_datatype(term))
    return {"@value": native(literal_value(term)) if native else literal_value(term)}
