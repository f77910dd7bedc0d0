"""States what a text layer says: a triple for each prim, property, value and item of a list."""

from __future__ import annotations

from collections.abc import Iterable

from kinlint.addresses import child_address, repeated_address, root_of
from kinlint.document import NodeSpans
from kinlint.errors import SourceError
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.usd.prim_paths import absolute_path, prim_address
from kinlint.formats.usd.usda_syntax import Field, Prim, Property, Value, Variant
from kinlint.formats.usd.value_forms import (
    Flaw,
    flaws,
    metadata_flaws,
    relationship_flaws,
    repeated_items,
)
from kinlint.formats.usd.value_terms import terms
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE, REFERENCE
from kinlint.vocabulary import USD as NAMESPACE

ARCS = {"references": "reference", "payload": "payload", "payloads": "payload"}
"""Tags of the items of metadata that lead to prims of other layers, or of the same."""
PATHS = {"inherits": "inherit", "specializes": "specialize"}
"""Tags of the items of metadata that lead to prims of the same stage."""
NAMES = {"apiSchemas": "apiSchema", "variantSets": "variantSetName"}
"""Tags of the items of metadata that are names."""
SUBLAYERS = "subLayers"
SELECTIONS = "variants"
LONGEST_ADDRESS = 8_000

_AT = ATTRIBUTE
_TRUE = literal("true", f"{XSD}boolean")


