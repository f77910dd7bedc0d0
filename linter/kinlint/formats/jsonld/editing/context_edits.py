"""Contexts and prefixes that a file comes to have."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinlint.edits import NotExpressible
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.container_edits import NewChild
from kinlint.formats.jsonld.editing.edit_plan import EditPlan


def add_context(plan: EditPlan, iri: str) -> None:
    """Add the context *iri* to the outermost object; its terms yield to the file's own."""
    root = _root(plan)
    token = root.key("@context")
    if token is None:
        plan.changes.insert(root, NewChild(iri, "@context", -1))
        return
    context = root[token]
    if isinstance(context, Array):
        named = [number for number, entry in enumerate(context) if isinstance(entry, str)]
        plan.changes.insert(context, NewChild(iri, None, max(named, default=-1)))
    elif context is None:
        plan.changes.replace(token.value_span, iri)
    else:
        plan.changes.wrap(token.value_span, iri, first=isinstance(context, Object))


def declare_prefixes(plan: EditPlan, prefixes: Mapping[str, str]) -> None:
    """Declare *prefixes* in the outermost context of the file."""
    if not prefixes:
        return
    root = _root(plan)
    token = root.key("@context")
    if token is None:
        plan.changes.insert(root, NewChild(dict(prefixes), "@context", -1))
        return
    context: Any = root[token]
    entries = context if isinstance(context, Array) else [context]
    inline = next((entry for entry in reversed(entries) if isinstance(entry, Object)), None)
    if inline is not None:
        for prefix, namespace in prefixes.items():
            plan.changes.insert(inline, NewChild(namespace, prefix, len(inline) - 1))
    elif isinstance(context, Array):
        plan.add(context, [dict(prefixes)])
    else:
        plan.changes.wrap(token.value_span, dict(prefixes))


def _root(plan: EditPlan) -> Object:
    root = plan.places.tree.root
    if isinstance(root, Array) and len(root) == 1:
        root = root[0]
    if not isinstance(root, Object):
        raise NotExpressible("the file has no outermost object to hold a context")
    return root
