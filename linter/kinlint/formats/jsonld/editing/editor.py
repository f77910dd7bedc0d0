"""Turns changes of a graph into edits of the JSON-LD text that it was read from."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.editing.compaction import Compaction
from kinlint.formats.jsonld.editing.context_edits import declare_prefixes
from kinlint.formats.jsonld.editing.edit_plan import EditPlan
from kinlint.formats.jsonld.editing.list_edits import edit_lists
from kinlint.formats.jsonld.editing.node_edits import add_nodes, delete_nodes, rename_nodes
from kinlint.formats.jsonld.editing.property_edits import edit_properties
from kinlint.formats.jsonld.editing.source_layer_edits import edit_source_layer
from kinlint.formats.jsonld.editing.style import Style, style
from kinlint.formats.jsonld.editing.traced_expansion import ContextScope
from kinlint.formats.jsonld.editing.tracing import Trace
from kinlint.formats.jsonld.editing.triple_places import TriplePlaces
from kinlint.formats.jsonld.pyld import JsonLdError
from kinlint.formats.jsonld.reader import undisturbed
from kinlint.formats.options import ReadOptions


class Editor:
    """Edits one document; its text is looked into once, when first an edit is asked for."""

    def __init__(self, document: Document, options: ReadOptions) -> None:
        self._document = document
        self._options = options

    @cached_property
    def _places(self) -> TriplePlaces:
        return TriplePlaces(Trace(self._document.source, self._options))

    @cached_property
    def _style(self) -> Style:
        return style(self._document.source.text, self._places.tree.root)

    def edits(self, delta: Delta) -> list[Edit]:
        """Return the edits that apply *delta* to the text, ascending and apart.

        Raises Unsayable where the text has no place for something, or it is not clear which.
        """
        with undisturbed():
            try:
                return self._edits(delta)
            except JsonLdError as fault:
                raise NotExpressible("the contexts of the file do not allow for it") from fault

    def _edits(self, delta: Delta) -> list[Edit]:
        compaction = Compaction(self._places.trace.processor, self._prefixes)
        plan = EditPlan(self._document, self._places, self._style, compaction, delta)
        edit_source_layer(plan)
        rename_nodes(plan)
        delete_nodes(plan)
        edit_lists(plan)
        edit_properties(plan)
        add_nodes(plan)
        declare_prefixes(plan, compaction.needed)
        _check(plan)
        return plan.changes.edits()

    def _prefixes(self, scope: ContextScope) -> Mapping[str, str]:
        """Return the prefixes that could be declared for *scope* in the outermost object."""
        root = self._places.tree.root
        outermost = self._places.scope(root) if isinstance(root, Object) else None
        if outermost is None:
            return {}
        declared = outermost.types["mappings"].keys()
        return model_prefixes() if declared <= scope.keys["mappings"].keys() else {}


def _check(plan: EditPlan) -> None:
    """Refuse changes that would take away more than the delta, or leave some of it undone."""
    places = plan.places
    for triple in plan.removed:
        if triple not in plan.settled and not (places.spans(triple) and plan.goes(triple)):
            raise NotExpressible("the statement to delete cannot be deleted alone")
    if any(triple not in plan.stated for triple in plan.added):
        raise NotExpressible("the file has no place for the new statement")
    for cut in plan.changes.cut:
        for triple in places.within(cut):
            if triple in plan.removed or triple in plan.settled:
                continue
            if plan.goes(triple):
                raise NotExpressible("what would go with it says more")
