"""A composed model as text."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from kinlint.contexts.context_library import Contexts
from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.conversion.composition import Composition
from kinlint.conversion.expanded_nodes import Node
from kinlint.conversion.json_layout import format_json
from kinlint.conversion.published import term_order
from kinlint.conversion.rdf_triples import Triples

LAST = (9, 0)


def jsonld(model: Composition) -> str:
    """Write *model* as JSON-LD under the published contexts, in the order people would."""
    from kinlint.formats.jsonld.writer import framed  # noqa: PLC0415  PyLD is slow to import

    context: list[str | Mapping[str, str]] = [*model.contexts, dict(model.namespaces)]
    compact = {node["@id"]: node for node in framed(model.nodes, context, Contexts.bundled())}
    graph = [_arranged(compact[_compact(node["@id"], model.namespaces)]) for node in model.nodes]
    named = {"@context": context, "@id": _compact(model.name, model.namespaces), "@graph": graph}
    return format_json(named) + "\n"


def _compact(iri: str, namespaces: Mapping[str, str]) -> str:
    """Return *iri* as PyLD writes it: with the prefix of the longest matching namespace."""
    found = [each for each in namespaces.items() if iri.startswith(each[1])]
    if not found:
        return iri
    prefix, space = max(found, key=lambda each: len(each[1]))
    return f"{prefix}:{iri[len(space) :]}"


def _arranged(node: Node) -> Node:
    """The types and the keys of *node* in the order of the contexts."""
    ranks = term_order()

    def rank(name: str) -> tuple[int, int]:
        return ranks.get(name, LAST)

    types = node["@type"]
    kinds = sorted(types, key=lambda name: rank(name)[1]) if isinstance(types, list) else types
    rest = sorted((key for key in node if key[0] != "@"), key=rank)
    return {"@id": node["@id"], "@type": kinds, **{key: node[key] for key in rest}}


def turtle(model: Composition) -> str:
    """Write *model* as Turtle."""
    return _serialized(model, "TURTLE", {**model_prefixes(), **model.namespaces})


def ntriples(model: Composition) -> str:
    """Write *model* as N-Triples."""
    return _serialized(model, "N_TRIPLES", {})


WRITERS: Mapping[str, Callable[[Composition], str]] = {
    "jsonld": jsonld,
    "turtle": turtle,
    "ntriples": ntriples,
}
"""Writers by format."""


def _serialized(model: Composition, form: str, prefixes: Mapping[str, str]) -> str:
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    triples = list(Triples(model))
    written = "".join(map(str, triples))
    used = {name: space for name, space in prefixes.items() if f"<{space}" in written}
    text = ox.serialize(triples, format=getattr(ox.RdfFormat, form), prefixes=used or None)
    lines = (text or b"").decode().splitlines(keepends=True)
    return "".join([*sorted(lines[: len(used)]), *lines[len(used) :]])