class LayerStatements:
    """Statements of the layer *root*, the text of *source*, in the graph *document*."""

    def __init__(self, source: SourceText, document: Term, layer: SourceLayer) -> None:
        self.source, self.document, self.layer = source, document, layer
        self.triples: dict[Triple, Span] = {}
        """Statements in the order of the text, with the places of their values."""
        self.nodes: dict[Term, NodeSpans] = {}
        """Places of the elements."""
        self.node_of: dict[Prim, Term] = {}
        """Node of each prim, variant, and the layer."""
        self.item_of: dict[Value, Term] = {}
        """Node of each item of a list."""
        self._counts: dict[str, int] = {}

    def state(self, root: Prim) -> None:
        """State all that the layer *root* says."""
        node = root_of(self.document)
        head = root.name_span
        self.nodes[node] = NodeSpans(root.span, head)
        self.node_of[root] = node
        self.triples[self.document, iri(f"{NAMESPACE}stage"), node] = head
        self._metadata(node, root.metadata, "/")
        pending = [(each, node, "/") for each in reversed(root.children)]
        while pending:
            prim, above, path = pending.pop()
            pending += reversed([*self._prim(prim, above, path)])

    def _prim(self, prim: Prim, above: Term, around: str) -> Iterable[tuple[Prim, Term, str]]:
        """State *prim* in the element *above*, and return what is in it with node and path."""
        node = self._element(above, "prim", prim.name, NodeSpans(prim.span, prim.name_span))
        path = f"{around.rstrip('/')}/{prim.name}"
        self.triples[node, iri(f"{_AT}specifier"), literal(prim.specifier)] = _head(prim)
        if prim.type_span is not None:
            self.triples[node, iri(f"{_AT}typeName"), literal(prim.type_name)] = prim.type_span
        return self._content(prim, node, path)

    def _content(self, prim: Prim, node: Term, path: str) -> list[tuple[Prim, Term, str]]:
        self.node_of[prim] = node
        self._metadata(node, prim.metadata, path)
        last: dict[tuple[str, str], Property] = {}
        for each in prim.properties:
            last[each.name, each.suffix] = each
        for each in prim.properties:
            self._property(each, node, path, counts=last[each.name, each.suffix] is each)
        found = [(each, node, path) for each in prim.children]
        for given in prim.variant_sets:
            found += self._variants(given, node, path)
        return found

    def _variants(self, given: Variant, above: Term, path: str) -> list[tuple[Prim, Term, str]]:
        """State a set of variants, whose content is about the prim at *path*."""
        spans = NodeSpans(given.span, given.name_span)
        holder = self._element(above, "variantSet", given.name, spans)
        found: list[tuple[Prim, Term, str]] = []
        for each in given.variants:
            node = self._element(holder, "variant", each.name, NodeSpans(each.span, each.name_span))
            found += self._content(each, node, path)
        return found

    def _element(self, above: Term, tag: str, name: str, spans: NodeSpans) -> Term:
        """State an element in *above*, and return its node."""
        address = child_address(above[1:-1], tag, name)
        if len(address) > LONGEST_ADDRESS:
            place = self.source.position(spans.best.start)
            cause = f"the names on the way to this element have over {LONGEST_ADDRESS} characters"
            raise SourceError(self.source.name, cause, *place)
        order = self._counts[address] = self._counts.get(address, 0) + 1
        if order > 1:
            address = repeated_address(address, order)
        node = iri(address)
        self.nodes[node] = spans
        self.triples[above, iri(f"{NAMESPACE}{tag}"), node] = spans.best
        if name:
            self.triples[node, iri(f"{_AT}name"), literal(name)] = self._unquoted(spans.best)
        if order > 1:
            self.triples[node, src("order"), literal(str(order), f"{XSD}integer")] = spans.best
        return node

    def _unquoted(self, span: Span) -> Span:
        """Return *span* without the quotes that stand in it."""
        quoted = self.source.text[span.start] in "\"'"
        return Span(span.start + 1, span.end - 1) if quoted else span

    def _metadata(self, node: Term, fields: Iterable[Field], path: str) -> None:
        self._repeated(node, fields)
        for each in fields:
            self._flaws(node, each.name, metadata_flaws(each.name, each.value, path))
            if each.name in ARCS:
                self._arcs(node, each, ARCS[each.name], path)
            elif each.name in PATHS:
                self._targets(node, each.value, each.operation, PATHS[each.name], path)
            elif each.name in NAMES:
                self._names(node, each, NAMES[each.name])
            elif each.name == SUBLAYERS:
                for item in listed_values(each.value):
                    self._item(node, "subLayer", item, "", asset=item.text)
            elif each.name == SELECTIONS:
                for entry in each.value.fields:
                    self._item(
                        node, "selection", entry.value, "", set=entry.name, variant=entry.value.text
                    )
            elif not each.operation:
                self._values(node, each.name, each.value, "")

    def _repeated(self, node: Term, fields: Iterable[Field]) -> None:
        """State the metadata that replace what is said before of the same name."""
        said: dict[str, set[str]] = {}
        for each in fields:
            before = said.setdefault(each.name, set())
            if before and (not each.operation or before & {"", each.operation}):
                about = ("node", node), ("field", literal(each.name))
                self.layer.add_node("RepeatedField", each.name_span, *about)
            before.add(each.operation)

    def _names(self, node: Term, given: Field, tag: str) -> None:
        items = listed_values(given.value)
        for item in items:
            self._item(node, tag, item, given.operation, value=item.text)
        if not items:
            self._item(node, tag, given.value, given.operation)

    def _arcs(self, node: Term, given: Field, tag: str, path: str) -> None:
        items = listed_values(given.value)
        for item in items:
            target = item if item.kind == "path" else next(iter(item.items), None)
            asset = {"asset": item.text} if item.kind == "asset" else {"path": item.text}
            element = self._item(node, tag, item, given.operation, **asset)
            if item.kind == "asset" and target is not None and target.text:
                path_ = literal(target.text)
                self.triples[element, iri(f"{_AT}path"), path_] = target.content
            if item.kind == "path":
                self._lead(element, absolute_path(item.text, path), item.content)
        if not items:
            self._item(node, tag, given.value, given.operation)

    def _targets(self, node: Term, value: Value, operation: str, tag: str, path: str) -> None:
        """State each path in *value* as an element with *tag* of *node*, which is at *path*."""
        items = listed_values(value)
        for item in items:
            element = self._item(node, tag, item, operation, path=item.text)
            self._lead(element, absolute_path(item.text, path), item.content)
        if not items:
            self._item(node, tag, value, operation)

    def _lead(self, element: Term, path: str, span: Span) -> None:
        """State that *element* leads to what is at *path*; nothing for a path out of the root."""
        if path and len(path) <= LONGEST_ADDRESS:
            self.triples[element, src("path"), literal(path)] = span
            target = prim_address(self.document, path.partition(".")[0])
            self.triples[element, iri(f"{REFERENCE}prim"), target] = _last_step(span, path)
            if len(path) == span.end - span.start:
                self._lead_around(element, path, span)

    def _lead_around(self, element: Term, path: str, span: Span) -> None:
        """State that the steps of *path*, which is written at *span*, lead to prims, too."""
        at = path.find("/", 1)
        while at > 0:
            node = prim_address(self.document, path[:at])
            place = Span(span.start + path.rfind("/", 0, at) + 1, span.start + at)
            self.triples[element, iri(f"{REFERENCE}around"), node] = place
            at = path.find("/", at + 1)

    def _item(self, node: Term, tag: str, item: Value, operation: str, /, **said: str) -> Term:
        """State an item of a list as an element in *node*; none said is an empty list."""
        element = self._element(node, tag, "", NodeSpans(item.span, item.span))
        self.item_of[item] = element
        if operation:
            self.triples[element, iri(f"{_AT}op"), literal(operation)] = item.span
        for key, text in said.items():
            self.triples[element, iri(f"{_AT}{key}"), literal(text)] = item.content
        if not said:
            self.triples[element, src("empty"), _TRUE] = item.span
        return element

    def _property(self, given: Property, node: Term, path: str, *, counts: bool) -> None:
        spans = NodeSpans(given.span, given.name_span)
        tag = "relationship" if given.is_relationship else "attribute"
        if given.suffix == "connect":
            tag = "connection"
        element = self._element(node, tag, given.name, spans)
        if tag == "attribute":
            said = literal(given.type_name)
            self.triples[element, iri(f"{_AT}typeName"), said] = given.type_span
        if given.custom:
            self.triples[element, iri(f"{_AT}custom"), _TRUE] = given.span
        if given.variability:
            said = literal(given.variability)
            self.triples[element, iri(f"{_AT}variability"), said] = given.span
        if given.suffix in ("timeSamples", "spline"):
            said = literal(given.suffix)
            self.triples[element, iri(f"{_AT}sampled"), said] = given.name_span
        if given.value is None:
            return
        self._flaws(node, given.name, relationship_flaws(given))
        if tag != "attribute":
            self._flaws(node, given.name, repeated_items(given.value, path))
            self._targets(element, given.value, given.operation, "target", path)
        elif counts and not given.suffix:
            self._values(node, given.name, given.value, given.type_name)
            if given.value.kind == "asset" and given.value.text:
                file = literal(given.value.text)
                self.triples[element, iri(f"{_AT}asset"), file] = given.value.content

    def _values(self, node: Term, name: str, value: Value, type_name: str) -> None:
        """State the value of an attribute or of metadata *name* of *node*."""
        said, misread = terms(value, type_name)
        flat = value.kind not in ("list", "tuple")
        for number, (term, span) in enumerate(said, 1):
            way = iri(f"{_AT}{name}" if flat else f"{_AT}{name}-{number}")
            self.triples[node, way, term] = span
        self._flaws(node, name, misread or flaws(value, type_name))

    def _flaws(self, node: Term, name: str, found: Iterable[Flaw]) -> None:
        for each in found:
            self.layer.add_node(
                "MalformedValue",
                each.span,
                ("node", node),
                ("attribute", literal(name)),
                ("tag", literal("prim")),
                ("written", literal(each.written)),
                ("expected", literal(each.expected)),
                ("reason", literal(each.reason)),
            )


def _last_step(span: Span, path: str) -> Span:
    """Return the place of the last prim of *path*, which ends at the end of *span*."""
    prim, dot, property_ = path.partition(".")
    end = span.end - len(dot) - len(property_)
    return Span(max(span.start, end - len(prim.rpartition("/")[2])), end)


def _head(prim: Prim) -> Span:
    """Return the place of the specifier."""
    return Span(prim.span.start, prim.span.start + len(prim.specifier))


def listed_values(value: Value) -> list[Value]:
    """Return the items of *value*, which may be one without brackets; none for an empty list."""
    if value.kind in ("list", "tuple"):
        return value.items
    return [] if value.text == "None" and value.kind == "name" else [value]
