"""Split a composed model by domain: structure, relations, their coordinates, dynamics and so on."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from functools import cache

from kinlint.conversion.composition import Composition
from kinlint.conversion.expanded_nodes import Node
from kinlint.conversion.published import published_terms
from kinlint.light_dataclasses import replace
from kinlint.resources import data

FILES = "conversion/files.tsv"
"""Path below shapes/ of the table of contexts and the files that their classes belong to."""


@cache
def _files() -> Mapping[str, str]:
    """Return the file for each context, in the order in which readers expect files."""
    with (data("shapes") / FILES).open(encoding="utf-8", newline="") as stream:
        return {row["context"]: row["file"] for row in csv.DictReader(stream, delimiter="\t")}


def split_by_domain(model: Composition) -> Mapping[str, Composition]:
    """Return *model* in parts by the names of their files, each a graph that is named after it.

    A node with classes of several domains is in the last of them, with its coordinates.
    """
    files = tuple(dict.fromkeys(_files().values()))
    found: dict[str, list[Node]] = {name: [] for name in files}
    for node in model.nodes:
        found[max(map(_file, node["@type"]), key=files.index)].append(node)
    space = next(iter(model.namespaces.values()))
    return {
        name: replace(model, name=space + name, nodes=nodes)
        for name, nodes in found.items()
        if nodes
    }


def _file(class_: str) -> str:
    return _files()[published_terms()[class_].contexts[0]]
