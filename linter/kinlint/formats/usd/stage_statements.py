"""States what the prims of a stage come to: what is applied, inherited values, and opinions."""

from __future__ import annotations

from kinlint.addresses import child_address, root_of
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.usd.layer_statements import listed_values
from kinlint.formats.usd.stage import Stage, StagePrim
from kinlint.formats.usd.stage_layers import Layers
from kinlint.formats.usd.value_terms import terms
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.vocabulary import ATTRIBUTE, INHERITED

METADATA = {"metersPerUnit": 0.01, "kilogramsPerUnit": 1.0}
"""Numbers of a stage, with those that count where nothing is written."""
UP_AXIS = "Y"
TRUE = literal("true", f"{XSD}boolean")


class StageStatements:
    """Statements about the prims of *stage*, whose root layer has the graph *document*."""

    def __init__(self, stage: Stage, layers: Layers, document: Term) -> None:
        self.stage, self.layers, self.document = stage, layers, document
        self.said = DerivedStatements()
        self.written: dict[Triple, Triple] = {}
        """Inherited values, with the statements that they are written by."""
        self._nodes: dict[StagePrim, Term] = {}

    def node(self, prim: StagePrim) -> Term:
        """Return the node of *prim*."""
        node = self._nodes.get(prim)
        if node is None:
            above = prim.parent
            if above is None:
                node = root_of(self.document)
            else:
                around = self.node(above) if above.parent is not None else f"{self.document[:-1]}#>"
                node = iri(child_address(around[1:-1], "prim", prim.name))
            self._nodes[prim] = node
        return node

    def state(self) -> None:
        """State all prims."""
        root = root_of(self.document)
        for name, usual in METADATA.items():
            self.said.number(root, name, self.stage.number(name, usual))
        self.said.word(root, "upAxis", self.stage.metadata("upAxis") or UP_AXIS)
        for path, prim in self.stage.prims.items():
            if path != "/":
                self._prim(prim)
        for prim in self.stage.defined():
            self.said.state(self.node(prim), "defined", TRUE)

    def _prim(self, prim: StagePrim) -> None:
        node = self.node(prim)
        sources = [layer.node(each) for _, (layer, each) in prim.opinions]
        if sources and sources[0] != node:
            self.said.made_of[node] = next((each for each in sources if each == node), sources[0])
        if sources != [node]:
            for each in sources:
                if each != node:
                    self.said.state(node, "opinion", each)
            self._inherit(prim, node)
        if prim.type_name:
            self.said.word(node, "typeName", prim.type_name)
        for schema in prim.applied:
            self.said.word(node, "applied", schema)

    def _inherit(self, prim: StagePrim, node: Term) -> None:
        """State the values that *prim* has from elsewhere than where its own node is written."""
        seen: set[str] = set()
        for _, (layer, each) in prim.opinions:
            source = layer.node(each)
            for given in each.properties:
                if given.suffix or given.value is None or given.name in seen:
                    continue
                seen.add(given.name)
                if source == node or given.is_relationship:
                    continue
                said, _ = terms(given.value, given.type_name)
                flat = given.value.kind not in ("list", "tuple")
                for number, (term, _) in enumerate(said, 1):
                    name = given.name if flat else f"{given.name}-{number}"
                    way = iri(f"{ATTRIBUTE}{name}")
                    self.written[node, iri(f"{INHERITED}{name}"), term] = (source, way, term)

    def part(self, prim: StagePrim, *names: str) -> Term:
        """Return the first attribute of *names* that *prim* has, else a schema that it applies."""
        for name in names:
            told = prim.told(name)
            if told is not None:
                holder = told.layer.node(told.prim)
                return iri(child_address(holder[1:-1], "attribute", name))
        schemas = (
            layer.item(item)
            for _, (layer, each) in prim.opinions
            for given in each.metadata
            if given.name == "apiSchemas"
            for item in listed_values(given.value)
        )
        return next(schemas, self.node(prim))

    def world(self) -> Term:
        """State the world as a body, and return its node."""
        root = root_of(self.document)
        node = iri(child_address(root[1:-1], "world", None))
        self.said.state(root, "world", node)
        self.said.made_of[node] = root
        return node
