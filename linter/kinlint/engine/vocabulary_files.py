"""Files of the vocabulary: loaded from disk for the first model of a process, then from memory."""

from __future__ import annotations

from pathlib import Path
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.errors import RuleInvalid

_Version: TypeAlias = tuple[Path, ox.NamedNode, int, int]

_LOADED: dict[_Version, list[ox.Quad] | None] = {}
"""The statements of each version of a file; None until a second model needs them."""


def load_turtle(store: ox.Store, file: Path, graph: ox.NamedNode) -> None:
    """Add what the Turtle *file* says to *graph* of *store*.

    Its blank nodes are those of no other file. Raises `RuleInvalid` where it is no Turtle.
    """
    status = file.stat()
    version = file, graph, status.st_mtime_ns, status.st_size
    turtle, base = ox.RdfFormat.TURTLE, file.absolute().as_uri()
    try:
        if version not in _LOADED:
            store.load(path=file, format=turtle, base_iri=base, to_graph=graph)
            _LOADED[version] = None
            return
        if (quads := _LOADED[version]) is None:
            triples = ox.parse(path=file, format=turtle, base_iri=base, rename_blank_nodes=True)
            quads = [ox.Quad(each.subject, each.predicate, each.object, graph) for each in triples]
            _LOADED[version] = quads
        store.extend(quads)
    except SyntaxError as error:
        raise RuleInvalid(f"{file}:{error.lineno}: {error.msg}") from error
