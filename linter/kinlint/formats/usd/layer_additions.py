"""Writes what comes into a text layer: applied schemas, attributes with values, and metadata."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.document import Document
from kinlint.edits import Edit, NotExpressible
from kinlint.formats.usd.layer_opinions import specs
from kinlint.formats.usd.usda_parser import parse
from kinlint.formats.usd.usda_scanner import HEADER
from kinlint.formats.usd.usda_syntax import Field, Prim
from kinlint.formats.usd.value_spelling import assigned
from kinlint.terms import Term, Triple, is_blank, is_literal, literal_value
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE
from kinlint.vocabulary import USD as NAMESPACE

CANNOT = "a layer has no place for what comes"
SCHEMA, PROPERTY = f"<{NAMESPACE}apiSchema>", f"<{NAMESPACE}attribute>"
SCHEMAS = "apiSchemas"
STEP = "    "


class LayerAdditions:
    """Additions to the layer *document*."""

    def __init__(self, document: Document) -> None:
        self.text = document.source.text
        self.nodes = document.map.nodes
        root = parse(document.source)
        self.prims = {prim.name_span: prim for _, prim in specs(root)}
        self.prims[root.name_span] = root

    def edits(self, added: Iterable[Triple]) -> Iterator[Edit]:
        """Yield the edits that state *added*. Raises NotExpressible where there are none."""
        new: dict[Term, dict[str, Term]] = {}
        said: dict[Term, dict[str, Term]] = {}
        made: list[Triple] = []
        for triple in added:
            node, way, value = triple
            if not is_literal(value):
                made.append(triple)
                continue
            name = way[1:-1].removeprefix(ATTRIBUTE)
            (new if is_blank(node) else said).setdefault(node, {})[name] = value
        for node, way, value in made:
            prim, parts = self._prim(node), new.pop(value, {})
            if way == SCHEMA:
                yield self._schema(prim, parts)
            elif way == PROPERTY and "name" in parts and "typeName" in parts:
                name = literal_value(parts["name"])
                own = said.get(node, {}).pop(name, None)
                yield self._attribute(prim, literal_value(parts["typeName"]), name, own)
            else:
                raise NotExpressible(CANNOT)
        if new:
            raise NotExpressible(CANNOT)
        for node, values in said.items():
            for name, value in values.items():
                prim = self._prim(node)
                if ":" in name or prim.field(name) is not None:
                    raise NotExpressible(CANNOT)
                yield self._metadata(prim, f"{name} = {assigned(value)}")

    def _prim(self, node: Term) -> Prim:
        """Return the prim, or the layer, that is *node*."""
        spans = self.nodes.get(node)
        prim = self.prims.get(spans.best) if spans is not None else None
        if prim is None:
            raise NotExpressible("it is written in another layer")
        return prim

    def _schema(self, prim: Prim, parts: dict[str, Term]) -> Edit:
        """Return what applies a schema: the last of its list, or a list."""
        name = assigned(parts["value"])
        operation = literal_value(parts["op"]) if "op" in parts else ""
        lists = [e for e in prim.metadata if e.name == SCHEMAS and e.operation == operation]
        if not lists:
            return self._metadata(prim, f"{operation} {SCHEMAS} = [{name}]".strip())
        value = lists[-1].value
        if value.kind != "list" or not value.items:
            raise NotExpressible(CANNOT)
        return _insertion(value.items[-1].span.end, f", {name}")

    def _attribute(self, prim: Prim, type_name: str, name: str, value: Term | None) -> Edit:
        if not prim.properties or value is None or prim.specifier == "":
            raise NotExpressible(CANNOT)
        at = prim.properties[0].span.start
        return _insertion(at, f"{type_name} {name} = {assigned(value)}\n{self._indent(at)}")

    def _metadata(self, prim: Prim, statement: str) -> Edit:
        if prim.metadata:
            last = max(prim.metadata, key=_end)
            return _insertion(_end(last), f"\n{self._indent(last.name_span.start)}{statement}")
        if prim.specifier:
            at, indent = prim.name_span.end, self._indent(prim.span.start)
            return _insertion(at, f" (\n{indent}{STEP}{statement}\n{indent})")
        header = HEADER.match(self.text)
        at = header.end() if header is not None else 0
        return _insertion(at, f"\n(\n{STEP}{statement}\n)")

    def _indent(self, at: int) -> str:
        """Return the blanks that the line at *at* begins with."""
        line = self.text[self.text.rfind("\n", 0, at) + 1 : at]
        return line[: len(line) - len(line.lstrip())]


def _end(field: Field) -> int:
    """Return the end of *field*, with what stands in parentheses behind its value."""
    return max([field.value.span.end, *(_end(each) for each in field.value.fields)])


def _insertion(at: int, text: str) -> Edit:
    return Edit(Span(at, at), text)
