"""Rule files as plain SHACL, for any engine: completed, with the prefixes of their SPARQL."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pyoxigraph as ox

from kinlint import resources
from kinlint.engine.compiler.shapes_graph import read
from kinlint.terms import iri
from kinlint.vocabulary import KL

EXAMPLE = iri(f"{KL}example")


def shacl(files: Iterable[Path]) -> str:
    """Return the shapes of rule *files*, without examples, as Turtle that needs no other file."""
    graph = read([resources.data("shapes") / "prefixes.ttl", *files])
    prefixes: dict[str, str] = {}
    for file in reversed(graph.files):
        prefixes |= file.prefixes
    examples = {s for each in graph.files for _, way, s in each.triples if way == EXAMPLE}
    triples = (triple for file in graph.files for triple in file.triples)
    kept = (each for each in triples if each[0] not in examples and each[1] != EXAMPLE)
    lines = map(" ".join, kept)
    text = "".join(f"{line} .\n" for line in lines)
    quads = ox.parse(text, ox.RdfFormat.N_TRIPLES)
    written = ox.serialize((q.triple for q in quads), format=ox.RdfFormat.TURTLE, prefixes=prefixes)
    assert written is not None
    return written.decode()
