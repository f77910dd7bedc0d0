"""The graph that rules see of models: its layers, its terms, and where nodes are written."""

from __future__ import annotations

import re
from argparse import Namespace
from collections.abc import Iterable, Iterator, Sequence

from kinlint.catalogue.repair_file import prefixes
from kinlint.cli.model_inputs import read_inputs
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.store import Store
from kinlint.findings.locator import Locator
from kinlint.formats.dependencies.companions import pair
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.light_dataclasses import dataclass
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.project.discovery import Found
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri, literal_datatype

LOCAL = re.compile(r"[A-Za-z_](?:[\w-]*\w)?")
"""Local names that need no escapes in Turtle."""


@dataclass(frozen=True)
class ModelGraph:
    """The graph of the models of a run."""

    documents: Sequence[Document]
    """Documents of the run."""
    store: Store
    """Store of all layers."""
    locator: Locator
    """Places of the nodes."""

    def place(self, node: Term) -> str:
        """Return `file:line:column` of *node*; "" if it is not described in a file."""
        found = None if node.startswith('"') else self.locator.node(node)
        return f"{found.source.name}:{found.start.line}:{found.start.column}" if found else ""

    def layer(self, name: str) -> list[Triple]:
        """Return the triples of the layer called *name*, each once, in a fixed order."""
        layers = {
            "lifted": self.store.lifted,
            "closure": self.store.inferred,
            "facts": self.store.facts,
        }
        if name in layers:
            return sorted(set(layers[name]()))
        return list(dict.fromkeys(each for one in self.documents for each in one.statements))


def read_graph(found: Found, settings: Settings, options: Namespace) -> ModelGraph:
    """Return the graph of the models in *found*. Raises `SourceError` for what cannot be read."""
    sources, book = read_inputs(found, settings, options)
    reading = ReadOptions.from_settings(settings)
    texts = pair(sources, settings)
    documents = join_companions([read(each, reading) for each in texts], settings.partner)
    inputs = Inputs(documents, documents, reading.packages_of)
    store = run_stages("facts", Run(book.vocabulary), inputs, Demand.for_everything(book))
    return ModelGraph(documents, store, Locator(documents, store))


class TermWriter:
    """Writes terms with the prefixes that rules have."""

    def __init__(self, base: str = "") -> None:
        """Write IRIs that begin with *base* relative to it."""
        self.base = base
        self.used: dict[str, str] = {}
        self._known = sorted(prefixes().items(), key=lambda each: -len(each[1]))

    def term(self, term: Term) -> str:
        """Return *term* in Turtle."""
        if is_iri(term):
            return self._iri(term[1:-1])
        if term.startswith('"') and (kind := literal_datatype(term)) and "^^<" in term:
            return term[: term.rindex("^^<")] + "^^" + self._iri(kind)
        return term

    def _iri(self, iri: str) -> str:
        for prefix, namespace in self._known:
            if iri.startswith(namespace) and LOCAL.fullmatch(iri[len(namespace) :]):
                self.used[prefix] = namespace
                return f"{prefix}:{iri[len(namespace) :]}"
        if self.base and iri.startswith(self.base + "#"):
            return f"<{iri[len(self.base) :]}>"
        return f"<{iri}>"


def turtle(graph: ModelGraph, layers: Iterable[str]) -> Iterator[str]:
    """Yield *layers* of *graph* as Turtle, with a comment for the place of each node."""
    base = graph.documents[0].graph[1:-1] if len(graph.documents) == 1 else ""
    writer = TermWriter(base)
    body = [each for name in layers for each in _layer(graph, name, writer)]
    if base:
        yield f"@base <{base}> .\n"
    for prefix, namespace in sorted(writer.used.items()):
        yield f"@prefix {prefix}: <{namespace}> .\n"
    yield from body


def _layer(graph: ModelGraph, name: str, writer: TermWriter) -> Iterator[str]:
    """Yield the layer called *name*, subject by subject."""
    about: dict[Term, dict[Term, list[Term]]] = {}
    for s, p, o in graph.layer(name):
        about.setdefault(s, {}).setdefault(p, []).append(o)
    yield f"\n# {name}: {sum(len(o) for said in about.values() for o in said.values())} triples\n"
    for subject, said in about.items():
        place = graph.place(subject)
        yield f"\n{writer.term(subject)}" + (f"  # {place}\n" if place else "\n")
        lines = [
            f"    {'a' if way == RDF_TYPE else writer.term(way)} "
            + ", ".join(writer.term(value) for value in values)
            for way, values in said.items()
        ]
        yield " ;\n".join(lines) + " .\n"
